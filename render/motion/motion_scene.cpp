#include "render/motion/motion_scene.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "engine/dynamics/inverse_dynamics.h"
#include "engine/dynamics/kinematics.h"
#include "engine/timeline/curve_track.h"
#include "render/motion/object_scene.h"

namespace hazumi::render {

namespace {

constexpr SrgbColor kRegionAccent = FromHex(0x2f8fff);
constexpr SrgbColor kHighlight = FromHex(0xffbe33);
constexpr SrgbColor kComPath = FromHex(0xffbe33);
constexpr SrgbColor kPinMark = FromHex(0xff3352);
constexpr SrgbColor kBoneLine = FromHex(0xf4f6f8, 0.9f);
constexpr float kRegionShare = 0.45f, kHighlightShare = 0.5f;
constexpr float kGhostAlpha = 0.16f, kToldGhostAlpha = 0.24f, kKeyedAlpha = 0.3f;
constexpr SrgbColor kGhostBefore = FromHex(0x2f6fe0), kGhostAfter = FromHex(0xf08a24);
constexpr SrgbColor kKeyed = FromHex(0x8e4fd0);
constexpr float kWashShare = 0.75f;
constexpr double kSeenTurn = 0.002;  // [rad]: 1 mm at the hand
constexpr float kSkinOverLinksAlpha = 0.35f;
constexpr double kShortestBone = 1e-6;  // hinges of one group are in one place [m]
constexpr double kLift = 0.004;         // of flat marks above the ground [m]

SrgbColor Mix(const SrgbColor& a, const SrgbColor& b, float share_of_b) {
  const float s = share_of_b, r = 1.0f - s;
  return {r * a.r + s * b.r, r * a.g + s * b.g, r * a.b + s * b.b, a.a};
}

// The far end of the body on an end joint: the tip of its longest capsule.
Vec3 TipOf(const Figure& figure, JointIndex end) {
  Vec3 tip = Vec3::Zero();
  for (const Link& link : figure.links()) {
    if (link.joint == end && link.capsule.b.norm() > tip.norm()) tip = link.capsule.b;
  }
  return tip;
}

// A colour for each end, so that left and right can be told apart.
SrgbColor EndColor(size_t i) {
  constexpr std::uint32_t kColors[] = {0x8bdc00, 0xff3352, 0x2890ff, 0xc678dd, 0x56c8b4, 0xe5884d};
  return FromHex(kColors[i % std::size(kColors)], 0.9f);
}

BoneTint Wash(SrgbColor color) {
  color.a = kWashShare;
  return color;
}

}  // namespace

std::vector<int> EveryNth(int every, size_t num_frames) {
  std::vector<int> frames;
  for (size_t i = 0; every > 0 && i < num_frames; i += static_cast<size_t>(every)) {
    frames.push_back(static_cast<int>(i));
  }
  return frames;
}

std::vector<Look> LooksOf(const Link& link) {
  if (!link.looks.empty()) return link.looks;
  Look capsule;
  capsule.from = link.capsule.a;
  capsule.to = link.capsule.b;
  capsule.radius_from = capsule.radius_to = link.capsule.radius;
  capsule.color = "#c8a27a";
  return {capsule};
}

MotionScene::MotionScene(const Animation& animation, const Motion& motion,
                         const Motion& path_motion, const Camera& camera, const Overlays& overlays,
                         FigureSkin skin, ThingModels things)
    : animation_(animation),
      motion_(motion),
      path_motion_(path_motion),
      camera_(camera),
      overlays_(overlays),
      skin_(std::move(skin)),
      things_(std::move(things)),
      ws_(*animation.figure) {
  if (overlays_.paths) CollectPaths();
}

Scene MotionScene::At(int index) {
  const MotionFrame& frame = motion_.frames[index];
  Scene scene;
  scene.camera = camera_;
  AddWorld(&scene);
  AddFigure(frame, {.tints_regions = overlays_.region_tint, .has_tints = !overlays_.tints.empty()},
            &scene);
  AddHeldObjects(frame, 1.0f, &scene);
  AddGhosts(index, &scene);
  if (overlays_.keyed_ghost) AddKeyedGhost(frame, &scene);
  if (overlays_.bones) AddBones(frame, &scene);
  if (overlays_.paths) {
    AddPaths(frame.com, &scene);
    for (size_t i = 0; i < animation_.held_objects.size(); ++i) AddFlights(i, &scene);
  }
  if (overlays_.contact_marks) AddContactMark(frame, &scene);
  if (overlays_.frame_number) {
    scene.captions.push_back({"F" + std::to_string(frame.frame), Corner::kTopLeft, 20.0});
  }
  return scene;
}

void MotionScene::AddWorld(Scene* scene) const {
  scene->ground.visible = false;
  for (const SceneObject& object : animation_.scene) AddSceneObject(object, scene);
}

void MotionScene::AddFigure(const MotionFrame& frame, const Style& style, Scene* scene) {
  ComputePositions(*animation_.figure, frame.X_WR, frame.q, &ws_);
  if (skin_ && overlays_.look != FigureLook::kLinks) {
    const bool shows_links = overlays_.look == FigureLook::kLinksInSkin;
    Style of_skin = style;
    if (shows_links) of_skin.alpha *= kSkinOverLinksAlpha;
    AddSkin(frame, of_skin, scene);
    if (!shows_links) return;
  }
  AddLinks(frame, style, scene);
}

void MotionScene::AddLinks(const MotionFrame& frame, const Style& style, Scene* scene) const {
  for (const Link& link : animation_.figure->links()) {
    const BodyScratch& body = ws_.body(link.joint);
    const BoneTint over = TintOf(link.joint, frame, style);
    for (const Look& look : LooksOf(link)) {
      SrgbColor color = Mix(ColorFromText(look.color), over, over.a);
      color.a = style.alpha;
      AddLook(look, {body.R, body.p}, color, scene);
    }
  }
}

// Where bodies of different tints meet, the skin takes of each what its weights say.
void MotionScene::AddSkin(const MotionFrame& frame, const Style& style, Scene* scene) const {
  SkinnedFigure skin{skin_.model, skin_.PosesIn(*animation_.figure, frame.q, ws_), {}, style.alpha};
  for (const FigureBone& bone : skin_.bones) {
    skin.tints.push_back(TintOf(bone.body, frame, style));
  }
  scene->skins.push_back(std::move(skin));
}

void MotionScene::AddBones(const MotionFrame& frame, Scene* scene) {
  const Figure& figure = *animation_.figure;
  ComputePositions(figure, frame.X_WR, frame.q, &ws_);
  const auto add = [&](const Vec3& from, const Vec3& to) {
    scene->polylines.push_back({{from, to}, 1.5, kBoneLine, 0.0, true});
  };
  for (int i = 0; i < figure.num_joints(); ++i) {
    const JointIndex parent = figure.joint(JointIndex(i)).parent;
    const Vec3& from = parent.is_valid() ? ws_.body(parent).p : ws_.bodies[0].p;
    const Vec3& to = ws_.body(JointIndex(i)).p;
    if ((to - from).norm() > kShortestBone) add(from, to);
  }
  for (const JointIndex end : EndJoints(figure)) {
    const BodyScratch& body = ws_.body(end);
    add(body.p, body.p + body.R * TipOf(figure, end));
  }
}

// The accent of a region or a tint of its own, and over it that of what is highlighted; a ghost has
// its wash alone.
BoneTint MotionScene::TintOf(JointIndex body, const MotionFrame& frame, const Style& style) const {
  BoneTint over = style.wash;
  if (style.tints_regions && body.is_valid() && frame.in_region[body.value()]) {
    over = kRegionAccent;
    over.a = kRegionShare;
  }
  if (style.has_tints && body.is_valid() && overlays_.tints[body.value()].a > 0.0f) {
    over = overlays_.tints[body.value()];
  }
  if (style.alpha < 1.0f || !IsHighlighted(body)) return over;
  SrgbColor highlight = kHighlight;
  highlight.a = kHighlightShare;
  return LaidOver(highlight, over);
}

bool MotionScene::IsHighlighted(JointIndex body) const {
  return body.is_valid() && !overlays_.highlighted.empty() && overlays_.highlighted[body.value()];
}

void MotionScene::AddLook(const Look& look, const Pose& X_WJ, const SrgbColor& color,
                          Scene* scene) const {
  if (look.shape == Look::Shape::kTaperedCapsule) {
    scene->capsules.push_back(
        {X_WJ * look.from, X_WJ * look.to, look.radius_from, look.radius_to, color});
  } else {
    scene->ellipsoids.push_back({{X_WJ.R, X_WJ * look.center}, look.half_axes, color});
  }
}

void MotionScene::AddHeldObjects(const MotionFrame& frame, float alpha, Scene* scene) const {
  for (size_t i = 0; i < frame.objects.size(); ++i) {
    const Pose& X_WO = frame.objects[i].X_WO;
    if (i < things_.size() && things_[i]) {
      const size_t num_bones = things_[i]->skin->bones.size();
      scene->skins.push_back({things_[i], std::vector<Pose>(num_bones, X_WO), {}, alpha});
    } else {
      AddHeldObject(animation_.held_objects[i], X_WO, alpha, scene);
    }
  }
}

void MotionScene::AddGhosts(int index, Scene* scene) {
  for (const int i : overlays_.ghosts) {
    if (i == index || i < 0 || i >= static_cast<int>(motion_.frames.size())) continue;
    Style style{.alpha = kGhostAlpha};
    if (overlays_.tells_ghosts) {
      style = {.alpha = kToldGhostAlpha, .wash = Wash(i < index ? kGhostBefore : kGhostAfter)};
    }
    AddFigure(motion_.frames[i], style, scene);
    AddHeldObjects(motion_.frames[i], kGhostAlpha, scene);
  }
}

// It stands where the figure does, only the joints are those of the keys; of its links those are
// drawn that are elsewhere.
void MotionScene::AddKeyedGhost(const MotionFrame& frame, Scene* scene) {
  MotionFrame keyed = frame;
  const Figure& figure = *animation_.figure;
  for (int j = 0; j < figure.num_joints(); ++j) {
    if (!frame.in_region[static_cast<size_t>(j)]) continue;
    CurveTrack track(&animation_.joint_keys[static_cast<size_t>(j)], animation_.rate,
                     figure.joints()[static_cast<size_t>(j)].rest, {});
    keyed.q[j] = track.At(frame.frame).value;
  }
  const auto pose_of = [&](const Link& link) {
    const BodyScratch& body = ws_.body(link.joint);
    return Pose{body.R, body.p};
  };
  std::vector<Pose> seen;
  ComputePositions(figure, frame.X_WR, frame.q, &ws_);
  for (const Link& link : figure.links()) seen.push_back(pose_of(link));
  ComputePositions(figure, keyed.X_WR, keyed.q, &ws_);
  for (size_t i = 0; i < seen.size(); ++i) {
    const Link& link = figure.links()[i];
    const Pose X_WJ = pose_of(link);
    if ((X_WJ.R - seen[i].R).norm() + (X_WJ.p - seen[i].p).norm() < kSeenTurn) continue;
    for (const Look& look : LooksOf(link)) {
      SrgbColor color = Mix(ColorFromText(look.color), kKeyed, kWashShare);
      color.a = kKeyedAlpha;
      AddLook(look, X_WJ, color, scene);
    }
  }
}

void MotionScene::CollectPaths() {
  const Figure& figure = *animation_.figure;
  const std::vector<JointIndex> ends = EndJoints(figure);
  end_paths_.resize(ends.size());
  for (const MotionFrame& frame : path_motion_.frames) {
    ComputePositions(figure, frame.X_WR, frame.q, &ws_);
    for (size_t i = 0; i < ends.size(); ++i) {
      const BodyScratch& body = ws_.body(ends[i]);
      end_paths_[i].push_back(body.p + body.R * TipOf(figure, ends[i]));
    }
  }
}

void MotionScene::AddPaths(const Vec3& com, Scene* scene) const {
  const auto below = [this](const Vec3& p) { return Vec3(p.x(), p.y(), GroundHeight(p) + kLift); };
  std::vector<Vec3> path, on_ground;
  for (const MotionFrame& frame : path_motion_.frames) {
    path.push_back(frame.com);
    on_ground.push_back(below(frame.com));
  }
  scene->polylines.push_back({path, 2.5, kComPath, 0.0, true});
  scene->polylines.push_back({on_ground, 2.0, kComPath, 0.03, false});
  scene->markers.push_back({MarkerShape::kCenterOfMass, com, 0.035, kComPath, 2.0, true});
  scene->markers.push_back({MarkerShape::kCross, below(com), 0.05, kComPath, 2.0, false});
  for (size_t i = 0; i < end_paths_.size(); ++i) {
    scene->polylines.push_back({end_paths_[i], 1.5, EndColor(i), 0.0, false});
  }
}

// From where it is let go to the next holder, to where it lies, or to the floor, which is marked.
void MotionScene::AddFlights(size_t object, Scene* scene) const {
  const HeldObject& thrown = animation_.held_objects[object];
  const SrgbColor color = ColorFromText(thrown.color);
  const auto* sphere = std::get_if<SphereShape>(&thrown.shape);
  const double radius = sphere ? sphere->radius : 0.0;
  constexpr double kStill = 1e-6, kDash = 0.03;  // [m]
  std::vector<Vec3> path;
  const auto end = [&] {
    if (path.size() > 1) scene->polylines.push_back({path, 2.0, color, kDash, true});
    path.clear();
  };
  bool has_landed = false;
  for (const MotionFrame& frame : motion_.frames) {
    if (object >= frame.objects.size()) break;  // not computed yet
    const ObjectPose& pose = frame.objects[object];
    const Vec3 p = pose.X_WO.p;
    if (pose.is_held()) {
      end();
      path = {p};
      has_landed = false;
      continue;
    }
    if (path.empty() || has_landed || (p - path.back()).norm() < kStill) continue;
    if (const std::optional<Vec3> touch = LandingBetween(path.back(), p, radius)) {
      path.push_back(*touch);
      const Vec3 mark = *touch + (kLift - radius) * Vec3::UnitZ();
      scene->markers.push_back({MarkerShape::kCross, mark, 0.06, color, 2.0, true});
      has_landed = true;
    } else {
      path.push_back(p);
    }
  }
  end();
}

// To where its keys say that it lies, too. What is below the start need not be below where it would
// touch, nor the other way round.
std::optional<Vec3> MotionScene::LandingBetween(const Vec3& from, const Vec3& to,
                                                double radius) const {
  constexpr double kTouch = 1e-6;  // [m]
  std::optional<Vec3> landing;
  for (const Vec3& above : {from, Vec3(to.x(), to.y(), from.z())}) {
    const double floor = GroundHeight(above) + radius;
    if (from.z() < floor + kTouch || to.z() > floor + kTouch) continue;
    const Vec3 touch = from + (from.z() - floor) / (from.z() - to.z()) * (to - from);
    const bool is_there = GroundHeight({touch.x(), touch.y(), from.z()}) + radius == floor;
    if (is_there && (!landing || touch.z() > landing->z())) landing = touch;
  }
  return landing;
}

void MotionScene::AddContactMark(const MotionFrame& frame, Scene* scene) {
  if (!frame.pinned) return;
  ComputePositions(*animation_.figure, frame.X_WR, frame.q, &ws_);
  Vec3 mark = ws_.body(animation_.figure->group(*frame.pinned).first).p;
  mark.z() = GroundHeight(mark) + kLift;
  scene->markers.push_back({MarkerShape::kRing, mark, 0.07, kPinMark, 3.0, false});
}

// The highest level floor or box top below a point; 0 if there is none.
double MotionScene::GroundHeight(const Vec3& below) const {
  double height = 0.0;
  bool found = false;
  for (const SceneObject& object : animation_.scene) {
    const std::optional<double> top = TopBelow(object, below);
    if (!top || (found && *top <= height)) continue;
    height = *top;
    found = true;
  }
  return height;
}

}  // namespace hazumi::render
