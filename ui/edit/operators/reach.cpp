// Inverse kinematics for posing.

#include "engine/placement/reach.h"

#include <algorithm>
#include <cmath>

#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/limb_chain.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

std::optional<GroupIndex> JointNamed(const std::string& name, const Figure& figure) {
  if (const auto group = figure.FindGroup(name)) return group;
  const auto hinge = figure.FindJoint(name);
  return hinge ? std::optional(figure.joint(*hinge).group) : std::nullopt;
}

// The joint held or pinned now that turning these hinges would move, too.
std::optional<std::string> JointInTheWay(const std::vector<JointIndex>& hinges, double frame,
                                         const MotionFrame& now, const Animation& animation) {
  const Figure& figure = *animation.figure;
  const auto moves = [&](GroupIndex joint) {
    const JointIndex parent = figure.joint(figure.group(joint).first).parent;
    return parent.is_valid() && std::any_of(hinges.begin(), hinges.end(), [&](JointIndex hinge) {
             return figure.IsBeyond(parent, hinge);
           });
  };
  for (const IkHold& hold : animation.holds) {
    if (frame < hold.first_frame || frame > hold.last_frame || !moves(hold.joint)) continue;
    return "\"" + figure.group(hold.joint).name + "\" is held in this frame; remove the hold";
  }
  if (!now.pinned || !moves(*now.pinned)) return std::nullopt;
  return "\"" + figure.group(*now.pinned).name +
         "\" is pinned in this frame and the same hinges carry it; place the figure otherwise";
}

// The hinges to turn.
Result<std::vector<JointIndex>> HingesFor(GroupIndex moved, const Parameters& p, double frame,
                                          const Animation& animation,
                                          const std::set<std::string>& locked) {
  const Figure& figure = *animation.figure;
  const auto count = p.has("chain") ? std::optional(p.integer("chain")) : std::nullopt;
  if (count && *count < 0) return Refusal("chain", "must not be negative");
  const std::vector<GroupIndex> chain = ChainOf(moved, count, figure);
  if (chain.empty()) {
    return Refusal("joint", "no joint lies between the root and \"" + figure.group(moved).name +
                                "\"; move the root instead");
  }
  std::vector<JointIndex> hinges = KeyedHinges(chain, frame, animation);
  std::erase_if(hinges, [&](JointIndex j) { return locked.contains(figure.joint(j).name); });
  if (!hinges.empty()) return hinges;
  return Refusal("joint", "every joint that moves \"" + figure.group(moved).name +
                              "\" is swung by a region in this frame, or locked; end the region " +
                              "before it, or unlock one");
}

Result<Done> ReachFor(Session* session, const Parameters& p) {
  const Figure& figure = session->figure();
  const auto moved = JointNamed(p.text("joint"), figure);
  if (!moved) return Refusal("joint", "the figure has no joint \"" + p.text("joint") + "\"");
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!now.ok()) return now.error();
  const Animation& animation = *session->animation();
  const double frame = session->frame();
  const Result<std::vector<JointIndex>> hinges =
      HingesFor(*moved, p, frame, animation, session->locked_joints());
  if (!hinges.ok()) return hinges.error();
  if (const auto why = JointInTheWay(hinges.value(), frame, *now.value(), animation)) {
    return Refusal("joint", *why);
  }
  VecX q = now.value()->q;
  Reach(figure,
        {now.value()->X_WR, figure.group(*moved).first,
         Vec3(p.number("x"), p.number("y"), p.number("z")), hinges.value()},
        &q);
  Pose pose;
  for (const JointIndex j : hinges.value()) {
    pose.push_back({figure.joint(j).name, ShortestDegrees(q[j.value()])});
  }
  return KeyPose(session, "Reach", pose, p.text("drag"));
}

}  // namespace

std::vector<Operator> ReachOperators() {
  return {{"pose.reach",
           "Reach",
           "Turns a limb, within its limits, so that a joint comes to a place or near it; keys it.",
           {{"joint", kText, true, "a joint, e.g. a wrist", Thing::kJoint},
            {"x", kNumber, true, "where to, metres in the world"},
            {"y", kNumber, true, "metres"},
            {"z", kNumber, true, "metres"},
            {"chain", kInteger, false,
             "how many joints turn; 0: all up to the root; not given: the limb"},
            kDrag},
           ReachFor}};
}

}  // namespace hazumi::edit
