#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/panels/dope_sheet/muscle.h"
#include "ui/panels/sheet/frame.h"

namespace hazumi::ui {

enum class RowKind { kSummary, kPlacement, kRoot, kLimb, kJoint, kCurve, kObject };

// A row of the dope sheet: the curves whose keys it shows.
struct SheetRow {
  RowKind kind;
  std::string id;  // of its own: "limb r_shoulder", "joint r_shoulder", "r_shoulder_flexion"
  std::string name;
  int depth = 0;
  bool has_parts = false, is_open = false;
  std::vector<std::string> curves = {};
  std::vector<JointIndex> hinges = {};
  // Joint references of a region on this row: "r_shoulder+", or the root; empty for rows that no
  // region moves.
  std::vector<std::string> refs = {};
  ItemId object = {};  // object of an object row
};
// Returns whether a row shows the placement, the orientation of the root, or one of their curves.
bool IsOfRoot(const SheetRow& row);
std::vector<SheetRow> SheetRows(const edit::Session& session, const SheetState& state);

// The keys of a row on one frame.
struct RowKey {
  int row = 0;
  double frame = 0.0;
  Point at = {};
  std::optional<Interpolation> interpolation = {};  // none: they differ
  KeyType type = KeyType::kKeyframe;                // that too where they differ
  bool is_selected = false;                         // any of them
};

// A region, what places the figure, or a hold, on a row. Those that overlap in time lie in lanes,
// one below the other.
struct RowBar {
  int row = 0;
  BarRef ref;
  int lane = 0;
  Rect rect = {};
  int num_held = 0, num_hinges = 0;  // regions: of the row's hinges
  RowMuscle muscle = {};             // regions that are not muted: of those it holds
  bool touches = false;              // regions that are not muted: the scene
};
// What of it is filled with muscle, from its lower edge on.
Rect StripOf(const RowBar& bar);

struct DopeSheetLayout {
  SheetFrame frame;
  std::vector<SheetRow> rows;
  std::vector<Rect> row_rects;  // over the whole width
  std::vector<RowKey> keys;     // that can be seen
  std::vector<RowBar> bars;
  float content_height = 0.0f;  // of all rows
};
DopeSheetLayout LayOutDopeSheet(const edit::Session& session, const SheetState& state,
                                const Rect& rect, double scale);

enum class SheetPart {
  kNothing,
  kCorner,
  kRuler,
  kMarker,
  kArrow,  // that opens a row
  kName,
  kTrack,
  kKey,
  kBar,
  kBarStart,
  kBarEnd,
  kBarStrength  // the upper edge of its muscle
};

// What is under a point.
struct SheetHit {
  SheetPart part = SheetPart::kNothing;
  int index = -1;  // of keys, bars or markers
  int row = -1;
};
SheetHit HitDopeSheet(const DopeSheetLayout& layout, const edit::Session& session, Point p);
// The row at a height, or the nearest one.
int NearestRow(const DopeSheetLayout& layout, float y);

// Curves and frames, in pairs, as the operator "keys.select" takes them.
struct KeyList {
  std::vector<std::string> curves;
  std::vector<double> frames;
};
// The keys that one mark stands for.
KeyList KeysOf(const DopeSheetLayout& layout, const RowKey& key, const Project& project);
// The keys whose marks lie in a rectangle.
KeyList KeysIn(const DopeSheetLayout& layout, const Rect& box, const Project& project);

// A region over some rows: what it is called and what it names. The rows from first to last.
struct RegionOnRows {
  std::string name;
  std::vector<std::string> joints;
};
RegionOnRows RegionOn(const DopeSheetLayout& layout, int first_row, int last_row);
// Adds the root to a region that has all hinges of the figure, since a body that is released as a
// whole rotates as it falls.
RegionOnRows WithRootOfWhole(RegionOnRows region, const Figure& figure);

}  // namespace hazumi::ui
