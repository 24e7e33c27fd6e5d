#include "ui/panels/viewport/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "engine/spatial/degrees.h"
#include "render/motion/motion_scene.h"
#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/effort.h"
#include "ui/panels/viewport/figure.h"
#include "ui/panels/viewport/overlays.h"

namespace hazumi::ui {

namespace {

// Of a path, for each frame.
constexpr double kMostTurn = 4.0 * kDegree;  // from point to point [rad]
constexpr int kLeastParts = 2, kMostParts = 32;

// Cubic from `a` to `b` with derivatives `da` and `db` with respect to t in [0, 1].
template <typename V>
V Hermite(const V& a, const V& da, const V& b, const V& db, double t) {
  const double s = 1.0 - t;
  return s * s * (1.0 + 2.0 * t) * a + s * s * t * da + t * t * (3.0 - 2.0 * t) * b -
         t * t * s * db;
}

MotionFrame Between(const MotionFrame& a, const MotionFrame& b, double seconds, double t) {
  MotionFrame frame;
  frame.frame = a.frame;
  frame.q = Hermite<VecX>(a.after.q, seconds * a.after.qd, b.before.q, seconds * b.before.qd, t);
  frame.X_WR.p = Hermite<Vec3>(a.after.X_WR.p, seconds * a.after.root_v, b.before.X_WR.p,
                               seconds * b.before.root_v, t);
  const Eigen::Quaterniond from(a.after.X_WR.R), to(b.before.X_WR.R);
  frame.X_WR.R = from.slerp(t, to).toRotationMatrix();
  return frame;
}

// The farthest that any joint or the root turns from one frame to the next, by its angles or by its
// rates [rad].
double TurnBetween(const MotionFrame& a, const MotionFrame& b, double seconds) {
  const double by_angle = (b.before.q - a.after.q).lpNorm<Eigen::Infinity>();
  const double by_rate = seconds * std::max(a.after.qd.lpNorm<Eigen::Infinity>(),
                                            b.before.qd.lpNorm<Eigen::Infinity>());
  const double of_root = seconds * std::max(a.after.root_w.norm(), b.before.root_w.norm());
  return std::max({by_angle, by_rate, of_root});
}

// Frames whose motion is wanted, counted from the first one.
struct Window {
  int first, last;
};

Window WindowOf(const Editor& editor) {
  const int now = FrameShown(editor) - editor.first_frame();
  const ViewportOverlays& wanted = editor.viewport.overlays;
  const int reach = wanted.paths ? wanted.reach : 0;
  const int before = std::max(reach, wanted.ghosts ? wanted.ghosts_before : 0);
  const int after = std::max(reach, wanted.ghosts ? wanted.ghosts_after : 0);
  return {std::max(now - before, 0),
          std::min(now + after, editor.last_frame() - editor.first_frame())};
}

// All hinges of a joint if one of them is selected: the body is beyond the last.
std::vector<char> Highlighted(const edit::Session& session) {
  const Figure& figure = session.figure();
  std::vector<char> joints(static_cast<size_t>(figure.num_joints()), 0);
  for (const GroupIndex g : SelectedJoints(session)) {
    const JointGroup& group = figure.group(g);
    std::fill_n(joints.begin() + group.first.value(), group.size, 1);
  }
  return joints;
}

// Frames with a key, counted from the first one, in order.
std::vector<int> KeyFrames(const Editor& editor) {
  std::set<int> frames;
  const Project& project = editor.session().project();
  const auto add = [&](const ProjectCurve& curve) {
    for (const ProjectKey& key : curve.keys) {
      frames.insert(static_cast<int>(std::lround(key.frame)) - editor.first_frame());
    }
  };
  for (const auto& joint : project.joints) add(joint.value);
  for (const ProjectCurve& curve : project.root.curves) add(curve);
  return {frames.begin(), frames.end()};
}

render::Overlays OverlaysOf(const Editor& editor) {
  const ViewportOverlays& wanted = editor.viewport.overlays;
  render::Overlays overlays;
  overlays.look = LookOf(wanted);
  overlays.ghosts = GhostFrames(wanted, FrameShown(editor) - editor.first_frame(),
                                editor.last_frame() - editor.first_frame(), KeyFrames(editor));
  overlays.tells_ghosts = true;
  overlays.keyed_ghost = wanted.keyed;
  overlays.paths = wanted.paths;
  overlays.contact_marks = wanted.marks;
  overlays.region_tint = wanted.tint;
  overlays.highlighted = Highlighted(editor.session());
  const FrameEffort* effort = wanted.effort ? editor.effort.At(FrameShown(editor)) : nullptr;
  if (effort) overlays.tints = EffortTints(editor.session().figure(), *effort);
  return overlays;
}

// Lines in a scene are paths; a dashed one is the shadow of another.
std::vector<PathTicks> TicksOf(const render::Scene& scene, const std::vector<size_t>& at_frames) {
  std::vector<PathTicks> all;
  for (const render::Polyline& path : scene.polylines) {
    if (path.dash_m > 0.0) continue;
    PathTicks ticks = {path.color, {}};
    for (const size_t i : at_frames) ticks.points.push_back(path.points[i]);
    all.push_back(std::move(ticks));
  }
  return all;
}

}  // namespace

render::FigureLook LookOf(const ViewportOverlays& overlays) {
  return overlays.skin ? render::FigureLook::kSkin : render::FigureLook::kLinks;
}

RefinedMotion Refined(const Motion& motion, int first, int last) {
  RefinedMotion refined;
  refined.motion.rate = motion.rate;
  std::vector<MotionFrame>& frames = refined.motion.frames;
  const double seconds = motion.rate.seconds_per_frame();
  const auto com = [&](int i) { return motion.frames[std::clamp(i, first, last)].com; };
  for (int i = first; i < last; ++i) {
    refined.at_frames.push_back(frames.size());
    const MotionFrame &a = motion.frames[i], &b = motion.frames[i + 1];
    const Vec3 slope = 0.5 * (com(i + 1) - com(i - 1)), next = 0.5 * (com(i + 2) - com(i));
    const double turns = std::ceil(TurnBetween(a, b, seconds) / kMostTurn);
    const int parts = static_cast<int>(std::clamp<double>(turns, kLeastParts, kMostParts));
    for (int k = 0; k < parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      frames.push_back(Between(a, b, seconds, t));
      frames.back().com = Hermite<Vec3>(com(i), slope, com(i + 1), next, t);
    }
  }
  refined.at_frames.push_back(frames.size());
  frames.push_back(motion.frames[last]);
  return refined;
}

int FrameShown(const Editor& editor) {
  return std::clamp(static_cast<int>(std::lround(editor.session().frame())), editor.first_frame(),
                    editor.last_frame());
}

PictureKey KeyNow(const Editor& editor, render::PictureSize size) {
  const edit::Session& session = editor.session();
  PictureKey key;
  key.document = session.document_number();
  key.revision = session.document().revision();
  key.frame = FrameShown(editor);
  key.camera = editor.viewport.camera;
  key.through_project_camera = editor.viewport.through_project_camera;
  key.overlays = editor.viewport.overlays;
  key.width = size.width;
  key.height = size.height;
  key.selected_joints = session.selected_joints();
  key.has_film = editor.film.is_there();
  if (key.overlays.effort) key.effort = editor.effort.number();
  key.is_being_computed = session.bake() && session.bake()->is_busy();
  return key;
}

Result<ViewportScene> SceneNow(Editor* editor, const Rect& rect) {
  edit::Session& session = editor->session();
  const int first = editor->first_frame();
  const Window window = WindowOf(*editor);
  const Result<const Motion*> motion = session.ShownMotionTo(first + window.last);
  if (!motion.ok()) return motion.error();
  RefinedMotion paths;
  if (editor->viewport.overlays.paths) {
    paths = Refined(*motion.value(), window.first, window.last);
  }
  const Result<render::FigureSkin> skin =
      editor->skins.On(session.figure(), session.project().skin.meshes());
  if (!skin.ok()) return skin.error();
  const Result<render::ThingModels> things = editor->things.Of(session.animation()->held_objects);
  if (!things.ok()) return things.error();
  render::MotionScene scene(*session.animation(), *motion.value(), paths.motion,
                            CameraNow(editor->viewport, session.project(), rect),
                            OverlaysOf(*editor), skin.value(), things.value());
  ViewportScene shown;
  shown.scene = scene.At(FrameShown(*editor) - first);
  editor->film.AddTo(session, FrameShown(*editor), &shown.scene);
  shown.ticks = TicksOf(shown.scene, paths.at_frames);
  return shown;
}

}  // namespace hazumi::ui
