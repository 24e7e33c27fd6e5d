#include <algorithm>
#include <cmath>

#include "ui/panels/dope_sheet/bar_tools.h"
#include "ui/panels/sheet/drag.h"

namespace hazumi::ui {

namespace {

constexpr double kWhole = 100.0;  // from none of it to all [px], at scale 1: bars are lower

class StrengthTool : public SheetDrag {
 public:
  StrengthTool(Editor* editor, Point start, const std::string& region, const RowMuscle& muscle)
      : SheetDrag(editor, start, true),
        region_(region),
        spring_(muscle.spring),
        before_(muscle.strength.value_or(1.0)),
        wanted_(before_) {}

  std::string hint() const override {
    const std::string text =
        std::string(Tr("Strength")) + "  " + region_ + "  " + PercentText(wanted_);
    if (!trouble_.empty()) return text + "   ! " + trouble_;
    return text + "   " + DragKeys(false) + "   Ctrl: " + Tr("snap");
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    if (!has_moved()) return;
    const double by = (start().y - input.mouse.y) / (kWhole * editor->settings.scale);
    const double steps = input.snap ? 10.0 : 100.0;
    const double wanted =
        std::clamp(std::round(steps * (before_ + by)) / steps, 0.0, std::max(1.0, before_));
    if (wanted == wanted_) return;
    wanted_ = wanted;
    const Result<Done> done = editor->Invoke(
        "drive.set",
        {{"region", region_}, {"number", spring_}, {"strength", wanted_}, {"drag", drag()}});
    trouble_ = done.ok() ? "" : done.error().message;
  }

 private:
  std::string region_;
  int spring_;
  double before_, wanted_;
  std::string trouble_;
};

}  // namespace

std::unique_ptr<Tool> MakeDragStrength(Editor* editor, Point start, const RowBar& bar) {
  const ProjectRegion& region = editor->session().project().regions[bar.ref.index];
  return std::make_unique<StrengthTool>(editor, start, region.name, bar.muscle);
}

}  // namespace hazumi::ui
