// Regions that touch the scene, baked on after edits of it: the same bits as baked anew.

#include "tests/unit/bake/contact_cases.h"

namespace hazumi::test {
namespace {

constexpr double kDepth = 1e-5;  // as deep as frames may lie in what they touch [m]

// A rod that hangs from a joint and swings about y, held up beside a table that it falls onto.
Animation ArmOverTable() {
  FigureSpec spec;
  spec.name = "arm";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), 0.1 * Vec3::UnitZ())};
  JointSpec joint;
  joint.name = "pivot";
  joint.parent = "base";
  joint.hinges = {{"", Vec3::UnitY(), -3.0, 3.0, 0.0}};
  joint.links = {Rod("rod", Vec3::Zero(), kLength * Vec3::UnitX())};
  spec.joints = {joint};
  Animation animation = Exact(BuildFigure(spec).value(), kG);
  animation.solver.tolerance = 0.01 * kDegree;
  SetRoot(&animation, kRootZ, 1.0, 0.0);
  DynamicsRegion& region = AddRegion(&animation, "fall", 5, 25, {"pivot"}, 0.9);
  region.method = Method::kExact;
  region.touches_scene = true;
  SceneObject table;
  table.name = "table";
  table.shape = Box{{Mat3::Identity(), Vec3(0.6, 0.0, 0.4)}, Vec3(0.3, 0.5, 0.4)};
  animation.scene.push_back(table);
  return animation;
}

Box& TableOf(Animation* animation) { return std::get<Box>(animation->scene.back().shape); }

// A capsule that falls onto a slope and slides.
Animation CapsuleOnSlope() {
  Animation animation = Loose(FreeCapsule(0.3, 0.1), 30);
  animation.solver.tolerance = 0.01 * kDegree;
  AddIncline(&animation, 0.3, 0.2);
  SetRoot(&animation, kRootZ, 0.3, 0.0);
  SetRoot(&animation, kRootAngleY, 0.3, 0.0);
  return animation;
}

// After each of its edits an animation is as baked anew, and is not what it was before.
class Edits {
 public:
  explicit Edits(Animation animation) : animation_(std::move(animation)), bake_(animation_) {
    ExpectBakedAsAnew(&bake_, animation_);
  }
  template <typename Edit>
  void Make(const char* what, Edit edit) {
    SCOPED_TRACE(what);
    const MotionFrame before = bake_.motion().frames[kSeen];
    edit(&animation_);
    bake_.Update(animation_);
    ExpectBakedAsAnew(&bake_, animation_);
    EXPECT_FALSE(IsSame(bake_.motion().frames[kSeen], before));
  }
  // The least of the frames up to the one that is seen.
  double clearance() const {
    double least = 1.0;
    for (size_t f = 0; f <= kSeen; ++f) {
      least = std::min(least, ClearanceOf(animation_, bake_.motion().frames[f]));
    }
    return least;
  }

 private:
  static constexpr size_t kSeen = 24;
  Animation animation_;
  IncrementalBake bake_;
};

TEST(ContactEdit, AnArmFeelsTheTableThatIsMovedResizedAndTakenAway) {
  Edits edits(ArmOverTable());
  EXPECT_GT(edits.clearance(), -kDepth);
  edits.Make("lower", [](Animation* a) { TableOf(a).X_WB.p.z() -= 0.1; });
  EXPECT_GT(edits.clearance(), -kDepth);
  edits.Make("higher", [](Animation* a) { TableOf(a).half_size.z() += 0.15; });
  EXPECT_GT(edits.clearance(), -kDepth);
  edits.Make("gone", [](Animation* a) { a->scene.clear(); });
  edits.Make("a floor", [](Animation* a) { AddFloor(a, 0.8); });
  EXPECT_GT(edits.clearance(), -kDepth);
}

TEST(ContactEdit, ItPassesThroughTheTableAsSoonAsItDoesNotTouchTheScene) {
  Edits edits(ArmOverTable());
  edits.Make("through", [](Animation* a) { a->regions[0].touches_scene = false; });
  EXPECT_LT(edits.clearance(), -0.01);
  edits.Make("not through", [](Animation* a) { a->regions[0].touches_scene = true; });
  EXPECT_GT(edits.clearance(), -kDepth);
}

TEST(ContactEdit, ACapsuleFeelsTheSlopeAndItsFriction) {
  Edits edits(CapsuleOnSlope());
  edits.Make("smooth", [](Animation* a) { a->scene[0].friction = 0.0; });
  edits.Make("rough", [](Animation* a) { a->scene[0].friction = 0.15; });
  edits.Make("lower", [](Animation* a) { std::get<Plane>(a->scene[0].shape).offset -= 0.1; });
  EXPECT_GT(edits.clearance(), -kDepth);
}

// Gravity places it by its pins where it does not touch the scene.
TEST(ContactEdit, WhoPlacesTheRootIsSeenAfterAnEditToo) {
  Edits edits(CapsuleOnSlope());
  edits.Make("pins", [](Animation* a) { a->regions[0].touches_scene = false; });
  edits.Make("contact", [](Animation* a) { a->regions[0].touches_scene = true; });
}

// An arm that throws a ball onto a floor.
Animation Thrower() {
  Animation animation = Exact(TurningRod(), kG);
  SetRoot(&animation, kRootZ, 1.0, 0.0);
  KeysOf(&animation, "pivot") = {{0, 0.0, {}, kCubic}, {10, 1.5, {}, kCubic}};
  AddFloor(&animation);
  HeldObject ball;
  ball.name = "ball";
  ball.shape = SphereShape{0.05};
  ball.mass = 0.4;
  ball.holders = {{GroupOf(animation, "pivot"), Vec3(kLength, 0.0, 0.0), 0, 6}};
  ball.touches_scene = true;
  ball.restitution = 0.6;
  animation.held_objects = {ball};
  return animation;
}

TEST(ContactEdit, AThrownBallFeelsWhatItTouchesAndHow) {
  Edits edits(Thrower());
  edits.Make("dead", [](Animation* a) { a->held_objects[0].restitution = 0.0; });
  edits.Make("smooth", [](Animation* a) { a->held_objects[0].friction = 0.0; });
  edits.Make("through", [](Animation* a) { a->held_objects[0].touches_scene = false; });
  edits.Make("not through", [](Animation* a) { a->held_objects[0].touches_scene = true; });
  edits.Make("lower", [](Animation* a) { std::get<Plane>(a->scene[0].shape).offset -= 0.1; });
  edits.Make("thrown harder", [](Animation* a) { KeysOf(a, "pivot")[1].value = 2.0; });
  edits.Make("later", [](Animation* a) { a->held_objects[0].holders[0].last_frame = 8; });
}

// What touches nothing keeps its motion, whatever stands elsewhere.
TEST(ContactEdit, FrictionIsNothingToARegionThatTouchesNothing) {
  Animation animation = ArmOverTable();
  animation.regions[0].touches_scene = false;
  IncrementalBake bake(animation);
  ASSERT_FALSE(bake.Finish());
  const MotionFrame before = bake.motion().frames[24];
  animation.scene[0].friction = 0.1;
  bake.Update(animation);
  ExpectBakedAsAnew(&bake, animation);
  EXPECT_TRUE(IsSame(bake.motion().frames[24], before));
}

}  // namespace
}  // namespace hazumi::test
