#pragma once

#include <optional>
#include <string>

#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

// An elbow or a knee while the hand or foot beyond it is selected: it goes round the line from the
// limb's first joint to that one.
struct SwivelHandle {
  std::string joint;      // that is selected, and stays
  Vec3 at, center, axis;  // the elbow, the point of the line nearest to it, the line [m]
};
// None if no such joint is selected, or if the limb is straight.
std::optional<SwivelHandle> SwivelHandleOf(const edit::Session& session, const PosedFigure& figure);

void TakeSwivelTool(Editor* editor, const SwivelHandle& handle, HeldFrom held);

void DrawSwivelHandle(const Editor& editor, const View& view, const SwivelHandle& handle);

}  // namespace hazumi::ui
