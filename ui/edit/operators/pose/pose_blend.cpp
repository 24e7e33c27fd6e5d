// A part of the way from one pose to another: to given angles, and between the keys around.

#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/pose/posing.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

double Between(double from, double to, double share) { return from + share * (to - from); }

double Blended(const std::string& curve, double from, double to, double share,
               const Figure& figure) {
  return WithoutRoundOff(WithinLimits(curve, Between(from, to, share), figure));
}

Result<Done> BlendPose(Session* session, const Parameters& p) {
  const std::vector<std::string> curves = p.names("curves");
  const std::vector<double> values = p.numbers("values");
  if (curves.size() != values.size()) {
    return Refusal("values", "there are " + std::to_string(values.size()) + " for " +
                                 std::to_string(curves.size()) + " curves; give each one");
  }
  const Result<double> share = ShareIn(p, kShare);
  if (!share.ok()) return share.error();
  Pose pose;
  for (size_t i = 0; i < curves.size(); ++i) {
    const Result<double> now = session->ValueNow(curves[i]);
    if (!now.ok()) return now.error();
    pose.push_back(
        {curves[i], Blended(curves[i], now.value(), values[i], share.value(), session->figure())});
  }
  return KeyPose(session, "Apply pose", pose, p.text("drag"));
}

// What the keys before and after a frame say; one on the frame is neither.
struct KeysAround {
  ProjectKey before, after;

  // The share of the time between them that has passed.
  double ShareAt(double frame) const {
    return (frame - before.frame) / (after.frame - before.frame);
  }
};

std::optional<KeysAround> Around(double frame, const ProjectCurve* curve) {
  if (!curve) return std::nullopt;
  std::optional<ProjectKey> before;
  for (const ProjectKey& key : curve->keys) {
    if (key.frame < frame) before = key;
    if (key.frame > frame) return before ? std::optional(KeysAround{*before, key}) : std::nullopt;
  }
  return std::nullopt;
}

// `value_of(curve, keys around)` for each posed curve that has keys on both sides of the frame.
template <typename ValueOf>
Result<Done> KeyBetween(Session* session, const char* label, const Parameters& p,
                        ValueOf value_of) {
  Pose pose;
  for (const std::string& curve : PosedCurves(*session)) {
    const auto keys = Around(session->frame(), FindCurve(curve, session->project()));
    if (!keys) continue;
    const Result<double> value = value_of(curve, *keys);
    if (!value.ok()) return value.error();
    pose.push_back({curve, value.value()});
  }
  if (pose.empty()) {
    return Refusal("",
                   "nothing that is posed has a key before this frame and another after it; "
                   "key it on both sides, or go between its keys");
  }
  const Result<Pose> both = PoseOfSides(std::move(pose), p, session);
  if (!both.ok()) return both.error();
  return KeyPose(session, label, both.value(), p.text("drag"));
}

constexpr NumberRange kWithOvershoot = {-1.0, 2.0};

Result<Done> Breakdown(Session* session, const Parameters& p) {
  const Result<double> share = ShareIn(p, kWithOvershoot);
  if (!share.ok()) return share.error();
  return KeyBetween(session, "Breakdown", p,
                    [&](const std::string& curve, const KeysAround& keys) -> Result<double> {
                      return Blended(curve, keys.before.value, keys.after.value, share.value(),
                                     session->figure());
                    });
}

// From the present pose a share towards the straight line between the keys, or away from it.
Result<Done> MoveTowardsLine(Session* session, const char* label, const Parameters& p,
                             double direction) {
  const Result<double> share = ShareIn(p, kShare);
  if (!share.ok()) return share.error();
  return KeyBetween(
      session, label, p, [&](const std::string& curve, const KeysAround& keys) -> Result<double> {
        Result<double> now = session->ValueNow(curve);
        if (!now.ok()) return now;
        const double line =
            Between(keys.before.value, keys.after.value, keys.ShareAt(session->frame()));
        return Blended(curve, now.value(), line, direction * share.value(), session->figure());
      });
}

Result<Done> Relax(Session* session, const Parameters& p) {
  return MoveTowardsLine(session, "Relax pose", p, 1.0);
}

Result<Done> Push(Session* session, const Parameters& p) {
  return MoveTowardsLine(session, "Push pose", p, -1.0);
}

ParameterInfo Share(const char* help, const NumberRange& range) {
  ParameterInfo share = {"share", kNumber, true, help};
  share.range = range;
  return share;
}

}  // namespace

Result<double> ShareIn(const Parameters& p, const NumberRange& range) {
  const double share = p.number("share", 1.0);
  if (share >= range.lower && share <= range.upper) return share;
  return Refusal("share", "must lie " + Describe(range));
}

std::vector<Operator> PoseBlendOperators() {
  ParameterInfo optional_share = Share("how far from the present pose to it; not given: 1", kShare);
  optional_share.is_required = false;
  return {
      {"pose.blend",
       "Blend to values",
       "Keys values of several curves at the current frame, or a part of the way to them.",
       {{"curves", kNames, true, "hinges, or curves of the root such as root.z", Thing::kCurve},
        {"values", kNumbers, true, "degrees, of the root's position metres; one for each curve"},
        optional_share,
        kDrag},
       BlendPose},
      {"pose.breakdown",
       "Breakdown",
       "Keys a pose between those of the keys before and after, of what is selected or all hinges.",
       {Share("0: as the key before, 1: as the key after; beyond: overshoot", kWithOvershoot),
        kMirror, kDrag},
       Breakdown},
      {"pose.relax",
       "Relax pose",
       "Brings the pose nearer to the straight line between the keys before and after.",
       {Share("0: as it is, 1: on the line", kShare), kMirror, kDrag},
       Relax},
      {"pose.push",
       "Push pose",
       "Takes the pose away from the straight line between the keys before and after.",
       {Share("0: as it is, 1: twice as far from the line", kShare), kMirror, kDrag},
       Push}};
}

}  // namespace hazumi::edit
