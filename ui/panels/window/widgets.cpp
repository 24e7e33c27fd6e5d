#include "ui/panels/window/widgets.h"

#include <imgui_internal.h>

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

void Tooltip(const std::string& text, const std::string& key) {
  if (text.empty() || !ImGui::IsItemHovered() || SecondsToTooltip() > 0.0) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
  ImGui::TextUnformatted(text.c_str());
  if (!key.empty()) ImGui::TextDisabled("%s", key.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
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
