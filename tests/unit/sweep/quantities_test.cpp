// What a sweep measures: landings against closed forms, the rest against the motion itself.

#include "engine/sweep/quantities.h"

#include <cmath>
#include <set>

#include "engine/bake/bake.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/stick_figures.h"
#include "tests/unit/sweep/sweeps.h"

namespace hazumi::test {
namespace {

constexpr double kRadius = 0.05;

// A sweep that measures this: fields of a measure.
SweepPlan Measuring(const std::string& measures) {
  return GoodSweep(R"("vary": [{"field": "name", "values": ["a"]}], "measure": [)" + measures +
                   "]");
}

SweepColumn ColumnOf(const std::string& measure, const Animation& animation) {
  const auto columns = ResolveMeasures(Measuring(measure), animation);
  EXPECT_TRUE(columns.ok()) << (columns.ok() ? "" : columns.error().ToString());
  return columns.ok() ? columns.value().at(0) : SweepColumn{};
}

std::string Refusal(const std::string& measures, const Animation& animation) {
  const auto columns = ResolveMeasures(Measuring(measures), animation);
  return columns.ok() ? "" : columns.error().ToString();
}

// A figure that glides with 3 m/s along x, 1.5 m high, and lets a ball go on frame 9, 1 m high.
Animation Gliding() {
  Animation animation = Still(Pogo());
  constexpr Interpolation kLinear = Interpolation::kLinear;
  animation.root_keys[kRootX] = {{0, 0.0, {}, kLinear}, {30, 3.0, {}, kLinear}};
  animation.root_keys[kRootZ] = {{0, 1.5, {}, kLinear}, {30, 1.5, {}, kLinear}};
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{kRadius};
  ball.mass = 0.1;
  ball.holders = {{GroupOf(animation, "foot"), Vec3::Zero(), Holder::kFromTheStart, 9}};
  animation.held_objects.push_back(ball);
  return animation;
}

// All four of them: x, y, z, frame; NaN: none.
std::vector<double> Landing(const Animation& animation) {
  const Motion motion = BakeOrFail(animation);
  std::vector<double> values;
  for (const char* name : {"landing_x_m", "landing_y_m", "landing_z_m", "landing_frame"}) {
    const std::string measure = std::string(R"({"quantity": ")") + name + R"(", "of": "ball"})";
    values.push_back(Measure(ColumnOf(measure, animation), animation, motion));
  }
  return values;
}

void ExpectLanding(const Animation& animation, const Vec3& p, double frame) {
  const std::vector<double> landing = Landing(animation);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(landing[axis], p[axis], 1e-8) << axis;
  EXPECT_NEAR(landing[3], frame, 1e-6);
}

TEST(Landing, OnTheGroundIsThatOfAFallWithTheSpeedItHad) {
  Animation animation = Gliding();
  AddFloor(&animation);
  const double fall = std::sqrt(2.0 * (1.0 - kRadius) / kG);
  ExpectLanding(animation, {0.9 + 3.0 * fall, 0.0, kRadius}, 9.0 + 30.0 * fall);
}

TEST(Landing, OnABoxIsOnItsTop) {
  Animation animation = Gliding();
  AddFloor(&animation);
  animation.scene.push_back({"table", Box{{Mat3::Identity(), {2, 0, 0.2}}, {1, 1, 0.2}}, ""});
  const double fall = std::sqrt(2.0 * (1.0 - 0.4 - kRadius) / kG);
  ExpectLanding(animation, {0.9 + 3.0 * fall, 0.0, 0.4 + kRadius}, 9.0 + 30.0 * fall);
}

TEST(Landing, AgainstABoxIsAtItsSide) {
  Animation animation = Gliding();
  AddFloor(&animation);
  animation.scene.push_back({"wall", Box{{Mat3::Identity(), {2.5, 0, 1}}, {0.5, 1, 1}}, ""});
  const double seconds = (2.0 - kRadius - 0.9) / 3.0;
  ExpectLanding(animation, {2.0 - kRadius, 0.0, 1.0 - 0.5 * kG * seconds * seconds},
                9.0 + 30.0 * seconds);
}

TEST(Landing, IsNoneIfItNeverLands) {
  Animation animation = Gliding();
  for (const double value : Landing(animation)) EXPECT_TRUE(std::isnan(value)) << "no ground";
  AddFloor(&animation);
  animation.held_objects[0].holders[0].last_frame.reset();
  for (const double value : Landing(animation)) EXPECT_TRUE(std::isnan(value)) << "never let go";
}

TEST(Quantities, EachHasANameOfItsOwnAndHelp) {
  std::set<std::string> names;
  for (const Quantity& quantity : AllQuantities()) {
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
    EXPECT_STRNE(quantity.help, "") << quantity.name;
  }
}

struct Example {
  explicit Example(const std::string& name)
      : animation(CompileAnimation(
                      LoadProject(HAZUMI_SOURCE_DIR "/assets/examples/" + name + ".kfa").value())
                      .value()
                      .animation) {
    BakeOptions options;
    options.energy = true;
    motion = BakeOrFail(animation, options);
  }
  double Value(const std::string& measure) const {
    return Measure(ColumnOf(measure, animation), animation, motion);
  }
  Animation animation;
  Motion motion;
};

// With what it may be of, and a frame: something comes out of each in one of the examples.
TEST(Quantities, EachIsANumberInAnExample) {
  const Example thrown("throw"), jump("jump");
  for (const Quantity& quantity : AllQuantities()) {
    std::string measure = std::string(R"({"quantity": ")") + quantity.name + "\"";
    if (quantity.of == QuantityOf::kHeldObject) measure += R"(, "of": "ball")";
    if (quantity.of == QuantityOf::kJoint) measure += R"(, "of": "r_wrist")";
    if (quantity.of == QuantityOf::kHinge) measure += R"(, "of": "r_elbow_flexion")";
    if (quantity.of == QuantityOf::kRegion) {
      measure += R"(, "of": ")" + thrown.animation.regions[0].name + "\"";
    }
    if (quantity.is_at_frame) measure += R"(, "frame": 12)";
    EXPECT_TRUE(std::isfinite(thrown.Value(measure + "}"))) << quantity.name;
    if (quantity.is_of_one || quantity.of == QuantityOf::kNothing) continue;
    const std::string of_all = std::string(R"({"quantity": ")") + quantity.name + "\"}";
    EXPECT_TRUE(std::isfinite(thrown.Value(of_all))) << quantity.name;
    // A jump without a region has no energy of regions.
    const bool is_of_region = quantity.of == QuantityOf::kRegion;
    EXPECT_EQ(std::isfinite(jump.Value(of_all)), !is_of_region) << quantity.name;
  }
}

TEST(Quantities, AreWhatTheMotionSays) {
  const Example thrown("throw");
  const auto& [animation, motion] = thrown;
  double highest = -1e9, lowest = 1e9, fastest = 0.0, elbow = 0.0, speed = 0.0;
  const auto j = JointOf(animation, "r_elbow_flexion").value();
  Vec3 before = OriginOf(animation, motion.frames[0], "r_wrist");
  for (const MotionFrame& frame : motion.frames) {
    highest = std::max(highest, frame.com.z());
    lowest = std::min(lowest, frame.com.z());
    for (const MotionLimit* side : {&frame.before, &frame.after}) {
      fastest = std::max(fastest, side->qd.cwiseAbs().maxCoeff());
      elbow = std::max(elbow, std::abs(side->qd[j]));
    }
    const Vec3 p = OriginOf(animation, frame, "r_wrist");
    speed = std::max(speed, (p - before).norm() * 30.0);
    before = p;
  }
  EXPECT_EQ(thrown.Value(R"({"quantity": "com_highest_m"})"), highest);
  EXPECT_EQ(thrown.Value(R"({"quantity": "com_lowest_m"})"), lowest);
  EXPECT_NEAR(thrown.Value(R"({"quantity": "rate_largest_deg_s"})"), fastest / kDegree, 1e-9);
  EXPECT_NEAR(thrown.Value(R"({"quantity": "rate_largest_deg_s", "of": "r_elbow_flexion"})"),
              elbow / kDegree, 1e-9);
  EXPECT_NEAR(thrown.Value(R"({"quantity": "speed_largest_m_s", "of": "r_wrist"})"), speed, 1e-9);
  EXPECT_NEAR(thrown.Value(R"({"quantity": "angle_deg", "of": "r_elbow_flexion", "frame": 12})"),
              motion.frames[12].q[j] / kDegree, 1e-9);
  const Vec3 wrist = OriginOf(animation, motion.frames[12], "r_wrist");
  for (const char axis : {'x', 'y', 'z'}) {
    const std::string measure =
        std::string(R"({"quantity": "position_)") + axis + R"(_m", "of": "r_wrist", "frame": 12})";
    EXPECT_NEAR(thrown.Value(measure), wrist[axis - 'x'], 1e-12) << axis;
  }
  EXPECT_EQ(thrown.Value(R"({"quantity": "warnings"})"), motion.warnings.size());
}

TEST(Quantities, OfRegionsAreTheWorstOrTheSum) {
  const Example thrown("throw");
  double worst = 0.0, kinetic = 0.0, friction = 0.0;
  for (const RegionReport& region : thrown.motion.regions) {
    worst = std::max(worst, region.error_estimate);
    kinetic += region.energy->kinetic_end;
    friction += region.energy->WorkOf("friction");
    const std::string of = R"(", "of": ")" + region.name + "\"}";
    EXPECT_EQ(thrown.Value(R"({"quantity": "kinetic_end_j)" + of), region.energy->kinetic_end);
    EXPECT_EQ(thrown.Value(R"({"quantity": "limit_work_j)" + of), region.energy->limits);
    EXPECT_EQ(thrown.Value(R"({"quantity": "keyed_work_j)" + of), region.energy->keyed);
  }
  EXPECT_NEAR(thrown.Value(R"({"quantity": "error_estimate_deg"})"), worst / kDegree, 1e-12);
  EXPECT_NEAR(thrown.Value(R"({"quantity": "kinetic_end_j"})"), kinetic, 1e-12);
  EXPECT_NEAR(thrown.Value(R"({"quantity": "friction_work_j"})"), friction, 1e-12);
}

TEST(Quantities, CountLimitsByHinge) {
  Example thrown("throw");
  thrown.motion.events.clear();
  for (const auto& [joint, count] : {std::pair("r_elbow_flexion", 3L), {"neck_flexion", 1L}}) {
    MotionEvent event{EventKind::kLimit, 0.0, 0, {}};
    event.joint = joint;
    event.count = count;
    thrown.motion.events.push_back(event);
  }
  thrown.motion.events.push_back({EventKind::kRelease, 0.0, 0, {}});
  EXPECT_EQ(thrown.Value(R"({"quantity": "limit_hits"})"), 4.0);
  EXPECT_EQ(thrown.Value(R"({"quantity": "limit_hits", "of": "r_elbow_flexion"})"), 3.0);
  EXPECT_EQ(thrown.Value(R"({"quantity": "limit_hits", "of": "l_elbow_flexion"})"), 0.0);
}

// The lowest point of the figure is the ball of its foot, 0.55 m below the root.
TEST(Quantities, ClearanceIsTheGapToTheGround) {
  Animation animation = Gliding();
  animation.root_keys[kRootZ] = {{0, 1.5, {}, Interpolation::kLinear},
                                 {10, 0.5, {}, Interpolation::kLinear},
                                 {30, 1.5, {}, Interpolation::kLinear}};
  AddFloor(&animation);
  const SweepColumn column = ColumnOf(R"({"quantity": "clearance_least_m"})", animation);
  EXPECT_NEAR(Measure(column, animation, BakeOrFail(animation)), 0.5 - 0.55, 1e-12);
  animation.scene.clear();
  EXPECT_TRUE(std::isnan(Measure(column, animation, BakeOrFail(animation)))) << "nothing is there";
}

TEST(ResolveMeasures, NamesColumnsAfterWhatTheyAre) {
  const Example thrown("throw");
  const auto columns = ResolveMeasures(
      Measuring(R"({"quantity": "landing_x_m", "of": "ball"}, {"quantity": "com_highest_m"},
                   {"quantity": "angle_deg", "of": "r_elbow_flexion", "frame": 12},
                   {"quantity": "limit_hits", "name": "hits"})"),
      thrown.animation);
  ASSERT_TRUE(columns.ok());
  std::vector<std::string> names;
  for (const SweepColumn& column : columns.value()) names.push_back(column.name);
  EXPECT_EQ(names, (std::vector<std::string>{"landing_x_m ball", "com_highest_m",
                                             "angle_deg r_elbow_flexion F12", "hits"}));
}

TEST(ResolveMeasures, WithoutAnyAreThoseOneLooksAtFirst) {
  const Example thrown("throw");
  const auto columns = ResolveMeasures(GoodSweep(R"("vary": [{"field": "name", "values": ["a"]}])"),
                                       thrown.animation);
  ASSERT_TRUE(columns.ok());
  EXPECT_EQ(columns.value().size(), 10u);
  EXPECT_EQ(columns.value()[0].name, "landing_x_m ball");
}

TEST(ResolveMeasures, RefusesWithThePlace) {
  const Example thrown("throw");
  const std::vector<std::pair<std::string, std::string>> refusals = {
      {R"({"quantity": "landing_x", "of": "ball"})",
       "measure[0].quantity: there is no quantity \"landing_x\"; did you mean \"landing_x_m\"?"},
      {R"({"quantity": "warnings"}, {"quantity": "landing_x_m"})",
       "measure[1]: \"of\" is missing: the held object"},
      {R"({"quantity": "landing_x_m", "of": "bal"})",
       "measure[0].of: there is no held object \"bal\"; did you mean \"ball\"?"},
      {R"({"quantity": "angle_deg", "of": "r_elbow_flexoin", "frame": 1})",
       "measure[0].of: there is no hinge \"r_elbow_flexoin\"; did you mean \"r_elbow_flexion\"?"},
      {R"({"quantity": "position_x_m", "of": "r_wirst", "frame": 1})",
       "measure[0].of: there is no joint \"r_wirst\"; did you mean \"r_wrist\"?"},
      {R"({"quantity": "warnings", "of": "ball"})",
       "measure[0].of: the quantity is that of the figure: leave \"of\" out"},
      {R"({"quantity": "warnings", "frame": 1})",
       "measure[0].frame: the quantity is that of all frames: leave \"frame\" out"},
      {R"({"quantity": "angle_deg", "of": "r_elbow_flexion"})",
       "measure[0]: \"frame\" is missing: where it is measured"},
      {R"({"quantity": "angle_deg", "of": "r_elbow_flexion", "frame": 31})",
       "measure[0].frame: must be a whole frame from 0 to 30"},
      {R"({"quantity": "angle_deg", "of": "r_elbow_flexion", "frame": 1.5})",
       "measure[0].frame: must be a whole frame from 0 to 30"},
      {R"({"quantity": "warnings"}, {"quantity": "limit_hits", "name": "warnings"})",
       "measure[1]: two columns are named \"warnings\": give one another \"name\""}};
  for (const auto& [measures, message] : refusals) {
    EXPECT_EQ(Refusal(measures, thrown.animation), message);
  }
  Animation bare = Still(Pogo());
  EXPECT_EQ(Refusal(R"({"quantity": "landing_x_m", "of": "ball"})", bare),
            "measure[0].of: there is no held object \"ball\"");
}

}  // namespace
}  // namespace hazumi::test
