// The body's masses. [de Leva 1996, Table 4, male; his landmarks in brackets]
// Shares add up to 1: 0.0694 + 0.4346 + 2 (0.0271 + 0.0162 + 0.0061 + 0.1416 + 0.0433 + 0.0137).
// The trunk's parts are 0.2421, 0.2155 and 0.1457 m long in a man of 1.741 m.

#include "engine/exchange/import/segment_table.h"

namespace hazumi {

namespace {

constexpr SegmentRow kRows[kNumRows] = {
    {0.0694, 0.5, 0.0},        // CERV to VERT
    {0.1596, 0.4934, 1.0},     // XYPH to CERV
    {0.1633, 0.5498, 0.5987},  // OMPH to XYPH
    {0.1117, 0.3885, 0.2415},  // MIDH to OMPH
    {0.0271, 0.5772, 0.0},     // SJC to EJC
    {0.0162, 0.4574, 0.0},     // EJC to WJC
    {0.0061, 0.3624, 0.0},     // WJC to DAC3
    {0.1416, 0.4095, 0.0},     // HJC to KJC
    {0.0433, 0.4395, 0.0},     // KJC to AJC
    {0.0137, 0.4415, 0.0},     // HEEL to TTIP
};

}  // namespace

BodySegment SegmentOf(BodyPart part) {
  switch (part) {
    case BodyPart::kPelvis:
    case BodyPart::kTrunk:
      return BodySegment::kTrunk;
    case BodyPart::kNeck:
    case BodyPart::kHead:
      return BodySegment::kHead;
    case BodyPart::kUpperArm:
      return BodySegment::kUpperArm;
    case BodyPart::kForearm:
      return BodySegment::kForearm;
    case BodyPart::kHand:
      return BodySegment::kHand;
    case BodyPart::kThigh:
      return BodySegment::kThigh;
    case BodyPart::kShank:
      return BodySegment::kShank;
    case BodyPart::kFoot:
      return BodySegment::kFoot;
    case BodyPart::kOther:
      break;
  }
  return BodySegment::kNone;
}

bool IsLimb(BodySegment segment) {
  return segment >= BodySegment::kUpperArm && segment <= BodySegment::kFoot;
}

const SegmentRow& RowOf(BodySegment segment) { return kRows[static_cast<int>(segment)]; }

}  // namespace hazumi
