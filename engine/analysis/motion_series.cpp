#include "engine/analysis/motion_series.h"

#include <algorithm>
#include <cmath>

#include "engine/base/assert.h"
#include "engine/dynamics/kinematics.h"

namespace hazumi {

namespace {

using Track = std::vector<Vec3>;

// A point fixed to a body: of the root, where the joint is invalid.
struct BodyPoint {
  JointIndex joint;
  Vec3 p_J = Vec3::Zero();
  bool is_origin = false;
};

int BodyNumber(JointIndex joint) { return joint.is_valid() ? joint.value() + 1 : 0; }

// The origin of a group's last hinge and the ends of the capsules on any of its bodies.
std::vector<BodyPoint> PointsOf(const Figure& figure, GroupIndex group) {
  const JointGroup& hinges = figure.group(group);
  std::vector<BodyPoint> points = {{hinges.last(), Vec3::Zero(), true}};
  for (const Link& link : figure.links()) {
    if (!link.joint.is_valid() || figure.joint(link.joint).group != group) continue;
    points.push_back({link.joint, link.capsule.a});
    points.push_back({link.joint, link.capsule.b});
  }
  return points;
}

const RigidInertia& InertiaOf(const Figure& figure, int body) {
  return body == 0 ? figure.root_body() : figure.body(JointIndex(body - 1));
}

// By body number: bodies of one mass are of one class.
std::vector<int> MassClasses(const Figure& figure) {
  constexpr double kSame = 1e-3;
  std::vector<int> classes;
  std::vector<double> masses;  // of the classes
  for (int i = 0; i <= figure.num_joints(); ++i) {
    const double mass = InertiaOf(figure, i).mass;
    const auto same = std::find_if(masses.begin(), masses.end(), [&](double other) {
      return std::abs(mass - other) <= kSame * other;
    });
    classes.push_back(static_cast<int>(same - masses.begin()));
    if (same == masses.end()) masses.push_back(mass);
  }
  return classes;
}

// About the CoM of the figure [kg m^2/s]; needs ComputeVelocities.
Vec3 AngularMomentum(const Figure& figure, const DynamicsWorkspace& ws) {
  const Vec3 com = CenterOfMass(figure, ws), v_com = CenterOfMassVelocity(figure, ws);
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i <= figure.num_joints(); ++i) {
    const RigidInertia& inertia = InertiaOf(figure, i);
    if (inertia.is_massless()) continue;
    const BodyScratch& body = ws.bodies[i];
    const Vec3 c = body.R * inertia.com;
    sum += body.R * (inertia.I_com * (body.R.transpose() * body.w));
    sum += inertia.mass * (body.p + c - com).cross(body.v + body.w.cross(c) - v_com);
  }
  return sum;
}

// From the lowest to the highest of the joints and the links [m].
double Extent(const Figure& figure, const DynamicsWorkspace& ws) {
  double low = ws.bodies[0].p.z(), high = low;
  const auto add = [&](double z, double radius) {
    low = std::min(low, z - radius);
    high = std::max(high, z + radius);
  };
  for (const BodyScratch& body : ws.bodies) add(body.p.z(), 0.0);
  for (const Link& link : figure.links()) {
    const BodyScratch& body = ws.bodies[BodyNumber(link.joint)];
    for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
      add((body.p + body.R * end).z(), link.capsule.radius);
    }
  }
  return high - low;
}

// The figure's bodies at every frame.
class Walk {
 public:
  Walk(const Figure& figure, const Motion& motion) {
    DynamicsWorkspace ws(figure);
    classes_ = MassClasses(figure);
    mass_shifts_.resize(*std::max_element(classes_.begin(), classes_.end()) + 1);
    for (const MotionFrame& frame : motion.frames) {
      ComputePositions(figure, frame.X_WR, frame.q, &ws);
      const MotionLimit& rates = frame.after;
      ComputeVelocities(figure, rates.root_w, rates.root_v, rates.qd, &ws);
      angular_momentum_.push_back(AngularMomentum(figure, ws));
      AddMassShifts(figure, ws);
      extents_.push_back(Extent(figure, ws));
      poses_.emplace_back();
      for (const BodyScratch& body : ws.bodies) poses_.back().push_back({body.R, body.p});
    }
  }

  const std::vector<Vec3>& angular_momentum() const { return angular_momentum_; }
  const std::vector<Track>& mass_shifts() const { return mass_shifts_; }
  // The figure stands at most frames.
  double stature() const { return Quantile(extents_, 0.5); }

  Track Of(const BodyPoint& point) const {
    Track track;
    for (const std::vector<Pose>& bodies : poses_) {
      track.push_back(bodies[BodyNumber(point.joint)] * point.p_J);
    }
    return track;
  }

 private:
  void AddMassShifts(const Figure& figure, const DynamicsWorkspace& ws) {
    const Vec3 com = CenterOfMass(figure, ws);
    const double mass = figure.total_mass();
    for (Track& shift : mass_shifts_) shift.push_back(Vec3::Zero());
    for (int i = 0; i <= figure.num_joints(); ++i) {
      const RigidInertia& inertia = InertiaOf(figure, i);
      if (inertia.is_massless()) continue;
      const BodyScratch& body = ws.bodies[i];
      const Vec3 p = body.p + body.R * inertia.com;
      mass_shifts_[classes_[i]].back() += inertia.mass / mass * (p - com);
    }
  }

  std::vector<int> classes_;  // by body number
  std::vector<Track> mass_shifts_;
  std::vector<Vec3> angular_momentum_;
  std::vector<double> extents_;
  std::vector<std::vector<Pose>> poses_;  // by frame and body
};

double Level(const Track& track) {
  std::vector<double> heights;
  for (const Vec3& p : track) heights.push_back(p.z());
  return Quantile(std::move(heights), 0.1);
}

// A group that nothing hangs on, with its points.
struct End {
  GroupIndex group;
  std::vector<Track> points;
  double origin_level = 0.0, level = 1e300;  // where they are when they are low [m]
};

std::vector<End> EndsOf(const Figure& figure, const Walk& walk) {
  std::vector<End> ends;
  for (size_t g = 0; g < figure.groups().size(); ++g) {
    End end{GroupIndex(static_cast<int>(g)), {}};
    const JointIndex last = figure.group(end.group).last();
    if (figure.joint(last).subtree_end.value() != last.value() + 1) continue;
    for (const BodyPoint& point : PointsOf(figure, end.group)) {
      end.points.push_back(walk.Of(point));
      const double level = Level(end.points.back());
      if (point.is_origin) end.origin_level = level;
      end.level = std::min(end.level, level);
    }
    ends.push_back(std::move(end));
  }
  return ends;
}

// What the foot stands on: see SeriesOf. Shares of the stature.
constexpr double kSameLevel = 0.015;  // ball and tip of the toes
constexpr double kFootHeight = 0.08;  // of the ankle over the ball
constexpr double kLowEnds = 0.1;      // between the lowest end and the others the figure stands on

FootTrack FootOf(const Figure& figure, const Walk& walk, const End& end, double stature) {
  FootTrack foot{figure.group(end.group).name, {}};
  const auto add = [&](const Track& track) {
    if (Level(track) <= end.level + kFootHeight * stature) foot.points.push_back(track);
  };
  const bool has_ball = end.origin_level <= end.level + kSameLevel * stature;
  const size_t used = has_ball ? 1 : end.points.size();
  for (size_t i = 0; i < used; ++i) add(end.points[i]);
  const JointIndex parent = figure.joint(figure.group(end.group).first).parent;
  if (!parent.is_valid()) return foot;
  for (const BodyPoint& point : PointsOf(figure, figure.joint(parent).group)) add(walk.Of(point));
  return foot;
}

std::vector<FootTrack> FeetOf(const Figure& figure, const Walk& walk, double stature) {
  const std::vector<End> ends = EndsOf(figure, walk);
  double lowest = 1e300;
  for (const End& end : ends) lowest = std::min(lowest, end.level);
  std::vector<FootTrack> feet;
  for (const End& end : ends) {
    if (end.level > lowest + kLowEnds * stature) continue;
    feet.push_back(FootOf(figure, walk, end, stature));
  }
  if (feet.empty()) feet.push_back({figure.root_name(), {walk.Of({})}});
  return feet;
}

}  // namespace

double Quantile(std::vector<double> values, double share) {
  HAZUMI_DEMAND(!values.empty());
  const auto nth = values.begin() + static_cast<long>(share * (values.size() - 1) + 0.5);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

MotionSeries SeriesOf(const Figure& figure, const Motion& motion) {
  MotionSeries series;
  series.frame_time = motion.rate.seconds_per_frame();
  if (motion.frames.empty()) return series;
  series.first_frame = motion.frames.front().frame;
  const Walk walk(figure, motion);
  for (const MotionFrame& frame : motion.frames) series.com.push_back(frame.com);
  series.angular_momentum = walk.angular_momentum();
  series.mass_shifts = walk.mass_shifts();
  series.stature = walk.stature();
  series.feet = FeetOf(figure, walk, series.stature);
  return series;
}

}  // namespace hazumi
