#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/dynamics/workspace.h"
#include "engine/timeline/animation.h"
#include "render/motion/figure_skin.h"
#include "render/motion/thing_models.h"
#include "render/scene/scene.h"

namespace hazumi::render {

// What stands for a figure with a skin. One without has links.
enum class FigureLook {
  kSkin,
  kLinks,
  kLinksInSkin,  // the skin is see-through
};

// What is drawn beside the figure and its scene, and how the figure looks.
struct Overlays {
  FigureLook look = FigureLook::kSkin;
  bool bones = false;            // thin lines from joint to joint, seen through what is before them
  std::vector<int> ghosts = {};  // frames, counted from 0, of which a translucent figure is drawn
  bool tells_ghosts = false;     // those before the frame are blue, those after it orange
  bool keyed_ghost = false;      // where a region moves joints: what their keys say, violet
  // Of the CoM, its projection on the ground, every limb's end, and what is thrown.
  bool paths = false;
  bool contact_marks = false;  // a ring at the pinned joint
  bool region_tint = false;    // joints moved by a dynamics region
  bool frame_number = false;
  // By JointIndex: colours of bodies, over which go as much as their alpha says; empty: none.
  std::vector<BoneTint> tints = {};
  std::vector<char> highlighted = {};  // by JointIndex: bodies that stand out; empty: none
};

// Every so many frames from the first one; none if `every` is 0.
std::vector<int> EveryNth(int every, size_t num_frames);

// What a link looks like; one without looks, as its capsule.
std::vector<Look> LooksOf(const Link& link);

// Makes the draw list of each frame of a motion. Animation and motions must outlive it.
class MotionScene {
 public:
  // `path_motion`: the same motion at as many frames a second as the paths shall have points.
  // `skin`: on the animation's figure, or none. `things`: of its held objects; empty: their shapes
  // are drawn.
  MotionScene(const Animation& animation, const Motion& motion, const Motion& path_motion,
              const Camera& camera, const Overlays& overlays, FigureSkin skin = {},
              ThingModels things = {});

  // `index` counts the motion's frames from 0.
  Scene At(int index);

 private:
  void AddWorld(Scene* scene) const;
  // How a figure is drawn: a ghost is see-through, and may have a wash of colour.
  struct Style {
    float alpha = 1.0f;
    bool tints_regions = false;
    bool has_tints = false;  // those of the overlays
    BoneTint wash{0.0f, 0.0f, 0.0f, 0.0f};
  };

  void AddFigure(const MotionFrame& frame, const Style& style, Scene* scene);
  void AddLinks(const MotionFrame& frame, const Style& style, Scene* scene) const;
  void AddSkin(const MotionFrame& frame, const Style& style, Scene* scene) const;
  void AddBones(const MotionFrame& frame, Scene* scene);
  BoneTint TintOf(JointIndex body, const MotionFrame& frame, const Style& style) const;
  bool IsHighlighted(JointIndex body) const;
  void AddLook(const Look& look, const Pose& X_WJ, const SrgbColor& color, Scene* scene) const;
  void AddHeldObjects(const MotionFrame& frame, float alpha, Scene* scene) const;
  void AddGhosts(int index, Scene* scene);
  void AddKeyedGhost(const MotionFrame& frame, Scene* scene);
  void AddPaths(const Vec3& com, Scene* scene) const;
  void AddFlights(size_t object, Scene* scene) const;
  // Where an object of this radius comes down on the scene between two points of its path.
  std::optional<Vec3> LandingBetween(const Vec3& from, const Vec3& to, double radius) const;
  void AddContactMark(const MotionFrame& frame, Scene* scene);
  void CollectPaths();
  double GroundHeight(const Vec3& below) const;

  const Animation& animation_;
  const Motion& motion_;
  const Motion& path_motion_;
  Camera camera_;
  Overlays overlays_;
  FigureSkin skin_;
  ThingModels things_;
  DynamicsWorkspace ws_;
  std::vector<std::vector<Vec3>> end_paths_;  // of every end of the figure, a point a frame
};

}  // namespace hazumi::render
