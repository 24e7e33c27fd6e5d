// Limits that the human has not: clavicle after Neumann, Kinesiology of the Musculoskeletal System:
// elevation 45, depression 10, protraction and retraction 15 to 30 degrees; fingers, ours, from the
// sum of a finger's joints (AAOS: 90, 100, 90 degrees).

#include "engine/exchange/import/body_hinges.h"

#include <algorithm>
#include <string_view>

#include "engine/project/figure_file.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr double kBeyondClip = 2.0 * kDegree;  // where it goes farther than people do
constexpr double kFixed = 1e-3 * kDegree;      // a hinge that turns less is fixed
constexpr double kHuman = 70.0 * 1.7;          // mass times height of human.json [kg m]

struct Row {
  const char* name;
  Vec3 axis;                        // on the right side, and in the middle
  double lower = 0.0, upper = 0.0;  // [deg]; 0, 0: those of the human's hinge
};

struct Part {
  const char* joint = "";  // of the human
  double begin = 0.0, end = 1.0;
};

struct Rows {
  BodyRole role;
  std::vector<Part> human;
  std::array<Row, 3> hinges;
};

const std::vector<Rows>& AllRows() {
  static const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  static const std::array<Row, 3> trunk = {Row{"flexion", y}, Row{"bend", x}, Row{"rotation", z}};
  static const std::vector<Rows> rows = {
      {BodyRole::kSpine, {{"waist", 0.0, 0.5}, {"chest", 0.5, 1.0}}, trunk},
      {BodyRole::kNeck, {{"neck"}}, trunk},
      {BodyRole::kHead, {{"neck"}}, trunk},
      {BodyRole::kClavicle,
       {},
       {Row{"protraction", z, -20.0, 30.0}, Row{"elevation", -x, -10.0, 45.0},
        Row{"rotation", -y}}},
      {BodyRole::kUpperArm,
       {{"r_shoulder"}},
       {Row{"flexion", -y}, Row{"rotation", -z}, Row{"abduction", -x}}},
      {BodyRole::kForearm,
       {{"r_elbow"}},
       {Row{"flexion", -y}, Row{"abduction", -x}, Row{"pronation", z}}},
      {BodyRole::kHand,
       {{"r_wrist"}},
       {Row{"flexion", x}, Row{"deviation", -y}, Row{"rotation", z}}},
      {BodyRole::kFinger,
       {},
       {Row{"flexion", x, -20.0, 100.0}, Row{"spread", -y}, Row{"rotation", z}}},
      {BodyRole::kThigh,
       {{"r_hip"}},
       {Row{"flexion", -y}, Row{"abduction", -x}, Row{"rotation", -z}}},
      {BodyRole::kShin,
       {{"r_knee"}},
       {Row{"flexion", y}, Row{"abduction", -x}, Row{"rotation", -z}}},
      {BodyRole::kFoot,
       {{"r_ankle"}},
       {Row{"flexion", -y}, Row{"inversion", x}, Row{"rotation", -z}}},
      {BodyRole::kToe, {{"r_toe"}}, {Row{"flexion", -y}, Row{"bend", x}, Row{"rotation", -z}}}};
  return rows;
}

const HingeSpec* HumanHinge(std::string_view joint, std::string_view name) {
  for (const JointSpec& spec : HumanFigure().joints) {
    if (spec.name != joint) continue;
    for (const HingeSpec& hinge : spec.hinges) {
      if (hinge.name == name || (hinge.name.empty() && name == "flexion")) return &hinge;
    }
  }
  return nullptr;
}

StrengthCurve Scaled(StrengthCurve curve, double angle) {
  curve.best_angle *= angle;
  curve.width *= angle;
  return curve;
}

// Takes from the human's row what this part of a row covers.
void TakeHuman(const Rows& rows, const RowPart& part, BodyHinge* hinge) {
  double most = 0.0;
  hinge->is_usual = false;
  for (const Part& human : rows.human) {
    const double both = std::min(part.end, human.end) - std::max(part.begin, human.begin);
    const double share = std::max(0.0, both) / (human.end - human.begin);
    const HingeSpec* spec = HumanHinge(human.joint, hinge->name);
    if (!spec || share <= 0.0) continue;
    hinge->is_usual = true;
    hinge->lower += share * spec->lower;
    hinge->upper += share * spec->upper;
    if (!spec->strength || share <= most) continue;
    most = share;
    hinge->strength = JointStrength{Scaled(spec->strength->positive, share),
                                    Scaled(spec->strength->negative, share)};
  }
}

BodyHinge HingeOf(const Rows& rows, const Row& row, BodySide side, const RowPart& part) {
  BodyHinge hinge;
  hinge.name = row.name;
  // Reflected, so that equal angles are mirror images.
  const Vec3 axis =
      side == BodySide::kLeft ? Vec3(-row.axis.x(), row.axis.y(), -row.axis.z()) : row.axis;
  Vec3::Index along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  hinge.axis = static_cast<int>(along);
  hinge.sign = axis[along];
  if (row.lower < row.upper) {
    hinge.lower = row.lower * kDegree;
    hinge.upper = row.upper * kDegree;
  } else {
    TakeHuman(rows, part, &hinge);
  }
  return hinge;
}

}  // namespace

RowPart PartOfRow(const std::vector<BodyPlace>& places, size_t joint) {
  const auto row_of = [&](size_t k) {
    return places[k].role == BodyRole::kHead ? BodyRole::kNeck : places[k].role;
  };
  const BodyRole row = row_of(joint);
  if (row != BodyRole::kSpine && row != BodyRole::kNeck) return {};
  int before = 0, all = 0;
  for (size_t k = 0; k < places.size(); ++k) {
    if (row_of(k) != row) continue;
    before += k < joint ? 1 : 0;
    ++all;
  }
  return {static_cast<double>(before) / all, (before + 1.0) / all};
}

bool IsFixed(const BodyHinge& of_body, const AngleRange& range) {
  return !of_body.is_usual && range.high - range.low < kFixed;
}

HingeSpec HingeOfBody(const BodyHinge& of_body, const Mat3& frame, const AngleRange& range,
                      double strength) {
  HingeSpec hinge;
  hinge.name = of_body.name;
  hinge.axis = of_body.sign * frame.col(of_body.axis);
  hinge.strength = of_body.strength;
  if (hinge.strength) {
    hinge.strength->positive.torque *= strength;
    hinge.strength->negative.torque *= strength;
  }
  if (IsFixed(of_body, range)) {
    hinge.lower = hinge.upper = 0.5 * (range.low + range.high);
    return hinge;
  }
  // A straight knee is at its limit but for rounding, not beyond it.
  const bool is_below = !of_body.is_usual || range.low < of_body.lower - kFixed;
  const bool is_above = !of_body.is_usual || range.high > of_body.upper + kFixed;
  hinge.lower = is_below ? range.low - kBeyondClip : std::min(of_body.lower, range.low);
  hinge.upper = is_above ? range.high + kBeyondClip : std::max(of_body.upper, range.high);
  return hinge;
}

double StrengthOf(double mass, double height) { return mass * height / kHuman; }

std::optional<BodyHinges> BodyHingesOf(BodyPlace place, const RowPart& part) {
  for (const Rows& rows : AllRows()) {
    if (rows.role != place.role) continue;
    BodyHinges hinges;
    for (size_t h = 0; h < hinges.size(); ++h) {
      hinges[h] = HingeOf(rows, rows.hinges[h], place.side, part);
    }
    return hinges;
  }
  return std::nullopt;
}

}  // namespace hazumi
