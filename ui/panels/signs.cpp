#include "ui/panels/signs.h"

#include <algorithm>

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

}  // namespace hazumi::ui
