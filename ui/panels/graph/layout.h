#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/project/edits/curves.h"
#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/graph/torque.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// A curve of the graph. Values are degrees, of positions metres.
struct GraphCurve {
  std::string name;
  int color = 0;  // index of CurveColor
  bool is_hidden = false;
  std::optional<JointIndex> hinge;
  std::optional<ObjectCurve> object;  // neither: of the root
  int root_curve = 0;
  // Shown at (value - middle) * stretch: as it is, or normalized to [-1, 1].
  double middle = 0.0, stretch = 1.0;
  // The motion as it is baked: points in frames and values, and which of the lines between them a
  // region computed.
  std::vector<std::pair<double, double>> points;
  std::vector<char> is_computed;  // one fewer
};

struct GraphKey {
  int curve = 0;
  double frame = 0.0, value = 0.0;
  double rate_before = 0.0, rate = 0.0;  // per second
  Interpolation interpolation = Interpolation::kCubic;
  KeyType type = KeyType::kKeyframe;
  bool is_broken = false;  // its sides turn by themselves
  // Of the tangents, before and after: shares of the frames to the key there, if they are said.
  std::array<std::optional<double>, 2> lengths = {};
  std::array<double, 2> frames_beside = {};  // to the keys before and after; 0: none
  bool is_selected = false;
  Point at = {};
  // Of selected keys whose rate counts: left and right.
  std::optional<std::array<Point, 2>> handles = {};
};

struct GraphLayout {
  SheetFrame frame;
  ValueRange values;  // shown, from the lower to the upper edge
  double frames_per_second = 30.0;
  std::vector<GraphCurve> curves;
  std::vector<GraphKey> keys;
  Rect torque_toggle;                 // shows the torques, or hides them
  std::optional<TorquePanel> torque;  // below the curves

  float YOf(double shown) const;
  double ShownAt(float y) const;
  Point At(const GraphCurve& curve, double frame, double value) const;
  Rect NameRect(int curve) const;
};
// `motion` may be null: then there are only keys. `fits`: the values follow the curves, else they
// are the state's.
GraphLayout LayOutGraph(const edit::Session& session, const Motion* motion, const SheetState& state,
                        bool fits, const Rect& rect, double scale);
// With the values that are seen at the moment, or those that fit, and with torques if they are
// wanted.
GraphLayout CurrentGraph(Editor* editor, bool fits = false);

// Curves of the selected joints, else of the selected keys, else those that were shown last.
std::vector<std::string> ShownCurves(const edit::Session& session, const SheetState& state);

enum class GraphPart {
  kNothing,
  kCorner,
  kRuler,
  kName,
  kTrack,
  kKey,
  kHandle,
  kTorqueToggle,
  kTorque
};
struct GraphHit {
  GraphPart part = GraphPart::kNothing;
  int index = -1;  // of keys or curves
  int side = 0;    // of a handle: 0 left, 1 right
};
GraphHit HitGraph(const GraphLayout& layout, Point p);

// The rate that a handle pulled to a point gives its key [per second].
double RateTowards(const GraphLayout& layout, const GraphKey& key, int side, Point p);
// The length that it gives, which lies in kTangentLength; none where keys beside it say no length.
std::optional<double> LengthTowards(const GraphLayout& layout, const GraphKey& key, int side,
                                    Point p);

KeyList GraphKeysIn(const GraphLayout& layout, const Rect& box);
// What a pixel upwards adds to the values of the selected keys.
double ValuePerPx(Editor* editor);
// Shows the values of these keys.
void FrameValues(Editor* editor, const KeySelection& keys);

}  // namespace hazumi::ui
