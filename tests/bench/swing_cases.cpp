#include "tests/bench/swing_cases.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/spatial/degrees.h"
#include "tests/bench/peer_joints.h"
#include "tests/support/arm7_cases.h"
#include "tests/support/figures.h"

namespace hazumi::bench {

namespace {

using test::Vec7;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double Finite(double error) { return std::isfinite(error) ? error : kInfinity; }

// Error measured by the largest difference of any angle.
void MeasureAngles(const VecX& reference, double reference_error, SwingCase* c) {
  c->reference_error = reference_error;
  c->error = [reference](const VecX& end) {
    return Finite((end - reference).cwiseAbs().maxCoeff());
  };
}

SwingCase FromArmCase(const test::ArmCase& from, const char* name) {
  SwingCase c;
  c.name = name;
  c.q = from.start_deg * kDegree;
  c.qd = from.start_rate;
  c.seconds = test::kArmCaseFrames / 30.0;
  c.friction = from.friction;
  c.lower = from.lower_deg * kDegree;
  c.upper = from.upper_deg * kDegree;
  MeasureAngles(from.converged_deg * kDegree, 5e-9, &c);
  return c;
}

SwingCase Arm7Smooth() {
  SwingCase c = FromArmCase(test::FreeSwing(), "arm7_smooth");
  Vec7 end;
  c.q << -1.9, -0.55, 0.4, -1.2, 0.3, 0.2, 0.4;
  c.qd << 7, 1.5, -5, 8, -5, 2, -6;
  c.seconds = 0.333;
  end << 0.91297009514671068, 0.36683488250342139, 0.51707207006961065, -0.17068640145947397,
      -4.029686922842747, 1.0255087413029431, -0.12321511550551228;
  MeasureAngles(end, 1e-13, &c);
  return c;
}

SwingCase WithLimits() {
  SwingCase c = FromArmCase(test::SwingWithLimits(), "swing_with_limits");
  c.is_free = false;
  return c;
}

// The shoulder's angles are ill-determined there, so its error is that of its orientation.
SwingCase NearGimbal() {
  SwingCase c = FromArmCase(test::NearGimbal(), "near_gimbal");
  c.singular = true;
  c.reference_error = 1e-8;
  const Figure arm = test::Arm7();
  const BallJoint shoulder(arm, arm.groups()[0]);
  const Eigen::Quaterniond turn(0.711424127, 0.614374034, 0.071752579, -0.333574317);
  const Mat3 R_end = turn.normalized().toRotationMatrix();
  const VecX reference = test::NearGimbal().converged_deg.tail<4>() * kDegree;
  c.error = [shoulder, R_end, reference](const VecX& end) {
    // |R - R_end| = 2 sqrt(2) sin(angle / 2)
    const double distance = (shoulder.Rotation(end) - R_end).norm() / std::sqrt(8.0);
    const double turned = 2.0 * std::asin(std::min(1.0, distance));
    return Finite(std::max(turned, (end.tail<4>() - reference).cwiseAbs().maxCoeff()));
  };
  return c;
}

}  // namespace

std::vector<SwingCase> SwingCases() {
  return {Arm7Smooth(), FromArmCase(test::FreeSwing(), "free_swing"), WithLimits(), NearGimbal()};
}

}  // namespace hazumi::bench
