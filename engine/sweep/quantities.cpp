#include "engine/sweep/quantities.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "engine/analysis/object_landing.h"
#include "engine/base/text.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "engine/project/json/did_you_mean.h"
#include "engine/spatial/degrees.h"
#include "engine/sweep/wrong_at.h"

namespace hazumi {

namespace {

double ToDegrees(double radians) { return radians / kDegree; }

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <int kAxis>
double LandingPlace(const Measured& m) {
  const auto landing = LandingOf(m.animation, m.motion, static_cast<size_t>(m.of));
  return landing ? landing->position[kAxis] : kNone;
}

double LandingFrame(const Measured& m) {
  const auto landing = LandingOf(m.animation, m.motion, static_cast<size_t>(m.of));
  return landing ? m.motion.rate.FrameAt(landing->time) : kNone;
}

// The largest of what `value_of` makes of the frames.
template <typename ValueOf>
double Largest(const Motion& motion, ValueOf value_of) {
  double largest = kNone;
  for (const MotionFrame& frame : motion.frames) {
    const double value = value_of(frame);
    if (!(value <= largest)) largest = value;
  }
  return largest;
}

double HighestCom(const Measured& m) {
  return Largest(m.motion, [](const MotionFrame& frame) { return frame.com.z(); });
}
double LowestCom(const Measured& m) {
  return -Largest(m.motion, [](const MotionFrame& frame) { return -frame.com.z(); });
}

// Of one hinge, or of the fastest.
double FastestRate(const Measured& m) {
  return ToDegrees(Largest(m.motion, [&](const MotionFrame& frame) {
    const VecX& before = frame.before.qd;
    const VecX& after = frame.after.qd;
    if (m.of < 0)
      return std::max(before.lpNorm<Eigen::Infinity>(), after.lpNorm<Eigen::Infinity>());
    return std::max(std::abs(before[m.of]), std::abs(after[m.of]));
  }));
}

Vec3 JointPosition(const Measured& m, const MotionFrame& frame) {
  const Figure& figure = *m.animation.figure;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  return ws.body(figure.groups()[static_cast<size_t>(m.of)].first).p;
}

// Between frames: the fastest of the straight ways from frame to frame.
double FastestJoint(const Measured& m) {
  double largest = kNone;
  Vec3 before = Vec3::Zero();
  for (size_t i = 0; i < m.motion.frames.size(); ++i) {
    const Vec3 p = JointPosition(m, m.motion.frames[i]);
    const double speed = (p - before).norm() / m.motion.rate.seconds_per_frame();
    if (i > 0 && !(speed <= largest)) largest = speed;
    before = p;
  }
  return largest;
}

// The frame that is asked for, which is there.
const MotionFrame& FrameOf(const Measured& m) {
  const auto first = m.motion.frames.front().frame;
  return m.motion.frames[static_cast<size_t>(m.frame - first)];
}

double AngleAt(const Measured& m) { return ToDegrees(FrameOf(m).q[m.of]); }
template <int kAxis>
double JointPlaceAt(const Measured& m) {
  return JointPosition(m, FrameOf(m))[kAxis];
}

double LimitHits(const Measured& m) {
  double hits = 0.0;
  for (const MotionEvent& event : m.motion.events) {
    const bool counts =
        m.of < 0 || event.joint == m.animation.figure->joints()[static_cast<size_t>(m.of)].name;
    if (event.kind == EventKind::kLimit && counts) hits += static_cast<double>(event.count);
  }
  return hits;
}

double TouchDowns(const Measured& m) {
  double touches = 0.0;
  for (const MotionEvent& event : m.motion.events) {
    if (event.kind == EventKind::kTouchDown) touches += static_cast<double>(event.count);
  }
  return touches;
}

double LeastClearance(const Measured& m) {
  DynamicsWorkspace ws(*m.animation.figure);
  return -Largest(m.motion, [&](const MotionFrame& frame) {
    ComputePositions(*m.animation.figure, frame.X_WR, frame.q, &ws);
    const auto contact = NearestContact(*m.animation.figure, m.animation.scene, ws);
    return contact ? -contact->clearance : kNone;
  });
}

double Warnings(const Measured& m) { return static_cast<double>(m.motion.warnings.size()); }

// Over one region, or over all that have what is asked for.
template <typename ValueOf, typename Join>
double OverRegions(const Measured& m, ValueOf value_of, Join join) {
  double joined = kNone;
  for (const RegionReport& region : m.motion.regions) {
    if (m.of >= 0 && region.name != m.animation.regions[static_cast<size_t>(m.of)].name) continue;
    const double value = value_of(region);
    if (std::isnan(value)) continue;
    joined = std::isnan(joined) ? value : join(joined, value);
  }
  return joined;
}

double WorstErrorEstimate(const Measured& m) {
  return OverRegions(
      m,
      [](const RegionReport& region) {
        return region.method == Method::kExact ? ToDegrees(region.error_estimate) : kNone;
      },
      [](double a, double b) { return std::max(a, b); });
}

template <typename Term>
double Energy(const Measured& m, Term term) {
  return OverRegions(
      m, [&](const RegionReport& region) { return region.energy ? term(*region.energy) : kNone; },
      [](double a, double b) { return a + b; });
}
double KineticEnd(const Measured& m) {
  return Energy(m, [](const EnergyBalance& energy) { return energy.kinetic_end; });
}
double FrictionWork(const Measured& m) {
  return Energy(m, [](const EnergyBalance& energy) { return energy.WorkOf("friction"); });
}
double LimitWork(const Measured& m) {
  return Energy(m, [](const EnergyBalance& energy) { return energy.limits; });
}
double ImpactWork(const Measured& m) {
  return Energy(m, [](const EnergyBalance& energy) { return energy.impacts; });
}
double KeyedWork(const Measured& m) {
  return Energy(m, [](const EnergyBalance& energy) { return energy.keyed; });
}

constexpr Quantity kQuantities[] = {
    {"landing_x_m", QuantityOf::kHeldObject, true, false, false,
     "where it first touches the scene once it is let go: its centre's x", LandingPlace<0>},
    {"landing_y_m", QuantityOf::kHeldObject, true, false, false, "its y there", LandingPlace<1>},
    {"landing_z_m", QuantityOf::kHeldObject, true, false, false, "its z there", LandingPlace<2>},
    {"landing_frame", QuantityOf::kHeldObject, true, false, false, "when; may lie between frames",
     LandingFrame},
    {"com_highest_m", QuantityOf::kNothing, false, false, false,
     "greatest height of the centre of mass", HighestCom},
    {"com_lowest_m", QuantityOf::kNothing, false, false, false,
     "least height of the centre of mass", LowestCom},
    {"rate_largest_deg_s", QuantityOf::kHinge, false, false, false,
     "largest rate at a frame, of the hinge or of the fastest", FastestRate},
    {"speed_largest_m_s", QuantityOf::kJoint, true, false, false,
     "largest speed of the joint's position, from frame to frame", FastestJoint},
    {"angle_deg", QuantityOf::kHinge, true, true, false, "angle at the frame", AngleAt},
    {"position_x_m", QuantityOf::kJoint, true, true, false, "x at the frame", JointPlaceAt<0>},
    {"position_y_m", QuantityOf::kJoint, true, true, false, "y at the frame", JointPlaceAt<1>},
    {"position_z_m", QuantityOf::kJoint, true, true, false, "z at the frame", JointPlaceAt<2>},
    {"limit_hits", QuantityOf::kHinge, false, false, false,
     "how often limits are hit, of the hinge or of all", LimitHits},
    {"touch_downs", QuantityOf::kNothing, false, false, false,
     "how often something comes down on something, of what regions keep apart", TouchDowns},
    {"clearance_least_m", QuantityOf::kNothing, false, false, false,
     "least distance of the figure to the scene, negative where it goes into it", LeastClearance},
    {"error_estimate_deg", QuantityOf::kRegion, false, false, false,
     "estimated error of the angles, of the region or the worst one", WorstErrorEstimate},
    {"kinetic_end_j", QuantityOf::kRegion, false, false, true,
     "kinetic energy in the end, of the region or the sum", KineticEnd},
    {"friction_work_j", QuantityOf::kRegion, false, false, true, "work of friction", FrictionWork},
    {"limit_work_j", QuantityOf::kRegion, false, false, true, "work of limits", LimitWork},
    {"impact_work_j", QuantityOf::kRegion, false, false, true, "work of impacts of contacts",
     ImpactWork},
    {"keyed_work_j", QuantityOf::kRegion, false, false, true, "work of the keyed joints",
     KeyedWork},
    {"warnings", QuantityOf::kNothing, false, false, false, "how many the bake gives", Warnings},
};

template <typename Items, typename NameOfItem>
std::vector<std::string> NamesOf(const Items& items, NameOfItem name_of) {
  std::vector<std::string> names;
  names.reserve(std::size(items));
  for (const auto& item : items) names.push_back(name_of(item));
  return names;
}
constexpr auto kByName = [](const auto& item) { return item.name; };

// What a quantity may be of, in this animation.
std::vector<std::string> Candidates(QuantityOf of, const Animation& animation) {
  switch (of) {
    case QuantityOf::kHeldObject:
      return NamesOf(animation.held_objects, kByName);
    case QuantityOf::kJoint:
      return NamesOf(animation.figure->groups(), kByName);
    case QuantityOf::kHinge:
      return NamesOf(animation.figure->joints(), kByName);
    case QuantityOf::kRegion:
      return NamesOf(animation.regions, kByName);
    case QuantityOf::kNothing:
      break;
  }
  return {};
}

const char* WordOf(QuantityOf of) {
  switch (of) {
    case QuantityOf::kHeldObject:
      return "held object";
    case QuantityOf::kJoint:
      return "joint";
    case QuantityOf::kHinge:
      return "hinge";
    case QuantityOf::kRegion:
      return "region";
    case QuantityOf::kNothing:
      break;
  }
  return "";
}

std::optional<Error> ResolveOf(const SweepMeasure& measure, const Animation& animation,
                               const std::string& place, SweepColumn* column) {
  const Quantity& quantity = *column->quantity;
  if (measure.of.empty() && !quantity.is_of_one) return std::nullopt;
  if (measure.of.empty()) {
    return WrongAt(place, std::string("\"of\" is missing: the ") + WordOf(quantity.of));
  }
  if (quantity.of == QuantityOf::kNothing) {
    return WrongAt(place + ".of", "the quantity is that of the figure: leave \"of\" out");
  }
  const std::vector<std::string> names = Candidates(quantity.of, animation);
  const auto found = std::find(names.begin(), names.end(), measure.of);
  if (found == names.end()) {
    return WrongAt(place + ".of", std::string("there is no ") + WordOf(quantity.of) + " \"" +
                                      measure.of + "\"" +
                                      (names.empty() ? "" : "; " + Suggestion(measure.of, names)));
  }
  column->of = static_cast<int>(found - names.begin());
  return std::nullopt;
}

std::optional<Error> ResolveFrame(const SweepMeasure& measure, const Animation& animation,
                                  const std::string& place, SweepColumn* column) {
  if (!column->quantity->is_at_frame) {
    if (!measure.frame) return std::nullopt;
    return WrongAt(place + ".frame", "the quantity is that of all frames: leave \"frame\" out");
  }
  if (!measure.frame) return WrongAt(place, "\"frame\" is missing: where it is measured");
  column->frame = *measure.frame;
  const bool is_there = column->frame == std::floor(column->frame) &&
                        column->frame >= animation.first_frame &&
                        column->frame <= animation.last_frame;
  if (is_there) return std::nullopt;
  return WrongAt(place + ".frame", "must be a whole frame from " +
                                       std::to_string(animation.first_frame) + " to " +
                                       std::to_string(animation.last_frame));
}

std::string NameOf(const SweepMeasure& measure) {
  if (!measure.name.empty()) return measure.name;
  std::string name = measure.quantity;
  if (!measure.of.empty()) name += " " + measure.of;
  if (measure.frame) name += " F" + FormatNumber(*measure.frame);
  return name;
}

std::optional<Error> Resolve(const SweepMeasure& measure, const Animation& animation,
                             const std::string& place, SweepColumn* column) {
  const auto found = std::find_if(std::begin(kQuantities), std::end(kQuantities),
                                  [&](const Quantity& q) { return q.name == measure.quantity; });
  if (found == std::end(kQuantities)) {
    const auto names = NamesOf(kQuantities, [](const Quantity& q) { return std::string(q.name); });
    return WrongAt(place + ".quantity", "there is no quantity \"" + measure.quantity + "\"; " +
                                            Suggestion(measure.quantity, names));
  }
  column->quantity = found;
  column->name = NameOf(measure);
  if (auto error = ResolveOf(measure, animation, place, column)) return error;
  return ResolveFrame(measure, animation, place, column);
}

// What is asked for, or what one would look at first.
std::vector<SweepMeasure> MeasuresOf(const SweepPlan& plan, const Animation& animation) {
  if (!plan.measure.empty()) return plan.measure;
  std::vector<SweepMeasure> measures;
  for (const HeldObject& object : animation.held_objects) {
    for (const char* quantity : {"landing_x_m", "landing_y_m", "landing_z_m", "landing_frame"}) {
      measures.push_back({"", quantity, object.name, {}, {}});
    }
  }
  for (const char* quantity : {"com_highest_m", "rate_largest_deg_s", "limit_hits",
                               "clearance_least_m", "error_estimate_deg", "warnings"}) {
    measures.push_back({"", quantity, "", {}, {}});
  }
  return measures;
}

}  // namespace

std::span<const Quantity> AllQuantities() { return kQuantities; }

Result<std::vector<SweepColumn>> ResolveMeasures(const SweepPlan& plan,
                                                 const Animation& animation) {
  std::vector<SweepColumn> columns;
  for (const SweepMeasure& measure : MeasuresOf(plan, animation)) {
    const std::string place = "measure[" + std::to_string(columns.size()) + "]";
    SweepColumn column{};
    if (auto error = Resolve(measure, animation, place, &column)) return *error;
    for (const SweepColumn& other : columns) {
      if (other.name == column.name) {
        return WrongAt(place,
                       "two columns are named \"" + column.name + "\": give one another \"name\"");
      }
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

double Measure(const SweepColumn& column, const Animation& animation, const Motion& motion) {
  return column.quantity->measure({animation, motion, column.of, column.frame});
}

}  // namespace hazumi
