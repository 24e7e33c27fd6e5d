#pragma once

#include <set>
#include <string>

#include "tests/ui/user.h"
#include "ui/panels/dope_sheet/layout.h"

namespace hazumi::test {

using ui::Point;

// Somebody before the dope sheet of the throw.
class DopeSheet : public testing::Test {
 protected:
  DopeSheet() : user("throw.kfa") {}

  ui::DopeSheetLayout Layout() {
    return ui::LayOutDopeSheet(user.session(), user.editor().sheet, user.editor().sheet.rect, 1.0);
  }
  ui::Rect Bar(const std::string& row, ui::BarKind kind = ui::BarKind::kRegion, int nth = 0) {
    const ui::DopeSheetLayout layout = Layout();
    for (const ui::RowBar& bar : layout.bars) {
      const bool is_one = layout.rows[bar.row].id == row && bar.ref.kind == kind;
      if (is_one && nth-- == 0) return bar.rect;
    }
    ADD_FAILURE() << "no such bar on " << row;
    return {};
  }
  Point Key(const std::string& row, double frame) {
    const ui::DopeSheetLayout layout = Layout();
    for (const ui::RowKey& key : layout.keys) {
      if (layout.rows[key.row].id == row && key.frame == frame) return key.at;
    }
    ADD_FAILURE() << "no key on " << row << " at " << frame;
    return {};
  }
  float X(double frame) { return Layout().frame.axis.XOf(frame); }
  const ProjectRegion& arms() { return user.project().regions[0]; }
  std::set<double> FramesOf(const std::string& hinge) {
    std::set<double> frames;
    for (const auto& curve : user.project().joints) {
      if (curve.name != hinge) continue;
      for (const ProjectKey& key : curve.value.keys) frames.insert(key.frame);
    }
    return frames;
  }

  User user;
};

}  // namespace hazumi::test
