#include "ui/panels/window/widgets.h"

#include <imgui_internal.h>

#include <algorithm>

#include "ui/panels/window/layout.h"
#include "ui/panels/window/panels.h"

namespace hazumi::ui {

// As long as the mouse only passes by, nothing is explained.
double SecondsToTooltip() {
  constexpr double kDelay = 0.4;  // [s]
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.HoveredId == 0) return -kDelay;  // nothing that could be pressed
  return kDelay - context.HoveredIdTimer;
}

bool BeginPanel(const char* name, const Rect& rect, const SrgbColor& background) {
  ImGui::SetNextWindowPos({rect.x, rect.y});
  ImGui::SetNextWindowSize({rect.w, rect.h});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ToIm4(background));
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
      ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
  return ImGui::Begin(name, nullptr, kFlags);
}

void EndPanel() {
  ImGui::End();
  ImGui::PopStyleColor();
}

namespace {

constexpr float kTooltipWidth = 24.0f;  // at most [sizes of the font]

// The panel, menu or dialog that is drawn on, with all that lies in it.
Rect WindowAround() {
  const ImGuiWindow* window = ImGui::GetCurrentWindow();
  while ((window->Flags & ImGuiWindowFlags_ChildWindow) != 0 &&
         (window->Flags & ImGuiWindowFlags_Popup) == 0 && window->ParentWindow) {
    window = window->ParentWindow;
  }
  return {window->Pos.x, window->Pos.y, window->Size.x, window->Size.y};
}

double ScaleNow() { return ImGui::GetFontSize() / 15.0; }

// Panels may have none of their own.
ImVec2 TooltipPadding() {
  const auto scale = static_cast<float>(ScaleNow());
  return {8.0f * scale, 6.0f * scale};
}

Point SizeOf(const std::string& text, const std::string& key) {
  const ImVec2 padding = TooltipPadding();
  const float width = kTooltipWidth * ImGui::GetFontSize() - padding.x;
  const ImVec2 all = ImGui::CalcTextSize(text.c_str(), nullptr, false, width);
  Point size = {all.x, all.y};
  if (!key.empty()) {
    const ImVec2 below = ImGui::CalcTextSize(key.c_str(), nullptr, false, width);
    size = {std::max(size.x, below.x), size.y + ImGui::GetStyle().ItemSpacing.y + below.y};
  }
  return {size.x + 2.0f * padding.x, size.y + 2.0f * padding.y};
}

}  // namespace

void Tooltip(const std::string& text, const std::string& key, bool even_disabled) {
  const ImGuiHoveredFlags flags = even_disabled ? ImGuiHoveredFlags_AllowWhenDisabled : 0;
  if (text.empty() || !ImGui::IsItemHovered(flags) || SecondsToTooltip() > 0.0) return;
  const ImVec2 min = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
  TooltipOf({min.x, min.y, size.x, size.y}, text, key);
}

void TooltipOf(const Rect& item, const std::string& text, const std::string& key) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const Point at = TooltipPlace(item, WindowAround(), FromIm(ImGui::GetIO().MousePos),
                                SizeOf(text, key), {0.0f, 0.0f, screen.x, screen.y}, ScaleNow());
  ImGui::SetNextWindowPos(ToIm(at));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, TooltipPadding());
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * kTooltipWidth);
  ImGui::TextUnformatted(text.c_str());
  if (!key.empty()) ImGui::TextDisabled("%s", key.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

std::vector<Chord> PressedKeys(bool with_repeats) {
  const ImGuiIO& io = ImGui::GetIO();
  std::vector<Chord> chords;
  for (int key = kSpace; key < kLeftShift; ++key) {  // what GLFW numbers keys by, modifiers aside
    const bool is_letter = key >= 'A' && key <= 'Z';
    if (ImGui::IsKeyPressed(key, with_repeats && !is_letter)) {
      chords.push_back({key, io.KeyCtrl, io.KeyShift, io.KeyAlt});
    }
  }
  return chords;
}

void ApplyTheme(const Theme& theme, double scale) {
  ImGuiStyle style;
  style.WindowRounding = 0.0f;
  style.WindowBorderSize = 0.0f;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 4.0f;
  style.FramePadding = {6.0f, 3.0f};
  style.ItemSpacing = {6.0f, 4.0f};
  style.WindowPadding = {8.0f, 6.0f};
  style.ScrollbarSize = 11.0f;
  style.ScaleAllSizes(static_cast<float>(scale));
  ImVec4* colors = style.Colors;
  const ImVec4 accent = ToIm4(theme.accent), field = ToIm4(theme.field);
  const ImVec4 hovered = ToIm4(theme.field_hovered), header = ToIm4(theme.header);
  colors[ImGuiCol_Text] = ToIm4(theme.text);
  colors[ImGuiCol_TextDisabled] = ToIm4(theme.faint_text);
  colors[ImGuiCol_WindowBg] = colors[ImGuiCol_ChildBg] = ToIm4(theme.panel);
  colors[ImGuiCol_ChildBg].w = 0.0f;
  colors[ImGuiCol_PopupBg] = header;
  colors[ImGuiCol_Border] = ToIm4(theme.line);
  colors[ImGuiCol_FrameBg] = field;
  colors[ImGuiCol_FrameBgHovered] = hovered;
  colors[ImGuiCol_FrameBgActive] = hovered;
  colors[ImGuiCol_Button] = field;
  colors[ImGuiCol_ButtonHovered] = hovered;
  colors[ImGuiCol_ButtonActive] = accent;
  colors[ImGuiCol_Header] = accent;
  colors[ImGuiCol_HeaderHovered] = hovered;
  colors[ImGuiCol_HeaderActive] = accent;
  colors[ImGuiCol_CheckMark] = colors[ImGuiCol_SliderGrab] = accent;
  colors[ImGuiCol_SliderGrabActive] = accent;
  colors[ImGuiCol_PlotHistogram] = accent;
  colors[ImGuiCol_NavHighlight] = accent;
  colors[ImGuiCol_Separator] = ToIm4(theme.line);
  colors[ImGuiCol_ScrollbarBg] = ToIm4(theme.panel);
  colors[ImGuiCol_ScrollbarGrab] = field;
  colors[ImGuiCol_ScrollbarGrabHovered] = colors[ImGuiCol_ScrollbarGrabActive] = hovered;
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = header;
  colors[ImGuiCol_MenuBarBg] = header;
  colors[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.45f};
  ImGui::GetStyle() = style;
}

}  // namespace hazumi::ui
