#include "ui/panels/dope_sheet/muscle_draw.h"

#include <numbers>

namespace hazumi::ui {

namespace {

constexpr float kThick = 1.3f;  // [px]

void DrawPendulum(ImDrawList* list, const ImVec2& c, float r, ImU32 color) {
  const ImVec2 bob = {c.x + 0.5f * r, c.y + 0.55f * r};
  list->AddLine({c.x - 0.6f * r, c.y - r}, {c.x + 0.6f * r, c.y - r}, color, kThick);
  list->AddLine({c.x - 0.1f * r, c.y - r}, bob, color, kThick);
  list->AddCircleFilled(bob, 0.4f * r, color, 12);
}

void DrawTurn(ImDrawList* list, const ImVec2& c, float r, ImU32 color) {
  constexpr auto kPi = std::numbers::pi_v<float>;
  list->PathArcTo(c, 0.8f * r, -0.25f * kPi, 1.25f * kPi, 14);
  list->PathStroke(color, 0, kThick);
  const ImVec2 end = {c.x - 0.57f * r, c.y - 0.57f * r};
  list->AddTriangleFilled({end.x + 0.75f * r, end.y - 0.3f * r},
                          {end.x - 0.35f * r, end.y - 0.35f * r},
                          {end.x + 0.25f * r, end.y + 0.6f * r}, color);
}

void DrawZigzag(ImDrawList* list, const ImVec2& c, float r, ImU32 color) {
  constexpr int kCorners = 6;
  ImVec2 corners[kCorners];
  for (int i = 0; i < kCorners; ++i) {
    const float side = i == 0 || i == kCorners - 1 ? 0.0f : i % 2 ? -0.7f : 0.7f;
    corners[i] = {c.x - r + 2.0f * r * static_cast<float>(i) / (kCorners - 1), c.y + side * r};
  }
  list->AddPolyline(corners, kCorners, color, 0, kThick);
}

}  // namespace

void DrawMuscleMark(ImDrawList* list, Point center, float radius, Muscle kind, ImU32 color) {
  const ImVec2 c = {center.x, center.y};
  switch (kind) {
    case Muscle::kLoose:
      return DrawPendulum(list, c, radius, color);
    case Muscle::kTorque:
      return DrawTurn(list, c, radius, color);
    case Muscle::kSpring:
      return DrawZigzag(list, c, radius, color);
    case Muscle::kKeys:
      return list->AddQuad({c.x, c.y - radius}, {c.x + radius, c.y}, {c.x, c.y + radius},
                           {c.x - radius, c.y}, color, kThick);
    case Muscle::kMixed:
      break;
  }
  for (const float x : {-0.7f, 0.0f, 0.7f}) {
    list->AddCircleFilled({c.x + x * radius, c.y}, 0.25f * radius, color, 8);
  }
}

}  // namespace hazumi::ui
