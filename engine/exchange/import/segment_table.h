#pragma once

#include "engine/body/body_part.h"

namespace hazumi {

// What the table of a body's masses has a row for.
enum class BodySegment {
  kHead,         // and the neck
  kUpperTrunk,   // cervicale to xiphion
  kMiddleTrunk,  // to omphalion
  kLowerTrunk,   // to the middle of the hip joints
  kUpperArm,
  kForearm,
  kHand,
  kThigh,
  kShank,
  kFoot,
  kTrunk,  // somewhere in it: its height says in which part
  kNone,
};
inline constexpr int kNumRows = static_cast<int>(BodySegment::kFoot) + 1;  // of the table

// kNone for kOther; collars and hip joints are parts of the trunk.
BodySegment SegmentOf(BodyPart part);
// Whether there is one on each side.
bool IsLimb(BodySegment segment);

struct SegmentRow {
  double mass;       // share of the whole body's: of one arm, of one leg
  double com;        // of the way from its near end (the trunk's: its lower one) to the far one
  double trunk_end;  // of the trunk's parts: the upper end, of the way from MIDH to CERV
};
// [de Leva 1996, male]. Not for kTrunk and kNone.
const SegmentRow& RowOf(BodySegment segment);

}  // namespace hazumi
