#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/dynamics/workspace.h"
#include "ui/edit/session/session.h"

namespace hazumi::ui {

// Frames in a row in which the figure is deep in something of the scene.
struct Sinking {
  int first = 0, last = 0;  // frames, both inclusive
  int deepest = 0;          // frame
  double depth = 0.0;       // there [m], more than kDeep
  GroupIndex joint;         // nearest to the deepest place
};

// Finds frames in which keys or a pin put the figure into the ground. What gravity places touches
// by itself and is not looked at, nor what a constraint holds on to. A frame is looked at again
// only when the pose there is another one, and few at a time, so that it costs a redraw next to
// nothing.
class GroundWatch {
 public:
  static constexpr double kDeep = 0.01;  // less is not worth a word [m]

  // Looks at no more than `most` frames that it does not know yet.
  void Look(edit::Session* session, int most);
  // It knows all frames of the document as it was when it looked last.
  bool is_done() const { return is_done_; }

  // Among the frames known so far.
  const std::vector<Sinking>& sinkings() const { return sinkings_; }

 private:
  struct Known {
    VecX q;
    Pose X_WR;
    double depth = 0.0;  // [m]; 0 if it is not in anything
    GroupIndex joint;
  };
  // A document as it is between two edits.
  struct Version {
    long document = -1, revision = -1;
    bool operator==(const Version&) const = default;
  };
  // Forgets what is known of another figure or scene.
  void Begin(const Animation& animation, const Project& project, size_t num_frames);
  Known LookAt(const MotionFrame& frame, DynamicsWorkspace* ws) const;
  void Collect(const std::vector<PlacementSpan>& placements, int first_frame);

  Version seen_;
  bool is_done_ = true;
  std::shared_ptr<const Figure> figure_;
  std::vector<SceneObject> scene_;
  std::vector<std::optional<Known>> known_;  // by frame from the animation's first one on
  std::vector<Sinking> sinkings_;
};

}  // namespace hazumi::ui
