#include <algorithm>
#include <cmath>

#include "ui/panels/viewport/marks.h"

namespace hazumi::ui {

void DrawArrow(Point from, Point to, ImU32 color, float width) {
  const float dx = to.x - from.x, dy = to.y - from.y;
  const float length = std::max(1.0f, std::hypot(dx, dy));
  const float head = std::min(5.0f * width, length);
  const float ux = dx / length, uy = dy / length;
  const ImVec2 base = {to.x - head * ux, to.y - head * uy};
  Canvas()->AddLine(ToIm(from), base, color, width);
  Canvas()->AddTriangleFilled(ToIm(to), {base.x - 0.5f * head * uy, base.y + 0.5f * head * ux},
                              {base.x + 0.5f * head * uy, base.y - 0.5f * head * ux}, color);
}

void DrawDashedLine(Point from, Point to, ImU32 color, float width) {
  const float dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  const float dash = 4.0f * width;
  constexpr int kMostDashes = 500;  // of a line that runs far out of the window
  int num = 0;
  for (float at = 0.0f; at < length && num < kMostDashes; at += 1.7f * dash, ++num) {
    const float a = at / length, b = std::min(at + dash, length) / length;
    Canvas()->AddLine({from.x + a * dx, from.y + a * dy}, {from.x + b * dx, from.y + b * dy}, color,
                      width);
  }
}

void DrawShadedText(const ImVec2& at, const char* text) {
  Canvas()->AddText({at.x + 1, at.y + 1}, ToIm(colors::kShade, 0.7f), text);
  Canvas()->AddText(at, ToIm(colors::kWhite), text);
}

void DrawLabel(const Editor& editor, const Rect& within, Point beside, const std::string& text,
               ImU32 color) {
  const float pad = Px(editor, 4.0), widest = Px(editor, 360.0);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, widest);
  const float x = std::min(beside.x + Px(editor, 14.0), within.right() - size.x - 2.0f * pad);
  const float y = std::min(beside.y + Px(editor, 16.0), within.bottom() - size.y - 2.0f * pad);
  Canvas()->AddRectFilled({x - pad, y - pad / 2}, {x + size.x + pad, y + size.y + pad / 2},
                          ToIm(colors::kShade, 0.8f), pad);
  Canvas()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {x, y}, color, text.c_str(), nullptr,
                    widest);
}

}  // namespace hazumi::ui
