#include "ui/edit/operators/pose/turned_hinges.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "engine/figure/hinge_row.h"

namespace hazumi::edit {

namespace {

constexpr double kOnAxis = 1e-6;  // so near to an axis a point stays where it is [m]

// The joints from the first hinge to the last one, from the root outwards.
std::vector<JointIndex> From(JointIndex first, JointIndex last, const Figure& figure) {
  std::vector<JointIndex> joints;
  for (JointIndex j = last; j.is_valid() && j >= first; j = figure.joint(j).parent) {
    joints.push_back(j);
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
}

// R_WB = R_WP * (the row) * R_end, P being the body before the first hinge.
struct TurnedRow {
  HingeRow row;
  Mat3 R_end = Mat3::Identity();
};

TurnedRow RowOf(JointIndex body, const std::vector<JointIndex>& hinges, const Figure& figure,
                const VecX& q) {
  TurnedRow turned;
  for (const JointIndex j : From(hinges.front(), body, figure)) {
    const Joint& joint = figure.joint(j);
    turned.R_end = turned.R_end * joint.X_PJ.R;
    if (std::find(hinges.begin(), hinges.end(), j) != hinges.end()) {
      turned.row.push_back({turned.R_end * joint.axis, joint.is_fixed()});
    } else {
      turned.R_end = turned.R_end * Eigen::AngleAxisd(q[j.value()], joint.axis);
    }
  }
  return turned;
}

// Puts angles that are beyond their limits on them and keeps them there; false if none is.
bool StopAtLimits(const std::vector<JointIndex>& hinges, const Figure& figure,
                  std::vector<double>* angles, HingeRow* row) {
  bool has_stopped = false;
  for (size_t i = 0; i < hinges.size(); ++i) {
    const Joint& joint = figure.joint(hinges[i]);
    const double within = std::clamp((*angles)[i], joint.lower, joint.upper);
    if (within == (*angles)[i]) continue;
    (*angles)[i] = within;
    (*row)[i].is_fixed = has_stopped = true;
  }
  return has_stopped;
}

}  // namespace

double TurnHinges(JointIndex body, const Mat3& R_WB, const std::vector<JointIndex>& hinges,
                  const Figure& figure, const DynamicsWorkspace& ws, VecX* q) {
  if (hinges.empty()) return 0.0;
  TurnedRow turned = RowOf(body, hinges, figure, *q);
  const Mat3& R_WP = ws.body(figure.joint(hinges.front()).parent).R;
  const Mat3 R = R_WP.transpose() * R_WB * turned.R_end.transpose();
  std::vector<double> angles;
  angles.reserve(hinges.size());
  for (const JointIndex j : hinges) angles.push_back((*q)[j.value()]);
  double left = TurnTo(R, turned.row, &angles);
  while (StopAtLimits(hinges, figure, &angles, &turned.row)) {
    left = TurnTo(R, turned.row, &angles);
  }
  for (size_t i = 0; i < hinges.size(); ++i) (*q)[hinges[i].value()] = angles[i];
  return left;
}

std::vector<JointIndex> TurnInPlace(GroupIndex joint, const std::vector<JointIndex>& may_turn,
                                    const Figure& figure, const DynamicsWorkspace& ws) {
  const auto may = [&](JointIndex j) {
    return std::find(may_turn.begin(), may_turn.end(), j) != may_turn.end();
  };
  const JointGroup& own = figure.group(joint);
  const Vec3& origin = ws.body(own.first).p;
  std::vector<JointIndex> hinges;
  for (JointIndex j = own.last(); j.is_valid(); j = figure.joint(j).parent) {
    const BodyScratch& body = ws.body(j);
    const bool goes_through = body.axis.cross(origin - body.p).norm() < kOnAxis;
    const bool is_own = j >= own.first;
    if (!is_own && !goes_through) break;
    if (may(j)) hinges.push_back(j);
  }
  std::reverse(hinges.begin(), hinges.end());
  return hinges;
}

}  // namespace hazumi::edit
