#include "tests/unit/edit/random/likely_numbers.h"

#include <algorithm>
#include <iterator>

namespace hazumi::test {

namespace {

// What a number of this name is likely to be; of an operator alone, of those whose id begins so, or
// of all. The first that fits counts.
struct LikelyNumber {
  const char* id;
  const char* name;
  Likely range;
};
const LikelyNumber kLikelyNumbers[] = {{"keys.scale", "factor", {0.4, 2.5}},
                                       {"keys.scale", "values", {-1.0, 2.0}},
                                       {"keys.", "frames", {-8.0, 8.0}},
                                       {"keys.", "value", {-10.0, 10.0}},
                                       {"pose.reach", "x", {-0.6, 0.6}},
                                       {"pose.reach", "y", {-0.6, 0.6}},
                                       {"pose.reach", "z", {0.0, 1.8}},
                                       {"pose.reach", "chain", {0.0, 4.0}},
                                       {"pose.rotate", "to", {-40.0, 60.0}},
                                       {"root.move", "x", {-0.2, 0.2}},
                                       {"root.move", "y", {-0.2, 0.2}},
                                       {"root.move", "z", {0.7, 1.1}},
                                       {"root.turn", "by", {-90.0, 90.0}},
                                       {"figure.joint_limits", "lower", {-140.0, -40.0}},
                                       {"figure.link", "mass", {0.2, 12.0}},
                                       {"figure.link", "radius", {0.01, 0.15}},
                                       {"object.", "size_", {0.1, 2.0}},
                                       {"file.import", "unit", {0.01, 0.1}},
                                       {"file.import", "mass", {30.0, 100.0}},
                                       {"file.import", "fps", {20.0, 60.0}},
                                       {"", "upper", {40.0, 140.0}},
                                       {"jump.add", "", {0.2, 0.9}},
                                       {"jump.aim", "", {0.2, 0.9}},
                                       {"held.throw_onto", "x", {0.8, 2.0}},
                                       {"held.throw_onto", "y", {-0.6, 0.2}},
                                       {"held.throw_onto", "z", {0.0, 0.4}},
                                       {"throw.add", "x", {0.8, 2.5}},
                                       {"throw.add", "y", {-0.6, 0.6}},
                                       {"throw.add", "z", {0.0, 0.4}},
                                       {"goal.reach", "x", {0.15, 0.4}},
                                       {"goal.reach", "y", {-0.4, 0.0}},
                                       {"goal.reach", "z", {0.8, 1.4}},
                                       {"held.turn", "", {-90.0, 90.0}},
                                       {"", "height", {0.5, 2.5}},
                                       {"", "reduce", {0.1, 5.0}},
                                       {"", "gravity", {0.0, 20.0}},
                                       {"", "friction_coefficient", {0.0, 1.5}},
                                       {"", "tolerance", {0.003, 1.0}},
                                       {"", "step", {0.004, 0.034}},
                                       {"", "rate", {-200.0, 200.0}},
                                       {"", "value", {-30.0, 60.0}},
                                       {"", "factor", {0.1, 1.0}},
                                       {"", "fov", {15.0, 90.0}},
                                       {"audio.", "gain", {-20.0, 10.0}},
                                       {"audio.", "start", {-30.0, 30.0}},
                                       {"reference.", "start", {-30.0, 30.0}},
                                       {"edit.", "steps", {1.0, 3.0}},
                                       {"", "scale", {0.75, 3.0}},
                                       {"", "num", {24.0, 60.0}},
                                       {"", "den", {1.0, 1.0}},
                                       {"", "by", {-10.0, 10.0}},
                                       {"", "eye_", {-6.0, 6.0}},
                                       {"", "target_", {-1.0, 1.5}}};

}  // namespace

bool IsFrame(const std::string& name) {
  static const char* const kNames[] = {"frame",    "first",   "last",  "to",
                                       "to_first", "to_last", "about", "release"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

Likely LikelyRange(const std::string& id, const edit::ParameterInfo& info,
                   const edit::Session& session) {
  const std::string name = info.name;
  for (const LikelyNumber& likely : kLikelyNumbers) {
    if (id.starts_with(likely.id) && name.starts_with(likely.name)) return likely.range;
  }
  if (info.range.lower > -kLargestNumber) {
    return {info.range.lower, std::min(info.range.upper, info.range.lower + 4.0)};
  }
  if (!IsFrame(name)) return {-1.0, 1.0};
  const ProjectFrames& frames = session.project().frames;
  return {static_cast<double>(frames.first), static_cast<double>(frames.last)};
}

}  // namespace hazumi::test
