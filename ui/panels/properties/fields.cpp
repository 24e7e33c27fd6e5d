// Fields of the properties.

#include "ui/panels/properties/fields.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/panels/properties/layout.h"
#include "ui/panels/text/number_text.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

// Draws the label, leaves the cursor at the field, and tells where its parts are.
RowParts BeginRow(Editor* editor, const std::string& label, bool has_button) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect row = {at.x, at.y, ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight()};
  const ImVec2 size = ImGui::CalcTextSize(label.c_str());
  const RowParts parts = PartsOfRow(row, size.x, has_button, editor->settings.scale);
  const Rect& place = parts.label;
  const bool is_above = place.y < parts.field.y;
  const float x = is_above ? place.x : std::max(place.x, place.right() - size.x);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect({place.x, place.y}, {place.right(), place.bottom()}, true);
  list->AddText({x, place.y + 0.5f * (place.h - size.y)}, ToIm(editor->theme().text, 0.85f),
                label.c_str());
  list->PopClipRect();
  ImGui::SetCursorScreenPos({parts.field.x, parts.field.y});
  ImGui::SetNextItemWidth(parts.field.w);
  return parts;
}

std::string DragName(const SideState& side) { return "properties " + std::to_string(side.drags); }

SrgbColor ColorOf(FieldState state, const Theme& theme) {
  switch (state) {
    case FieldState::kKeyed:
      return colors::kKeyed;
    case FieldState::kInterpolated:
      return colors::kInterpolated;
    case FieldState::kChanged:
      return colors::kChanged;
    case FieldState::kPlain:
    case FieldState::kComputed:
      break;
  }
  return theme.field;
}

// The colours of a field; light ones are written on in black.
class FieldColors {
 public:
  FieldColors(FieldState state, const Theme& theme, bool is_slider) {
    const bool is_plain = state == FieldState::kPlain;
    ImVec4 color = ToIm4(ColorOf(state, theme));
    ImVec4 hovered = is_plain ? ToIm4(theme.field_hovered) : color;
    if (!is_plain) hovered.x *= 1.1f, hovered.y *= 1.1f, hovered.z *= 1.1f;
    if (is_slider) color.w = 0.0f, hovered.w = 0.15f;
    ImGui::PushStyleColor(ImGuiCol_FrameBg, color);
    ImGui::PushStyleColor(ImGuiCol_FrameBgHovered, hovered);
    ImGui::PushStyleColor(ImGuiCol_FrameBgActive, hovered);
    ImGui::PushStyleColor(ImGuiCol_Text,
                          is_plain ? ToIm4(theme.text) : ToIm4(render::FromHex(0x101010)));
  }
  ~FieldColors() { ImGui::PopStyleColor(4); }
};

// What the field says: 0 where that would be "-0.0".
double Shown(const NumberField& field) {
  return WithoutMinusZero(field.value, ImParseFormatPrecision(field.format, 3));
}

// A number that a region computes: hatched, and not to be changed.
void DrawComputed(Editor* editor, const NumberField& field, const Rect& rect) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float round = ImGui::GetStyle().FrameRounding;
  const ImVec2 low(rect.x, rect.y), high(rect.right(), rect.bottom());
  list->AddRectFilled(low, high, ToIm(editor->theme().row), round);
  DrawHatch(list, rect, ToIm(colors::kDynamics, 0.45f));
  list->AddRect(low, high, ToIm(colors::kDynamics, 0.8f), round);
  char text[64];
  std::snprintf(text, sizeof text, field.format, Shown(field));
  const ImVec2 size = ImGui::CalcTextSize(text);
  list->AddText({rect.x + 0.5f * (rect.w - size.x), rect.y + 0.5f * (rect.h - size.y)},
                ToIm(editor->theme().text), text);
  ImGui::InvisibleButton(field.id.c_str(), {rect.w, rect.h});
  Tooltip(Tr("A dynamics region computes this value here. Key it outside of the region."));
}

void FillSlider(const NumberField& field, const Rect& rect, const Theme& theme) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float round = ImGui::GetStyle().FrameRounding;
  const double share = (field.value - field.lower) / (field.upper - field.lower);
  const float right = rect.x + rect.w * static_cast<float>(std::clamp(share, 0.0, 1.0));
  list->AddRectFilled({rect.x, rect.y}, {rect.right(), rect.bottom()}, ToIm(theme.field), round);
  if (right > rect.x + 1.0f) {
    list->AddRectFilled({rect.x, rect.y}, {right, rect.bottom()}, ToIm(theme.accent), round);
  }
}

// What becomes of a drag, or of a number that was typed, when the field is let go.
void LetGo(Editor* editor, unsigned id, const SubmitNumber& submit) {
  SideState& side = editor->side;
  if (side.typed && side.typed->id == id) {
    const double value = side.typed->value;
    side.typed.reset();
    if (!ImGui::IsKeyPressed(kEscape, false)) submit(value, DragName(side));
  }
  editor->Do("edit.end_drag");
}

void Follow(Editor* editor, unsigned id, bool is_changed, bool is_typed, double value,
            const SubmitNumber& submit) {
  SideState& side = editor->side;
  if (ImGui::IsItemActivated()) ++side.drags;
  if (is_changed && is_typed) side.typed = TypedField{id, value};
  if (is_changed && !is_typed) submit(value, DragName(side));
  const bool wants_back = ImGui::IsKeyPressed(kEscape, false) || ImGui::IsMouseClicked(1);
  if (ImGui::IsItemActive() && !is_typed && wants_back) {
    editor->Do("edit.cancel_drag");
    ImGui::ClearActiveID();
  } else if (ImGui::IsItemDeactivated()) {
    LetGo(editor, id, submit);
  }
}

bool DrawKeyButton(const NumberField& field, const Rect& rect, const Theme& theme) {
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  const bool is_clicked = ImGui::InvisibleButton((field.id + " key").c_str(), {rect.w, rect.h});
  const bool is_keyed = field.state == FieldState::kKeyed || field.state == FieldState::kChanged;
  Tooltip(Tr(is_keyed ? "Takes the key on this frame away." : "Keys this value on this frame."));
  const bool is_hovered = ImGui::IsItemHovered();
  const SrgbColor color = is_keyed ? colors::kKeyed : is_hovered ? theme.text : theme.faint_text;
  DrawDiamond(ImGui::GetWindowDrawList(), {rect.x + 0.5f * rect.w, rect.y + 0.5f * rect.h},
              0.24f * rect.h, ToIm(color), is_keyed);
  return is_clicked;
}

}  // namespace

bool DrawHeading(const char* title, bool is_open_at_first) {
  ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
  ImGui::PushStyleColor(ImGuiCol_HeaderActive, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
  const bool is_open = ImGui::CollapsingHeader(
      title, is_open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
  ImGui::PopStyleColor(2);
  return is_open;
}

void DrawNote(const std::string& text) {
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextDisabled("%s", text.c_str());
  ImGui::PopTextWrapPos();
}

bool DrawNumber(Editor* editor, const NumberField& field, const SubmitNumber& submit) {
  const RowParts parts = BeginRow(editor, field.label, field.has_key_button);
  if (field.state == FieldState::kComputed) {
    DrawComputed(editor, field, parts.field);
    return false;
  }
  if (field.is_slider) FillSlider(field, parts.field, editor->theme());
  const FieldColors with_colors(field.state, editor->theme(), field.is_slider);
  const std::string name = "##" + field.id;
  const ImGuiID id = ImGui::GetID(name.c_str());
  const std::optional<TypedField>& typed = editor->side.typed;
  double speed = field.is_slider ? (field.upper - field.lower) / parts.field.w : field.speed;
  if (ImGui::GetIO().KeyShift) speed *= 0.01;  // ImGui makes it ten times as fast
  const bool was_typed = ImGui::TempInputIsActive(id);
  double value = was_typed && typed && typed->id == id ? typed->value : Shown(field);
  const bool is_changed =
      ImGui::DragScalar(name.c_str(), ImGuiDataType_Double, &value, static_cast<float>(speed),
                        &field.lower, &field.upper, field.format);
  const bool is_typed = was_typed || ImGui::TempInputIsActive(id);
  Follow(editor, id, is_changed, is_typed, value, submit);
  return field.has_key_button && DrawKeyButton(field, parts.button, editor->theme());
}

void DrawInteger(Editor* editor, const std::string& id, const std::string& label, int value,
                 const std::function<void(int value, const std::string& drag)>& submit) {
  NumberField field{id, label, static_cast<double>(value), "%.0f", 0.2};
  DrawNumber(editor, field, [&](double wanted, const std::string& drag) {
    const int whole = static_cast<int>(std::lround(wanted));
    if (whole != value) submit(whole, drag);
  });
}

void DrawVector(
    Editor* editor, const std::string& label, const Vec3& value, const char* format,
    const std::function<void(int axis, double value, const std::string& drag)>& submit) {
  const char* axes[] = {"X", "Y", "Z"};
  for (int i = 0; i < 3; ++i) {
    const std::string name = i == 0 ? label + "  " + axes[i] : axes[i];
    DrawNumber(editor, {label + axes[i], name, value[i], format},
               [&](double wanted, const std::string& drag) { submit(i, wanted, drag); });
  }
}

void DrawText(Editor* editor, const std::string& id, const std::string& label,
              const std::string& value, const SubmitText& submit) {
  BeginRow(editor, label, false);
  std::string text = value;
  const bool is_entered =
      ImGui::InputText(("##" + id).c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue);
  if (is_entered && text != value) submit(text);
}

void DrawChoice(Editor* editor, const std::string& id, const std::string& label,
                const std::vector<std::string>& names, const std::string& now,
                const SubmitText& submit) {
  BeginRow(editor, label, false);
  if (!ImGui::BeginCombo(("##" + id).c_str(), Tr(now.c_str()))) return;
  for (const std::string& name : names) {
    const bool is_now = name == now;
    if (ImGui::Selectable(Tr(name.c_str()), is_now) && !is_now) submit(name);
  }
  ImGui::EndCombo();
}

void DrawCheck(Editor* editor, const std::string& id, const std::string& label, bool value,
               const std::function<void(bool)>& submit) {
  BeginRow(editor, label, false);
  if (ImGui::Checkbox(("##" + id).c_str(), &value)) submit(value);
}

void DrawColor(
    Editor* editor, const std::string& id, const std::string& label, const std::string& value,
    const std::function<void(const std::string& value, const std::string& drag)>& submit) {
  BeginRow(editor, label, false);
  unsigned rgb = 0x808080;
  std::sscanf(value.c_str(), "#%x", &rgb);
  float parts[3] = {};
  for (int i = 0; i < 3; ++i) {
    parts[i] = static_cast<float>((rgb >> (16 - 8 * i)) & 0xffu) / 255.0f;
  }
  constexpr int kFlags = ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_DisplayHex;
  const bool is_changed = ImGui::ColorEdit3(("##" + id).c_str(), parts, kFlags);
  if (ImGui::IsItemActivated()) ++editor->side.drags;
  if (is_changed) {
    char text[8];
    const auto byte = [&](int i) { return static_cast<unsigned>(std::lround(255.0f * parts[i])); };
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(0) & 0xffu, byte(1) & 0xffu,
                  byte(2) & 0xffu);
    submit(text, DragName(editor->side));
  }
  if (ImGui::IsItemDeactivated()) editor->Do("edit.end_drag");
}

void DrawFact(Editor* editor, const std::string& label, const std::string& text) {
  const RowParts parts = BeginRow(editor, label, false);
  ImGui::AlignTextToFramePadding();
  ImGui::PushTextWrapPos(parts.field.right() - ImGui::GetWindowPos().x);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

namespace {

// On as many lines as it needs.
std::string Wrapped(const char* text, float width) {
  std::string lines;
  const char* end = text + std::strlen(text);
  while (text < end) {
    const char* rest = ImGui::GetFont()->CalcWordWrapPositionA(1.0f, text, end, width);
    lines.append(text, std::max(rest, text + 1));
    text = std::max(rest, text + 1);
    while (*text == ' ') ++text;
    if (text < end) lines += '\n';
  }
  return lines;
}

}  // namespace

bool DrawButton(const char* label, const char* help, int share) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float gap = style.ItemSpacing.x;
  const float room = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
  const auto count = static_cast<float>(share);
  const float text = 1.0f + ImGui::CalcTextSize(label).x + 2.0f * style.FramePadding.x;
  const float width = std::max((room - gap * (count - 1.0f)) / count, std::min(text, room));
  if (std::floor(width) > std::ceil(ImGui::GetContentRegionAvail().x)) ImGui::NewLine();
  const bool is_clicked =
      ImGui::Button(Wrapped(label, width - 2.0f * style.FramePadding.x).c_str(), {width, 0.0f});
  Tooltip(help);
  return is_clicked;
}

}  // namespace hazumi::ui
