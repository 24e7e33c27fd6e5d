#include "engine/exchange/motion_csv.h"

#include "engine/analysis/joint_torques.h"
#include "engine/base/text.h"
#include "engine/exchange/units.h"

namespace hazumi {

namespace {

void Append(std::string* row, double value) { *row += "," + FormatNumber(value); }

std::string Header(const Figure& figure, bool torques) {
  std::string row =
      "frame,time_s,root_x_m,root_y_m,root_z_m,root_qw,root_qx,root_qy,root_qz,"
      "com_x_m,com_y_m,com_z_m,pinned";
  for (const Joint& joint : figure.joints()) row += "," + joint.name + "_deg";
  for (const Joint& joint : figure.joints()) row += "," + joint.name + "_deg_s";
  if (!torques) return row + "\n";
  for (const Joint& joint : figure.joints()) row += "," + joint.name + "_n_m";
  return row +
         ",unsupported_x_n,unsupported_y_n,unsupported_z_n,unsupported_x_n_m,unsupported_y_n_m,"
         "unsupported_z_n_m\n";
}

std::string Row(const Figure& figure, const Motion& motion, const MotionFrame& frame,
                const Eigen::Quaterniond& turn, const JointTorques* torques) {
  std::string row = std::to_string(frame.frame);
  Append(&row, motion.rate.SecondsAt(frame.frame));
  for (const double x : frame.X_WR.p) Append(&row, x);
  for (const double x : {turn.w(), turn.x(), turn.y(), turn.z()}) Append(&row, x);
  for (const double x : frame.com) Append(&row, x);
  row += "," + (frame.pinned ? figure.group(*frame.pinned).name : std::string());
  for (const double q : frame.q) Append(&row, Degrees(q));
  for (const double qd : frame.after.qd) Append(&row, Degrees(qd));
  if (torques) {
    for (const double tau : torques->tau) Append(&row, tau);
    for (const double x : torques->unsupported.force) Append(&row, x);
    for (const double x : torques->unsupported.moment) Append(&row, x);
  }
  return row + "\n";
}

}  // namespace

std::string MotionToCsv(const Animation& animation, const Motion& motion, bool torques) {
  std::string text = Header(*animation.figure, torques);
  std::vector<JointTorques> needed;
  if (torques) needed = TorquesOf(animation, motion);
  size_t written = 0;
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  for (const MotionFrame& frame : motion.frames) {
    turn = NearQuaternion(frame.X_WR.R, turn);
    text += Row(*animation.figure, motion, frame, turn, torques ? &needed[written++] : nullptr);
  }
  return text;
}

}  // namespace hazumi
