#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/report_text.h"
#include "app/cli/terminal.h"
#include "engine/analysis/effort.h"
#include "engine/analysis/seam_report.h"
#include "engine/base/text.h"
#include "engine/exchange/motion_text.h"
#include "engine/exchange/units.h"
#include "engine/project/project_files.h"

namespace hazumi {

namespace {

using Json = nlohmann::ordered_json;

// By the names that --bake uses.
void AddExact(const RegionReport& report, Json* region) {
  (*region)["tolerance_deg"] = StatedDegrees(report.tolerance);
  (*region)["groups"] = report.islands;
  (*region)["bodies"] = report.bodies;
  (*region)["error_estimate_deg"] = Degrees(report.error_estimate);
  if (report.estimated_until) (*region)["estimated_until_frame"] = *report.estimated_until;
  if (report.branches_from) (*region)["branches_from_frame"] = *report.branches_from;
}

Json EnergyAsJson(const EnergyBalance& energy) {
  Json json;
  for (const auto& [name, joules] : TermsOf(energy)) json[name] = joules;
  return json;
}

Json RegionAsJson(const DynamicsRegion& region, const RegionReport& report) {
  if (region.is_muted) {
    return {{"name", region.name},
            {"first_frame", region.first_frame},
            {"last_frame", region.last_frame},
            {"mute", true}};
  }
  Json json = {{"name", region.name},
               {"first_frame", region.first_frame},
               {"last_frame", region.last_frame},
               {"joints", region.joints.size()},
               {"root", region.root},
               {"method", NameOf(region.method)},
               {"steps", report.steps},
               {"evaluations", report.evaluations},
               {"microseconds", report.microseconds}};
  if (region.method == Method::kExact) AddExact(report, &json);
  if (region.method == Method::kPaper) json["step_s"] = report.step;
  if (report.energy) json["energy_j"] = EnergyAsJson(*report.energy);
  return json;
}

Json SolverAsJson(const SolverSettings& solver) {
  Json json = {{"method", NameOf(solver.method)}};
  if (solver.method == Method::kExact) json["tolerance_deg"] = StatedDegrees(solver.tolerance);
  if (solver.method == Method::kPaper) json["step_s"] = solver.step;
  json["version"] = solver.version;
  return json;
}

Json RegionsAsJson(const BakedProject& baked) {
  Json list = Json::array();
  for (size_t i = 0; i < baked.animation.regions.size(); ++i) {
    list.push_back(RegionAsJson(baked.animation.regions[i], baked.motion.regions[i]));
  }
  return list;
}

Json EventsAsJson(const Motion& motion) {
  Json list = Json::array();
  for (const MotionEvent& event : motion.events) {
    list.push_back({{"kind", NameOf(event.kind)},
                    {"frame", event.frame},
                    {"time_s", event.time},
                    {"joint", event.joint}});
    if (event.kind == EventKind::kTouchDown) {
      list.back()["link"] = event.link;
      list.back()["on"] = event.on;
    }
    if (event.count == 1) continue;
    list.back()["count"] = event.count;
    list.back()["last_time_s"] = event.last_time;
  }
  return list;
}

Json SeamsAsJson(const BakedProject& baked) {
  Json list = Json::array();
  for (const Seam& seam : baked.motion.seams) {
    list.push_back(Json::parse(SeamToJson(baked.animation, seam)));
  }
  return list;
}

Json InfoAsJson(const BakedProject& baked, const std::string& name) {
  const Animation& animation = baked.animation;
  const Figure& figure = *animation.figure;
  return {{"name", name},
          {"frames", {animation.first_frame, animation.last_frame}},
          {"fps", animation.rate.frames_per_second()},
          {"solver", SolverAsJson(animation.solver)},
          {"figure",
           {{"name", figure.name()},
            {"joints", figure.num_joints()},
            {"links", figure.links().size()},
            {"mass_kg", figure.total_mass()}}},
          {"regions", RegionsAsJson(baked)},
          {"events", EventsAsJson(baked.motion)},
          {"seams", SeamsAsJson(baked)}};
}

void PrintRegions(const BakedProject& baked) {
  for (size_t i = 0; i < baked.animation.regions.size(); ++i) {
    const DynamicsRegion& region = baked.animation.regions[i];
    const RegionReport& report = baked.motion.regions[i];
    if (region.is_muted) {
      PrintLine(stdout, "region     %s: F%d-F%d, muted", region.name.c_str(), region.first_frame,
                region.last_frame);
      continue;
    }
    PrintLine(stdout, "region     %s: F%d-F%d, %s", region.name.c_str(), region.first_frame,
              region.last_frame,
              FinenessText(report.method, report.step, report.tolerance).c_str());
    for (const std::string& line : LinesOf(report, region.root)) {
      PrintLine(stdout, "           %s", line.c_str());
    }
  }
}

void PrintPlacements(const Animation& animation) {
  for (const PlacementSpan& span : animation.placements) {
    PrintLine(stdout, "placement  F%d-F%d: %s%s%s", span.first_frame, span.last_frame,
              NameOf(span.kind), span.pin ? " " : "",
              span.pin ? animation.figure->group(*span.pin).name.c_str() : "");
  }
  for (const IkHold& hold : animation.holds) {
    PrintLine(stdout, "hold       F%d-F%d: %s", hold.first_frame, hold.last_frame,
              animation.figure->group(hold.joint).name.c_str());
  }
  for (const OuterForce& force : animation.forces) {
    PrintLine(stdout, "force      %s: %s, F%d-F%d", force.name.c_str(), NameOf(force.kind()),
              force.first_frame, force.last_frame);
  }
  for (const Constraint& constraint : animation.constraints) {
    PrintLine(stdout, "constraint %s: %s, F%d-F%d", constraint.name.c_str(),
              NameOf(constraint.kind), constraint.first_frame, constraint.last_frame);
  }
}

// Subject of an event: a joint, or for a touch-down the link and what the link touches.
std::string SubjectOf(const MotionEvent& event) {
  if (event.kind != EventKind::kTouchDown) return event.joint;
  return event.link + " on " + event.on;
}

std::string AgainText(const MotionEvent& event) {
  if (event.count == 1) return "";
  return ", " + std::to_string(event.count) + " times until " + FormatShort(event.last_time) + " s";
}

void PrintEvents(const Motion& motion) {
  for (const MotionEvent& event : motion.events) {
    PrintLine(stdout, "%-10s  frame %4d  %10.6f s  %s%s", NameOf(event.kind), event.frame,
              event.time, SubjectOf(event).c_str(), AgainText(event).c_str());
  }
}

void Print(const BakedProject& baked, const std::string& name) {
  const Animation& animation = baked.animation;
  const Figure& figure = *animation.figure;
  PrintLine(stdout, "%s", name.c_str());
  PrintLine(stdout, "frames     F%d-F%d at %g fps", animation.first_frame, animation.last_frame,
            animation.rate.frames_per_second());
  PrintLine(stdout, "figure     %s: %d joints, %zu links, %g kg", figure.name().c_str(),
            figure.num_joints(), figure.links().size(), figure.total_mass());
  const SolverSettings& solver = animation.solver;
  PrintLine(stdout, "solver     %s, version %d",
            FinenessText(solver.method, solver.step, solver.tolerance).c_str(), solver.version);
  PrintRegions(baked);
  PrintPlacements(animation);
  PrintEvents(baked.motion);
  for (const std::string& line : SeamReport(animation, baked.motion.seams)) {
    PrintLine(stdout, "seam       %s", line.c_str());
  }
}

}  // namespace

struct EffortTexts {
  // Largest effort, or all efforts if requested; empty for a motion without frames.
  std::vector<std::string> effort;
  std::vector<std::string> problems;
};

static EffortTexts EffortTextsOf(const BakedProject& baked, const Options& options) {
  const auto& [project, animation, motion, warnings] = baked;
  const Effort effort = EffortOf(animation, motion);
  EffortTexts texts;
  texts.effort = options.effort ? EffortReport(animation, motion, effort)
                                : BriefEffortReport(animation, motion, effort);
  texts.problems = ProblemTexts(baked, effort);
  return texts;
}

int RunInfo(const Options& options) {
  const Result<BakedProject> baked = LoadAndBake(options.files[0], options);
  if (!baked.ok()) return Complain(baked.error());
  const std::string name = ShownName(baked.value().project.name, options.files[0]);
  if (options.json) {
    Json info = InfoAsJson(baked.value(), name);
    const EffortTexts texts = EffortTextsOf(baked.value(), options);
    info["effort"] = texts.effort;
    info["problems"] = texts.problems;
    const auto text = info.dump(2, ' ', false, Json::error_handler_t::replace);
    std::printf("%s\n", text.c_str());
    return kExitOk;
  }
  PrintWarnings(options.files[0], baked.value().warnings);
  Print(baked.value(), name);
  const EffortTexts texts = EffortTextsOf(baked.value(), options);
  for (const std::string& line : texts.effort) PrintLine(stdout, "effort     %s", line.c_str());
  for (const std::string& line : texts.problems) PrintLine(stdout, "problem    %s", line.c_str());
  return kExitOk;
}

}  // namespace hazumi
