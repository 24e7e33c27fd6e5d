#include <algorithm>
#include <cmath>

#include "ui/panels/sheet/drawing.h"

namespace hazumi::ui {

namespace {

constexpr ImU32 kOutline = IM_COL32(16, 16, 16, 230);

void Diamond(ImDrawList* list, ImVec2 c, float r, ImU32 color) {
  list->AddQuadFilled({c.x, c.y - r}, {c.x + r, c.y}, {c.x, c.y + r}, {c.x - r, c.y}, color);
}

// One layer of a key's mark.
void Shape(ImDrawList* list, ImVec2 c, float r, std::optional<Interpolation> kind, ImU32 color) {
  switch (kind.value_or(Interpolation::kCubic)) {
    case Interpolation::kCubic:
      return Diamond(list, c, 1.15f * r, color);
    case Interpolation::kLinear:
      return list->AddCircleFilled(c, 0.95f * r, color, 16);
    case Interpolation::kHold:
      return list->AddRectFilled({c.x - 0.85f * r, c.y - 0.85f * r},
                                 {c.x + 0.85f * r, c.y + 0.85f * r}, color);
    case Interpolation::kLeastAcceleration:
    case Interpolation::kLeastJerk:
      Diamond(list, c, 1.15f * r, color);
      return list->AddCircleFilled(c, 0.8f * r, color, 16);
    case Interpolation::kQuadratic:
      return list->AddTriangleFilled({c.x, c.y - 1.1f * r}, {c.x + 1.05f * r, c.y + 0.8f * r},
                                     {c.x - 1.05f * r, c.y + 0.8f * r}, color);
    default:
      return list->AddNgonFilled(c, 1.1f * r, color, 6);
  }
}

SrgbColor ColorOf(KeyType type) {
  switch (type) {
    case KeyType::kBreakdown:
      return colors::kBreakdown;
    case KeyType::kExtreme:
      return colors::kExtreme;
    case KeyType::kJitter:
      return colors::kJitter;
    case KeyType::kMovingHold:
      return colors::kMovingHold;
    case KeyType::kGenerated:
      return colors::kGenerated;
    case KeyType::kKeyframe:
      break;
  }
  return colors::kKey;
}

}  // namespace

void DrawKey(ImDrawList* list, Point at, float radius, const KeyLook& look) {
  const ImVec2 c = ToIm(at);
  if (look.type == KeyType::kGenerated) radius *= 0.6f;
  Shape(list, c, radius + 1.2f, look.kind, kOutline);
  Shape(list, c, radius, look.kind,
        ToIm(look.is_selected ? colors::kSelected : ColorOf(look.type)));
  if (!look.kind) Diamond(list, c, 0.5f * radius, kOutline);
}

void DrawHatch(ImDrawList* list, const Rect& rect, const Rect& clip, ImU32 color, float step) {
  list->PushClipRect({std::max(rect.x, clip.x), std::max(rect.y, clip.y)},
                     {std::min(rect.right(), clip.right()), std::min(rect.bottom(), clip.bottom())},
                     true);
  // The lines belong to the window, so that they stand still while a bar is drawn longer.
  const float left = std::max(rect.x, clip.x), right = std::min(rect.right(), clip.right());
  const float begin = std::floor((left - rect.h) / step) * step;
  for (float x = begin; x < right; x += step) {
    list->AddLine({x, rect.bottom()}, {x + rect.h, rect.y}, color, 1.5f);
  }
  list->PopClipRect();
}

void DrawLabel(ImDrawList* list, const Rect& rect, const std::string& text, ImU32 color) {
  // A low rectangle leaves letters whole, and underscores below them.
  const float high = ImGui::GetFontSize(), y = std::round(rect.y + 0.5f * (rect.h - high));
  list->PushClipRect({rect.x, std::min(rect.y, y)},
                     {rect.right(), std::max(rect.bottom(), y + 1.15f * high)}, true);
  list->AddText({rect.x, y}, color, text.c_str());
  list->PopClipRect();
}

void DrawCornerToggle(ImDrawList* list, const Editor& editor, const Rect& corner,
                      const std::string& text, bool is_on) {
  const Theme& theme = editor.theme();
  const auto s = static_cast<float>(editor.settings.scale);
  list->AddRectFilled(UpperLeft(corner), LowerRight(corner), ToIm(theme.header));
  const float side = 11.0f * s, x = corner.x + 8.0f * s;
  const float y = std::round(corner.y + 0.5f * (24.0f * s - side));
  list->AddRectFilled({x, y}, {x + side, y + side}, ToIm(is_on ? theme.accent : theme.field), 2.0f);
  if (is_on) {
    const ImVec2 tick[] = {{x + 0.2f * side, y + 0.5f * side},
                           {x + 0.42f * side, y + 0.75f * side},
                           {x + 0.82f * side, y + 0.22f * side}};
    list->AddPolyline(tick, 3, IM_COL32_WHITE, 0, 1.6f * s);
  }
  const Rect label = {x + side + 6.0f * s, corner.y, corner.right() - x - side - 8.0f * s,
                      24.0f * s};
  DrawLabel(list, label, text, ToIm(theme.text));
}

}  // namespace hazumi::ui
