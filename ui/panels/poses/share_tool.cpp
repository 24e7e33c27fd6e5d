// Breakdown, relax, push, and poses of the library: a share by the mouse.

#include <algorithm>
#include <cmath>

#include "ui/panels/commands/actions.h"
#include "ui/panels/poses/actions.h"
#include "ui/panels/viewport/tools/drag_tool.h"

namespace hazumi::ui {

namespace {

constexpr double kWidthPx = 200.0;  // from 0 to 100 %, at scale 1

class ShareTool : public DragTool {
 public:
  ShareTool(Editor* editor, std::string id, Json parameters, std::optional<HeldFrom> held)
      : DragTool(editor, "pose.share ", held.has_value()),
        id_(std::move(id)),
        label_(LabelOf(id_)),
        parameters_(std::move(parameters)),
        begins_at_(id_ == "pose.breakdown" ? 0.5 : 0.0),
        may_overshoot_(id_ == "pose.breakdown") {
    if (parameters_.contains("name")) label_ += " " + parameters_["name"].get<std::string>();
    if (held) BeginAt(held->mouse);
  }

  std::string hint() const override {
    const std::string percent =
        typed_.is_empty() ? std::to_string(std::lround(100.0 * share_.value_or(begins_at_)))
                          : typed_.shown();
    std::string text = label_ + ": " + percent + " %";
    if (may_overshoot_)
      text += std::string("   E: ") + Tr(overshoots_ ? "no overshoot" : "overshoot");
    return text + "   Enter: " + Tr("confirm") + "   Esc: " + Tr("cancel") +
           "   0-9: " + Tr("number") + "   Shift: " + Tr("precise") + "   Ctrl: " + Tr("snap");
  }

 private:
  bool Follow(Editor* editor, const ToolInput& input) override;
  double ByMouse(bool snap) const;

  std::string id_, label_;
  Json parameters_;
  double begins_at_;
  bool may_overshoot_, overshoots_ = false;
  double moved_ = 0.0;  // by the mouse
  TypedNumber typed_;
  std::optional<double> share_;  // that was run last
};

double ShareTool::ByMouse(bool snap) const {
  constexpr double kSnap = 0.1;
  double share = begins_at_ + moved_;
  if (snap) share = kSnap * std::round(share / kSnap);
  return overshoots_ ? std::clamp(share, -1.0, 2.0) : std::clamp(share, 0.0, 1.0);
}

// Each time from the beginning.
bool ShareTool::Follow(Editor* editor, const ToolInput& input) {
  for (const Chord& chord : input.keys) {
    if (typed_.Take(chord)) continue;
    if (may_overshoot_ && chord == Chord{'E'}) overshoots_ = !overshoots_;
  }
  moved_ += MouseMoved(input).x / (kWidthPx * editor->settings.scale);
  const double share = typed_.is_empty() ? ByMouse(input.snap) : typed_.value() / 100.0;
  if (share == share_) return true;
  share_ = share;
  TakeBack(editor);
  Json parameters = parameters_;
  parameters["share"] = share;
  return Run(editor, id_, std::move(parameters));
}

}  // namespace

Result<Done> TakeShareTool(Editor* editor, const std::string& id, Json parameters,
                           std::optional<HeldFrom> held) {
  editor->Take(nullptr);
  editor->Take(std::make_unique<ShareTool>(editor, id, std::move(parameters), held));
  return Done();
}

}  // namespace hazumi::ui
