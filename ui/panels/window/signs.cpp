#include <algorithm>

#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

void DrawHatch(ImDrawList* list, const Rect& rect, ImU32 color) {
  list->PushClipRect({rect.x, rect.y}, {rect.right(), rect.bottom()}, true);
  const float step = std::max(3.0f, 0.3f * rect.h);
  for (float x = rect.x - rect.h; x < rect.right(); x += step) {
    list->AddLine({x, rect.bottom()}, {x + rect.h, rect.y}, color, 1.0f);
  }
  list->PopClipRect();
}

void DrawDiamond(ImDrawList* list, Point c, float r, ImU32 color, bool is_filled) {
  const ImVec2 top(c.x, c.y - r), right(c.x + r, c.y), bottom(c.x, c.y + r), left(c.x - r, c.y);
  if (is_filled) {
    list->AddQuadFilled(top, right, bottom, left, color);
  } else {
    list->AddQuad(top, right, bottom, left, color, 1.2f);
  }
}

void DrawDot(ImDrawList* list, Point center, float radius, ImU32 color) {
  list->AddCircleFilled(ToIm(center), radius, color);
}

void DrawTriangle(ImDrawList* list, Point c, float r, ImU32 color, bool is_open) {
  if (is_open) {
    list->AddTriangleFilled({c.x - r, c.y - 0.6f * r}, {c.x + r, c.y - 0.6f * r},
                            {c.x, c.y + 0.8f * r}, color);
  } else {
    list->AddTriangleFilled({c.x - 0.6f * r, c.y - r}, {c.x + 0.8f * r, c.y},
                            {c.x - 0.6f * r, c.y + r}, color);
  }
}

void DrawEye(ImDrawList* list, Point c, float r, ImU32 color, bool is_open) {
  const auto lid = [&](float bend) {
    list->AddBezierQuadratic({c.x - r, c.y}, {c.x, c.y + 1.4f * bend * r}, {c.x + r, c.y}, color,
                             1.2f);
  };
  lid(1.0f);
  if (!is_open) return;
  lid(-1.0f);
  list->AddCircleFilled(ToIm(c), 0.36f * r, color);
}

void DrawLock(ImDrawList* list, Point c, float r, ImU32 color, bool is_locked) {
  const float top = c.y - 0.1f * r, bow = 0.5f * r;
  list->AddRectFilled({c.x - 0.8f * r, top}, {c.x + 0.8f * r, c.y + 0.95f * r}, color, 1.0f);
  const float left = is_locked ? c.x - bow : c.x;  // an open bow stands beside
  list->PathLineTo({left, top});
  list->PathArcTo({left + bow, top - 0.35f * r}, bow, 3.1416f, 6.2832f, 10);
  if (is_locked) list->PathLineTo({left + 2.0f * bow, top});
  list->PathStroke(color, 0, 1.3f);
}

}  // namespace hazumi::ui
