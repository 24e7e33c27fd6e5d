#include "tests/support/scaled_projects.h"

#include <cmath>

#include "engine/base/assert.h"
#include "engine/project/figure_file.h"

namespace hazumi::test {

namespace {

constexpr double kHuge = 1e3;  // no limit on the way [rad]

ProjectCurve Wave(int last_frame, int spacing, double phase) {
  ProjectCurve curve;
  for (int frame = 0; frame <= last_frame; frame += spacing) {
    ProjectKey key;
    key.frame = frame;
    key.value = std::round(2000.0 * std::sin(0.1 * frame + phase)) / 100.0;
    curve.keys.push_back(key);
  }
  return curve;
}

ScaledProject Human(int last_frame, int key_spacing) {
  ScaledProject scaled;
  Project& project = scaled.project;
  project.name = "Scaled";
  project.frames.last = last_frame;
  project.figure.file = HAZUMI_SOURCE_DIR "/assets/figures/human.json";
  Result<FigureSpec> spec = LoadFigure(project.figure.file);
  HAZUMI_DEMAND(spec.ok());
  project.figure.spec = std::move(spec).value();
  double phase = 0.0;
  for (const char* hinge : {"r_elbow_flexion", "l_elbow_flexion", "r_shoulder_flexion"}) {
    project.joints.push_back({hinge, Wave(last_frame, key_spacing, phase += 1.0)});
  }
  scaled.curve = "r_elbow_flexion";
  scaled.frame = last_frame / 2 / key_spacing * key_spacing;
  return scaled;
}

JointSpec Rod(int number, const std::string& parent, const Vec3& offset) {
  JointSpec joint;
  joint.name = "j" + std::to_string(number);
  joint.parent = parent;
  joint.offset = offset;
  joint.hinges = {{"", Vec3::Unit(number % 2), -kHuge, kHuge, 0.0}};
  LinkSpec rod;
  rod.name = joint.name;
  rod.to = Vec3(0.0, 0.0, -0.1);
  rod.radius = 0.02;
  rod.mass = 1.0;
  joint.links = {rod};
  return joint;
}

// All joints are free after the first frame, and each has a key there and on the last one.
ScaledProject Tree(int joints, std::string (*parent_of)(int)) {
  ScaledProject scaled;
  Project& project = scaled.project;
  project.name = "Scaled";
  project.frames.last = 3;
  FigureSpec& figure = project.figure.spec;
  figure.name = "tree";
  figure.root_name = "base";
  for (int i = 0; i < joints; ++i) {
    const std::string parent = parent_of(i);
    figure.joints.push_back(Rod(i, parent, Vec3(0.0, 0.0, parent == "base" ? 0.0 : -0.1)));
    ProjectCurve curve;
    for (const int frame : {0, 3}) {
      ProjectKey key;
      key.frame = frame;
      key.value = i % 7;
      curve.keys.push_back(key);
    }
    project.joints.push_back({"j" + std::to_string(i), curve});
  }
  project.figure.embedded_json = FigureText(figure);
  ProjectRegion region;
  region.name = "all";
  region.first_frame = 1;
  region.last_frame = 2;
  for (const JointSpec& joint : figure.joints) {
    if (joint.parent == figure.root_name) region.joints.push_back({joint.name, true, {}});
  }
  project.regions = {region};
  scaled.curve = "j" + std::to_string(joints / 2);
  scaled.frame = 3.0;
  return scaled;
}

std::string OfTree(int i) { return i == 0 ? "base" : "j" + std::to_string((i - 1) / 2); }
std::string OfBase(int) { return "base"; }

ScaledProject WithRegions(int count) {
  ScaledProject scaled = Human(2 * count, 10);
  for (int i = 0; i < count; ++i) {
    ProjectRegion region;
    region.name = "region " + std::to_string(i);
    region.first_frame = 2 * i;
    region.last_frame = 2 * i + 1;
    region.joints = {{"r_wrist", true, {}}};
    scaled.project.regions.push_back(region);
  }
  return scaled;
}

ScaledProject WithPlacements(int count) {
  ScaledProject scaled = Human(count, 10);
  for (int i = 0; i < count; ++i) {
    ProjectPlacement placement;
    placement.kind = PlacementKind::kPinned;
    placement.pin = i % 2 == 0 ? "l_ankle" : "r_ankle";
    placement.first_frame = i;
    placement.last_frame = i + 1;
    scaled.project.placements.push_back(placement);
  }
  return scaled;
}

ScaledProject WithHolds(int count) {
  ScaledProject scaled = Human(2 * count, 10);
  for (int i = 0; i < count; ++i) {
    ProjectHold hold;
    hold.joint = "l_ankle";
    hold.first_frame = 2 * i;
    hold.last_frame = 2 * i + 1;
    scaled.project.holds.push_back(hold);
  }
  return scaled;
}

}  // namespace

const std::vector<std::string>& ScaledKinds() {
  static const std::vector<std::string> kinds = {"frames",  "keys",       "joints", "limbs",
                                                 "regions", "placements", "holds"};
  return kinds;
}

ScaledProject MakeScaled(const std::string& kind, int count) {
  if (kind == "frames") return Human(count - 1, 10);
  if (kind == "keys") return Human(count - 1, 1);
  if (kind == "joints") return Tree(count, OfTree);
  if (kind == "limbs") return Tree(count, OfBase);
  if (kind == "regions") return WithRegions(count);
  if (kind == "placements") return WithPlacements(count);
  HAZUMI_DEMAND(kind == "holds");
  return WithHolds(count);
}

}  // namespace hazumi::test
