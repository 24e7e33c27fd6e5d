#include "app/cli/report_text.h"

#include <functional>
#include <map>

#include "engine/base/text.h"
#include "engine/exchange/motion_text.h"
#include "engine/exchange/units.h"

namespace hazumi {

namespace {

std::string Count(int count, const std::string& one, const std::string& more) {
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

// "2 groups of 7 and 1 of 3", the largest first.
std::string GroupsText(const std::vector<int>& groups) {
  std::map<int, int, std::greater<>> counts;  // by size
  for (const int size : groups) ++counts[size];
  std::string text;
  for (const auto& [size, count] : counts) {
    text += text.empty() ? Count(count, "group", "groups") : " and " + std::to_string(count);
    text += " of " + std::to_string(size);
  }
  return text;
}

std::string FromTo(const char* what, double from, double to) {
  return std::string(what) + " " + FormatShort(from) + " to " + FormatShort(to) + " J";
}

std::string Work(const char* what, double work) {
  return std::string(", ") + what + " " + FormatShort(work) + " J";
}

std::string CostText(const RegionReport& report) {
  std::string text = Count(report.steps, "step", "steps") + ", " +
                     Count(report.evaluations, "evaluation", "evaluations");
  if (report.method == Method::kExact) {
    text += ", error estimate " + FormatShort(Degrees(report.error_estimate)) + " deg";
    if (report.estimated_until) {
      text += " up to frame " + FormatShort(*report.estimated_until) + ", where it tumbles";
    }
    if (report.branches_from) {
      text += ", one of several likely motions from frame " + FormatShort(*report.branches_from) +
              " on";
    }
  }
  text += ", " + std::to_string(static_cast<long>(report.microseconds + 0.5)) + " us";
  if (report.evaluations == 0) return text;
  return text + ", " + FormatShort(report.microseconds / report.evaluations) + " us an evaluation";
}

}  // namespace

std::string FinenessText(Method method, double step, double tolerance) {
  const std::string name = NameOf(method);
  if (method == Method::kPaper) return name + " at " + FormatNumber(step) + " s";
  return name + " to " + FormatNumber(StatedDegrees(tolerance)) + " deg";
}

std::string ModelText(const RegionReport& report, bool with_root) {
  std::string text =
      std::to_string(report.free_joints) + " of " + Count(report.all_joints, "joint", "joints");
  if (with_root) text += " and the root";
  if (!report.islands.empty()) text += ", " + GroupsText(report.islands);
  if (report.bodies > 0) text += ", " + Count(report.bodies, "body", "bodies");
  return text;
}

std::string EnergyText(const EnergyBalance& energy) {
  std::string text = FromTo("kinetic", energy.kinetic_start, energy.kinetic_end) + ", " +
                     FromTo("potential", energy.potential_start, energy.potential_end);
  for (const EnergyBalance::Work& work : energy.laws) text += Work(work.law.c_str(), work.joules);
  return text + Work("limits", energy.limits) + Work("impacts of contacts", energy.impacts) +
         Work("keys and placement", energy.keyed) + Work("unexplained", energy.residual());
}

std::vector<std::string> LinesOf(const RegionReport& report, bool with_root) {
  std::vector<std::string> lines = {ModelText(report, with_root), CostText(report)};
  if (report.energy) lines.push_back("energy: " + EnergyText(*report.energy));
  return lines;
}

}  // namespace hazumi
