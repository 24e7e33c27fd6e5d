// What the hand does with start rates r is found by baking the motion up to the release, with the
// object in hand up to the region's end, so that one bake says it of every release. The rates
// sought bring e(r), by how far the spot is missed, to zero: where the path comes down through the
// spot's height less the spot, or, if a height is asked for, T (v(r) - v) with the time T and
// velocity v of that throw from p(r).
// A made throw that has to rise to a height finds, with its rates, how far its fastest hinge has
// swung as the region starts: it is let go on a whole frame, and angle and speed there are two
// things. There are more unknowns than equations, of which the step dr = -W J' (J W J' + m I)^-1 e
// changes those least that move the object least: W has the squared distances of the hinges from
// it. J is from finite differences, m grows until e falls (Levenberg and Marquardt).

#include "engine/makers/throws/throw_aim.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "engine/analysis/object_landing.h"
#include "engine/dynamics/kinematics.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/holders.h"
#include "engine/project/edits/keys.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

constexpr double kNear = 0.005;                  // of a hit [m]
constexpr double kMostRate = 2000.0 * kDegree;   // [rad/s]
constexpr double kMostFarther = 35.0 * kDegree;  // [rad]

Error OutOfReach(double miss, const AimedThrow& best, bool is_made) {
  std::string message = "let go in frame " + std::to_string(best.release) + " it misses by " +
                        std::to_string(std::lround(100.0 * miss)) + " cm at best";
  if (best.limit_hits > 0) message += ", for " + best.at_limit + " is at its limit";
  return {ErrorCode::kSemantics, "", "x",
          message + (is_made ? "; choose another spot, or another height"
                             : "; choose another spot, another pose to throw from, or a region of "
                               "more frames or joints")};
}

Error Whirls() {
  return {ErrorCode::kSemantics, "", "height",
          "the arm would have to whirl backwards for it; choose a spot or a height that takes less "
          "speed"};
}

Error TooMuchWork() {
  return {ErrorCode::kInterrupted, "", "x",
          "the search for a throw was given up, because its motions take too much work; choose "
          "another spot or a shorter region"};
}

// As `of`, and never let go of again by who throws it.
Animation HeldOn(Animation animation, const ThrowCase& of) {
  std::vector<Holder>& holders = animation.held_objects[static_cast<size_t>(of.object)].holders;
  const auto thrower = std::find_if(holders.begin(), holders.end(), [&](const Holder& holder) {
    return holder.last_frame == of.release;
  });
  if (thrower == holders.end()) return animation;
  holders.erase(std::next(thrower), holders.end());
  holders.back().last_frame.reset();
  return animation;
}

// Returns what was found, or why nothing was.
Result<AimedThrow> Given(const std::optional<AimedThrow>& found, const Error& error) {
  if (found) return *found;
  return error;
}

}  // namespace

ThrowAim::ThrowAim(const Animation& animation, ThrowCase of, double most_work)
    : animation_(HeldOn(animation, of)),
      case_(std::move(of)),
      trials_(most_work, TooMuchWork()),
      radius_(InnerRadius(animation_.held_objects[static_cast<size_t>(case_.object)])) {}

Result<Done> ThrowAim::TakeStart() {
  constexpr double kFartherEase = 0.05;  // 0.2 rad are changed as readily as 1 rad/s [s^2]
  const DynamicsRegion& region = animation_.regions[static_cast<size_t>(case_.region)];
  const Result<const Motion*> keyed = trials_.BakeTo(region.first_frame, animation_);
  if (!keyed.ok()) return keyed.error();
  const size_t first = static_cast<size_t>(region.first_frame - animation_.first_frame);
  const MotionFrame& frame = keyed.value()->frames[first];
  const Figure& figure = *animation_.figure;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  const int n = static_cast<int>(case_.hinges.size());
  start_ = {VecX(n), VecX(n), VecX(n)};
  ease_.resize(n + 1);
  for (int i = 0; i < n; ++i) {
    const JointIndex hinge = case_.hinges[static_cast<size_t>(i)];
    start_->q[i] = frame.after.q[hinge.value()];
    start_->before[i] = frame.before.qd[hinge.value()];
    start_->after[i] = frame.after.qd[hinge.value()];
    const Vec3& object = frame.objects[static_cast<size_t>(case_.object)].X_WO.p;
    ease_[i] = (ws.body(hinge).p - object).squaredNorm();
  }
  start_->after.cwiseAbs().maxCoeff(&start_->fastest);
  ease_[n] = kFartherEase * ease_[start_->fastest];
  return Done();
}

// Sets the keys on the first frame of the region. Everything before stays, but for the hinge that
// has swung farther.
void ThrowAim::Set(const VecX& swing) {
  const int first = animation_.regions[static_cast<size_t>(case_.region)].first_frame;
  for (size_t i = 0; i < case_.hinges.size(); ++i) {
    const int at = static_cast<int>(i);
    Keys& keys = animation_.joint_keys[static_cast<size_t>(case_.hinges[i].value())];
    auto key = std::find_if(keys.begin(), keys.end(),
                            [&](const Key& each) { return each.frame >= first; });
    if (key == keys.end() || key->frame != first) {
      key = keys.insert(key, Key());
      key->frame = first;
      key->value = start_->q[at];
    }
    if (at == start_->fastest) key->value = start_->q[at] + Farther(swing);
    if (!key->rate_in) key->rate_in = start_->before[at];
    key->rate = swing[at];
  }
}

// Bakes a swing and returns the path of the object as it is let go.
Result<ThrowPath> ThrowAim::Let(const VecX& swing, int release) {
  Set(swing);
  const Result<const Motion*> baked = trials_.BakeTo(release, animation_);
  if (!baked.ok()) return baked.error();
  return PathFrom(release);
}

ThrowPath ThrowAim::PathFrom(int release) const {
  const size_t i = static_cast<size_t>(release - animation_.first_frame);
  const MotionFrame& frame = trials_.motion().frames[i];
  const size_t object = static_cast<size_t>(case_.object);
  const Holder& holder = animation_.held_objects[object].holders.back();
  const Figure& figure = *animation_.figure;
  const MotionLimit& at = frame.before;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, at.X_WR, at.q, &ws);
  ComputeVelocities(figure, at.root_w, at.root_v, at.qd, &ws);
  const BodyScratch& body = ws.body(figure.group(holder.joint).last());
  const Vec3 arm = body.R * holder.offset;
  return {body.p + arm, body.v + body.w.cross(arm), 0.0};
}

// Returns the miss of the spot: with a height in three directions, without one in the plane of the
// spot, whose height the path passes where it comes down, or comes nearest to from below.
VecX ThrowAim::MissOf(const ThrowPath& path, const Vec3& spot,
                      const std::optional<double>& height) const {
  const double g = animation_.gravity;
  if (height) {
    const ThrowPath wanted = ThrowOver(path.from, spot, *height, g);
    return wanted.seconds * (path.velocity - wanted.velocity);
  }
  return (path.from + SecondsDown(path, spot.z(), g) * path.velocity - spot).head<2>();
}

Result<AimedThrow> ThrowAim::Solve(const Vec3& spot, const std::optional<double>& height,
                                   int release, VecX swing) {
  constexpr int kMostSteps = 12, kMostTries = 5;
  constexpr double kDifference = 5.0 * kDegree;  // [rad/s]
  constexpr double kWorthwhile = 0.97;           // slower progress is none
  double damping = 1e-3;
  Result<ThrowPath> path = Let(swing, release);
  if (!path.ok()) return path.error();
  VecX e = MissOf(path.value(), spot, height);
  const bool is_angle_free = height && case_.has_backswing;
  const auto m = e.size(), n = swing.size() - (is_angle_free ? 0 : 1);
  VecX most = VecX::Constant(n, kMostRate);
  if (is_angle_free) most[n - 1] = kMostFarther;
  for (int step = 0; step < kMostSteps && e.norm() > 0.1 * kNear; ++step) {
    MatX J(m, n);
    for (int i = 0; i < n; ++i) {
      VecX other = swing;
      other[i] += kDifference;
      const Result<ThrowPath> there = Let(other, release);
      if (!there.ok()) return there.error();
      J.col(i) = (MissOf(there.value(), spot, height) - e) / kDifference;
    }
    const MatX WJ = ease_.head(n).asDiagonal() * J.transpose(), square = J * WJ;
    const double before = e.norm();
    for (int i = 0; i < kMostTries; ++i, damping *= 6.0) {
      const MatX damped = square + (damping * square.trace() + 1e-12) * MatX::Identity(m, m);
      const VecX by = -WJ * damped.ldlt().solve(e);
      VecX tried = swing;
      tried.head(n) = (swing.head(n) + by).cwiseMin(most).cwiseMax(-most);
      const Result<ThrowPath> there = Let(tried, release);
      if (!there.ok()) continue;
      const VecX missed = MissOf(there.value(), spot, height);
      if (missed.norm() >= e.norm()) continue;
      swing = tried;
      path = there;
      e = missed;
      damping *= 0.1;
      break;
    }
    if (e.norm() > kWorthwhile * before) break;
  }
  AimedThrow aimed;
  aimed.release = release;
  aimed.rates = swing.head(swing.size() - 1);
  aimed.farther = Farther(swing);
  const Result<ThrowPath> again = Let(swing, release);  // for its limits
  if (!again.ok()) return again.error();
  aimed.path = again.value();
  Judge(&aimed);
  if (e.norm() > kNear) return OutOfReach(e.norm(), aimed, case_.has_backswing);
  if (case_.has_backswing && SwingsBack(aimed.rates)) return Whirls();
  aimed.path.seconds = SecondsDown(aimed.path, spot.z(), animation_.gravity);
  return aimed;
}

void ThrowAim::Judge(AimedThrow* aimed) const {
  constexpr double kOfAHit = 0.5;  // [m/s]
  const DynamicsRegion& region = animation_.regions[static_cast<size_t>(case_.region)];
  long most = 0;
  for (const MotionEvent& event : trials_.motion().events) {
    if (event.kind != EventKind::kLimit) continue;
    if (event.frame <= region.first_frame || event.frame > aimed->release) continue;
    aimed->limit_hits += event.count;
    if (event.count <= most) continue;
    most = event.count;
    aimed->at_limit = event.joint;
  }
  const auto n = aimed->rates.size();
  const VecX change = (aimed->rates - start_->after).cwiseProduct(ease_.head(n).cwiseSqrt());
  aimed->cost = change.norm() + aimed->path.velocity.norm() +
                kOfAHit * static_cast<double>(aimed->limit_hits);
}

// The hinge that swings fastest as the backswing has it swings the other way.
bool ThrowAim::SwingsBack(const VecX& rates) const {
  return rates[start_->fastest] * start_->after[start_->fastest] < 0.0;
}

// 0: as there is. Others are farther and farther from that, and always the same.
VecX ThrowAim::Swing(int number) const {
  constexpr double kSpread = 300.0 * kDegree;  // [rad/s]
  std::mt19937 random(static_cast<unsigned>(number));
  VecX swing(start_->after.size() + 1);
  swing << start_->after, 0.0;
  for (Eigen::Index i = 0; i + 1 < swing.size(); ++i) {
    swing[i] += number * kSpread * (random() / 2147483648.0 - 1.0);
    swing[i] = std::clamp(swing[i], -kMostRate, kMostRate);
  }
  return swing;
}

Error InTheWayOf(const std::string& what, bool has_height) {
  return Refusal(
      has_height ? "height" : "x",
      "\"" + what + "\" is in the way; " +
          (has_height ? "give a greater height" : "choose a spot that is open from above"));
}

// Let go in this frame, over what is in the way.
Result<AimedThrow> ThrowAim::Over(const Vec3& spot, int release, const VecX& swing) {
  constexpr double kHigher = 0.2;  // [m]
  constexpr int kTries = 8;
  Result<AimedThrow> flat = Solve(spot, {}, release, swing);
  if (!flat.ok()) return flat;
  std::string in_the_way = InTheWay(flat.value().path, radius_, animation_);
  if (in_the_way.empty()) return flat;
  const Vec3 from = flat.value().path.from;
  double high = HeightOfSlowestThrow(from, spot, animation_.gravity);
  for (int i = 0; i < kTries; ++i, high += kHigher) {
    // Paths from here are tried first: most that something is in the way of need no solution.
    const ThrowPath over = ThrowOver(from, spot, high, animation_.gravity);
    if (!InTheWay(over, radius_, animation_).empty()) continue;
    Result<AimedThrow> aimed = Solve(spot, high, release, flat.value().swing());
    if (!aimed.ok()) continue;
    in_the_way = InTheWay(aimed.value().path, radius_, animation_);
    if (in_the_way.empty()) return aimed;
  }
  return InTheWayOf(in_the_way, false);
}

// Let go in this frame, rising as high as is asked for.
Result<AimedThrow> ThrowAim::AsHigh(const Vec3& spot, double height, int release,
                                    const VecX& swing) {
  const Result<ThrowPath> now = Let(swing, release);
  if (!now.ok()) return now.error();
  const double least = spot.z() - now.value().from.z();
  if (height <= std::max(0.0, least)) {
    return Refusal("height", least > 0.0
                                 ? "the spot is " + std::to_string(std::lround(100.0 * least)) +
                                       " cm higher than the hand: give a greater height"
                                 : "it has to rise above the hand: give a height greater than 0");
  }
  Result<AimedThrow> aimed = Solve(spot, height, release, swing);
  if (!aimed.ok()) return aimed;
  const std::string in_the_way = InTheWay(aimed.value().path, radius_, animation_);
  if (!in_the_way.empty()) return InTheWayOf(in_the_way, true);
  return aimed;
}

// Frames of the region in which it could be let go, those that miss least first.
Result<std::vector<int>> ThrowAim::Releases(const Vec3& spot, const VecX& swing, bool given_first) {
  const DynamicsRegion& region = animation_.regions[static_cast<size_t>(case_.region)];
  if (const auto path = Let(swing, region.last_frame); !path.ok()) return path.error();
  std::vector<std::pair<double, int>> misses;
  for (int frame = region.first_frame + 1; frame <= region.last_frame; ++frame) {
    const bool is_given = given_first && frame == case_.release;
    misses.emplace_back(is_given ? -1.0 : MissOf(PathFrom(frame), spot, {}).norm(), frame);
  }
  std::sort(misses.begin(), misses.end());
  std::vector<int> frames;
  frames.reserve(misses.size());
  for (const auto& [miss, frame] : misses) frames.push_back(frame);
  return frames;
}

Result<AimedThrow> ThrowAim::At(const Vec3& spot, std::optional<double> height) {
  constexpr int kStarts = 4, kMoreTries = 6;
  constexpr double kMoreWork = 1e7;
  if (Result<Done> taken = TakeStart(); !taken.ok()) return taken.error();
  std::optional<Error> error;
  std::optional<AimedThrow> best;
  int more = kMoreTries;
  for (int start = 0; start < kStarts; ++start) {
    const Result<std::vector<int>> releases = Releases(spot, Swing(start), start == 0);
    if (!releases.ok()) return Given(best, error.value_or(releases.error()));
    for (const int release : releases.value()) {
      Result<AimedThrow> aimed =
          height ? AsHigh(spot, *height, release, Swing(start)) : Over(spot, release, Swing(start));
      if (aimed.ok()) {
        if (!best) trials_.LeaveWork(kMoreWork);
        if (!best || aimed.value().cost < best->cost) best = aimed.value();
      } else if (aimed.error().code == ErrorCode::kInterrupted) {
        return Given(best, error.value_or(aimed.error()));
      } else if (const bool says_why = aimed.error().code == ErrorCode::kSchema;
                 !error || (says_why && error->code != ErrorCode::kSchema)) {
        error = aimed.error();
      }
      if (best && more-- == 0) return *best;
    }
  }
  if (!best && height && error->code == ErrorCode::kSemantics) return WithHeight(*error, spot);
  return Given(best, *error);
}

// Adds the height at which it would get there to an error.
Error ThrowAim::WithHeight(Error error, const Vec3& spot) {
  const Result<AimedThrow> flat = Over(spot, case_.release, Swing(0));
  if (!flat.ok()) return error;
  const double up = std::max(0.0, flat.value().path.velocity.z());
  char rise[40];
  std::snprintf(rise, sizeof rise, "%.2f", std::ceil(50.0 * up * up / animation_.gravity) / 100.0);
  error.message += "; it gets there if it rises " + std::string(rise) + " m above the hand";
  return error;
}

void PutThrow(const ThrowCase& of, const AimedThrow& aimed, const ThrowStart& start,
              const Animation& animation, Project* project) {
  constexpr double kShown = 100.0;  // hundredths of a degree per second
  constexpr double kBent = 3.0;     // [deg]
  EndOf(of.holder, &project->held_objects[static_cast<size_t>(of.object)]) = aimed.release;
  const int first = project->regions[static_cast<size_t>(of.region)].first_frame;
  const auto shown = [&](double rate) {
    return std::round(kShown * rate / kDegree) / kShown + 0.0;
  };
  for (size_t i = 0; i < of.hinges.size(); ++i) {
    const int at = static_cast<int>(i);
    const Result<ProjectCurve*> curve =
        CurveNamed(animation.figure->joint(of.hinges[i]).name, *animation.figure, project);
    if (!curve.ok()) continue;
    const std::vector<ProjectKey>& keys = curve.value()->keys;
    ProjectKey key;
    key.frame = first;
    key.value = ShortestDegrees(start.q[at]);
    if (const ProjectKey* there = KeyOn(first, *curve.value())) key = *there;
    if (at == start.fastest) key.value += shown(aimed.farther);
    key.rate = shown(aimed.rates[at]);
    // The last term of a cubic, T (s^3 - s^2) per rate, is 4/27 T at most.
    const auto before = std::find_if(keys.rbegin(), keys.rend(),
                                     [&](const ProjectKey& each) { return each.frame < first; });
    const double seconds =
        before == keys.rend() ? 0.0 : animation.rate.SecondsAt(first - before->frame);
    const double arrives = shown(start.before[at]);
    const bool bends = 4.0 / 27.0 * seconds * std::abs(*key.rate - arrives) > kBent;
    if (bends && !of.has_backswing && !key.rate_in) key.rate_in = arrives;
    PutKey(key, curve.value());
  }
}

}  // namespace hazumi::makers
