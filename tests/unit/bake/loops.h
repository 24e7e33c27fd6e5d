#pragma once

// Figures that constraints close to loops. Metres, kilograms.

#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/bake/constraint_cases.h"

namespace hazumi::test {

// Bars in a row, hinged about y, that turn as far as they like; the first one is on `parent`.
inline void AddBars(const std::vector<double>& lengths, const std::string& parent, const Vec3& at,
                    FigureSpec* spec) {
  std::string below = parent;
  Vec3 offset = at;
  for (size_t i = 0; i < lengths.size(); ++i) {
    JointSpec joint;
    joint.name = "bar" + std::to_string(i);
    joint.parent = below;
    joint.offset = offset;
    joint.hinges = {{"", Vec3::UnitY(), -1e3, 1e3, 0.0}};
    joint.links = {Rod(joint.name.c_str(), Vec3::Zero(), lengths[i] * Vec3::UnitX())};
    spec->joints.push_back(joint);
    below = joint.name;
    offset = lengths[i] * Vec3::UnitX();
  }
}

inline ConstraintEnd EndOfLastBar(const Animation& animation, double length) {
  ConstraintEnd tip = OnJoint(animation, "bar2");
  tip.offset = length * Vec3::UnitX();
  return tip;
}

// Keys that lay bars of these lengths so that the last one ends at `to` from the start of the
// first, which is turned by `first` about y: the other two by the law of cosines.
inline void CloseLoop(const std::vector<double>& l, double first, const Vec3& to,
                      Animation* animation) {
  const Vec3 elbow = l[0] * Vec3(std::cos(first), 0.0, -std::sin(first));
  const Vec3 way = to - elbow;
  const double d = way.norm();
  const double towards = std::atan2(-way.z(), way.x());
  const double inner = std::acos((l[1] * l[1] + d * d - l[2] * l[2]) / (2.0 * l[1] * d));
  const double outer = std::acos((l[1] * l[1] + l[2] * l[2] - d * d) / (2.0 * l[1] * l[2]));
  const double second = towards - inner - first, third = M_PI - outer;
  const double angles[] = {first, second, third};
  for (int i = 0; i < 3; ++i) {
    KeysOf(animation, ("bar" + std::to_string(i)).c_str()) = {{0, angles[i], 0.0, kHold}};
  }
}

inline const std::vector<double> kBars = {0.3, 0.5, 0.45};
inline const Vec3 kBarsEnd(0.6, 0.0, 0.0);

// Three bars and a base that stays, let go so that they swing through.
inline Animation FourBar(int frames) {
  FigureSpec spec;
  spec.name = "four bars";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), kBarsEnd)};
  AddBars(kBars, "base", Vec3::Zero(), &spec);
  Animation animation = Exact(BuildFigure(spec).value(), kG);
  animation.last_frame = frames;
  AddRegion(&animation, "bars", 0, frames, {"bar0"}).method = Method::kExact;
  CloseLoop(kBars, -0.5, kBarsEnd, &animation);
  AddPoint(&animation, EndOfLastBar(animation, kBars[2]), InWorld(kBarsEnd), 0, frames);
  return animation;
}

// The same with the fourth bar as its root, in flight and turning; the axis that it turns about is
// tilted by so much from that of its hinges [rad].
inline Animation FreeFourBar(int frames, double tilt) {
  Animation animation = FourBar(frames);
  animation.regions.clear();
  animation.constraints.clear();
  AddGravity(&animation, 0, frames);
  FreeAll(&animation, {"bar0"});
  animation.regions[0].last_frame = frames;
  SetRoot(&animation, kRootZ, 5.0, 3.0);
  SetRoot(&animation, kRootAngleY, 0.2, 4.0);
  SetRoot(&animation, kRootAngleX, tilt, 0.0);
  AddPoint(&animation, EndOfLastBar(animation, kBars[2]), OnRoot(kBarsEnd), 0, frames);
  return animation;
}

}  // namespace hazumi::test
