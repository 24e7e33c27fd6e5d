#include <imgui.h>

#include <array>

#include "engine/base/filled.h"
#include "ui/panels/viewport/effort.h"
#include "ui/panels/viewport/marks.h"
#include "ui/panels/viewport/scene.h"

namespace hazumi::ui {

namespace {

// What the colours mean: a bar from nothing to all, and what is beyond, with the largest share.
void DrawScale(const Editor& editor, const Rect& rect) {
  const float line = ImGui::GetTextLineHeight(), gap = Px(editor, 4.0);
  const float part = Px(editor, 9.0), high = Px(editor, 9.0);
  constexpr int kParts = 20;
  const ImVec2 at = {rect.x + Px(editor, 100.0), rect.bottom() - Px(editor, 14.0) - high};
  for (int i = 0; i < kParts; ++i) {
    const ImU32 color = ToIm(EffortColor((i + 0.5) / kParts));
    const float x = at.x + part * static_cast<float>(i);
    Canvas()->AddRectFilled({x, at.y}, {x + part, at.y + high}, color);
  }
  const float end = at.x + part * kParts;
  Canvas()->AddRectFilled({end + gap, at.y}, {end + gap + 2.0f * part, at.y + high},
                          ToIm(EffortColor(2.0)));
  const float text = at.y - line - gap;
  DrawShadedText({at.x, text}, "0");
  DrawShadedText({end - ImGui::CalcTextSize("100 %").x, text}, "100 %");
  DrawShadedText({end + gap + Px(editor, 4.0), text}, ">");
  const Figure& figure = editor.session().figure();
  DrawShadedText({at.x, text - line - gap},
                 EffortText(figure, editor.effort, FrameShown(editor)).c_str());
}

}  // namespace

void DrawEffort(const Editor& editor, const View& view, const PosedFigure& figure) {
  if (!editor.viewport.overlays.effort) return;
  DrawScale(editor, view.rect());
  const FrameEffort* effort = editor.effort.At(FrameShown(editor));
  if (!effort) return;
  for (const EffortMark& mark : EffortMarks(figure.figure(), *effort)) {
    const auto at = view.ToWindow(figure.CenterOf(mark.joint));
    if (!at) continue;
    const float radius = Px(editor, 9.0);
    Canvas()->AddCircle(ToIm(*at), radius, ToIm(colors::kShade, 0.8f), 24, Px(editor, 4.0));
    Canvas()->AddCircle(ToIm(*at), radius, ToIm(EffortColor(mark.share)), 24, Px(editor, 2.5));
    const std::string text = Filled("%.0f %%", 100.0 * mark.share);
    DrawShadedText({at->x + 1.3f * radius, at->y - 0.5f * ImGui::GetTextLineHeight()},
                   text.c_str());
  }
}

}  // namespace hazumi::ui
