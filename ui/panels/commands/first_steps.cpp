#include "ui/panels/commands/first_steps.h"

#include <algorithm>

namespace hazumi::ui {

namespace {

bool IsOfArm(const std::string& joint) {
  constexpr const char* kParts[] = {"shoulder", "elbow", "wrist", "forearm"};
  return std::any_of(std::begin(kParts), std::end(kParts),
                     [&](const char* part) { return joint.find(part) != std::string::npos; });
}

bool PosesFigure(const std::string& id) {
  return id == "key.insert" || id == "key.set" || id == "pose.paste" || id == "pose.clear" ||
         id == "pose.rotate" || id == "pose.reach";
}

bool IsRegionOfArm(const ExecutedCommand& deed) {
  if (deed.id != "region.add") return false;
  if (!deed.parameters.contains("joints")) {
    return std::any_of(deed.selected_joints.begin(), deed.selected_joints.end(), IsOfArm);
  }
  const edit::Json& joints = deed.parameters["joints"];
  return std::any_of(joints.begin(), joints.end(),
                     [](const edit::Json& name) { return IsOfArm(name.get<std::string>()); });
}

}  // namespace

std::array<bool, kNumFirstSteps> FirstSteps::ticks() const {
  return {!posed_frames.empty(), posed_frames.size() > 2, has_region, has_pin, has_played};
}

bool FirstSteps::all() const {
  const auto done = ticks();
  return std::all_of(done.begin(), done.end(), [](bool is_done) { return is_done; });
}

void FirstSteps::TakeDragged() {
  if (dragged_frame) posed_frames.insert(*dragged_frame);
  dragged_frame.reset();
}

FirstSteps After(FirstSteps steps, const ExecutedCommand& deed) {
  if (deed.id == "file.new") return {};
  if (PosesFigure(deed.id)) {
    const bool names_frame = deed.id == "key.set" && deed.parameters.contains("frame");
    steps.dragged_frame = names_frame ? deed.parameters["frame"].get<double>() : deed.frame;
    if (deed.parameters.value("drag", "").empty()) steps.TakeDragged();
  }
  // A drag counts when it is confirmed.
  if (deed.id == "edit.end_drag") steps.TakeDragged();
  if (deed.id == "edit.cancel_drag") steps.dragged_frame.reset();
  steps.has_region |= IsRegionOfArm(deed);
  steps.has_pin |= deed.id == "placement.set" && deed.parameters.value("kind", "") == "pinned";
  // Playing counts once there is something to see.
  steps.has_played |= deed.id == "time.play" && steps.has_region;
  return steps;
}

const StepText& TextOfStep(int step) {
  static const StepText texts[kNumFirstSteps] = {
      {"Pose the figure",
       "Click the right shoulder in the viewport, press R, turn it back as before a throw, and "
       "click. That makes a key."},
      {"Two more poses",
       "Click on frame 30 in the timeline and turn the shoulder to where it shall end; then on "
       "frame 5, and turn it forwards: the arm now swings by keys."},
      {"Let the arm go",
       "Click on frame 30, then on \"Right arm\" in the dope sheet, which selects all of it, and "
       "press I: so it has keys to come back to. Now choose Region > Add dynamics region, from "
       "frame 5 to 15. There no key moves the arm: it goes on with the speed it has."},
      {"Put a foot on the ground",
       "Choose Scene > Place figure: pinned, frames 0 to 30, pinned joint l_toe. The figure now "
       "stands on that foot."},
      {"Play", "Press Space. The arm swings out by itself and then follows your keys again."}};
  return texts[step];
}

}  // namespace hazumi::ui
