#include "engine/analysis/effort.h"
#include "engine/base/text.h"
#include "engine/exchange/motion_text.h"
#include "engine/exchange/units.h"

namespace hazumi {

namespace {

void Append(std::string* row, double value) { *row += "," + FormatNumber(value); }

void AddNames(const Figure& figure, const char* suffix, std::string* row) {
  for (const Joint& joint : figure.joints()) *row += "," + joint.name + suffix;
}

void AddWrenchNames(const std::string& name, std::string* row) {
  for (const char* suffix : {"_x_n", "_y_n", "_z_n", "_x_n_m", "_y_n_m", "_z_n_m"}) {
    *row += "," + name + suffix;
  }
}

void Append(std::string* row, const Wrench& wrench) {
  for (const double x : wrench.force) Append(row, x);
  for (const double x : wrench.moment) Append(row, x);
}

std::string Header(const Figure& figure, bool torques, bool effort) {
  std::string row =
      "frame,time_s,root_x_m,root_y_m,root_z_m,root_qw,root_qx,root_qy,root_qz,"
      "com_x_m,com_y_m,com_z_m,pinned";
  AddNames(figure, "_deg", &row);
  AddNames(figure, "_deg_s", &row);
  if (torques) {
    AddNames(figure, "_n_m", &row);
    AddWrenchNames("unsupported", &row);
  }
  if (effort) {
    AddNames(figure, "_effort_n_m", &row);
    AddNames(figure, "_effort", &row);
    AddWrenchNames("from_nowhere", &row);
  }
  return row + "\n";
}

std::string Row(const Figure& figure, const Motion& motion, const MotionFrame& frame,
                const Eigen::Quaterniond& turn, const FrameEffort* torques,
                const FrameEffort* effort) {
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
    Append(&row, torques->from_nowhere);
  }
  if (effort) {
    for (const double tau : effort->tau) Append(&row, tau);
    for (const double share : effort->share) {
      row += ",";
      if (share >= 0.0) row += FormatNumber(share);
    }
    Append(&row, effort->from_nowhere);
  }
  return row + "\n";
}

}  // namespace

std::string MotionToCsv(const Animation& animation, const Motion& motion, bool torques,
                        bool effort) {
  std::string text = Header(*animation.figure, torques, effort);
  Effort asked;
  if (torques || effort) asked = EffortOf(animation, motion);
  size_t written = 0;
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  for (const MotionFrame& frame : motion.frames) {
    turn = NearQuaternion(frame.X_WR.R, turn);
    text += Row(*animation.figure, motion, frame, turn, torques ? &asked.frames[written] : nullptr,
                effort ? &asked.frames[written] : nullptr);
    ++written;
  }
  return text;
}

}  // namespace hazumi
