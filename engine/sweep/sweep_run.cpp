#include "engine/sweep/sweep_run.h"

#include <cmath>
#include <filesystem>

#include "engine/bake/bake.h"
#include "engine/base/text.h"
#include "engine/makers/fills/fills.h"
#include "engine/project/compile.h"
#include "engine/project/figure_file.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "engine/sweep/table_text.h"

namespace hazumi {

namespace {

Error InFile(Error error, const std::string& file) {
  if (error.file.empty()) error.file = file;
  return error;
}

bool StopsTheSweep(const Error& error) {
  return error.code == ErrorCode::kInterrupted || error.code == ErrorCode::kCannotWrite;
}

bool WantsEnergy(const std::vector<SweepColumn>& columns) {
  for (const SweepColumn& column : columns) {
    if (column.quantity->wants_energy) return true;
  }
  return false;
}

}  // namespace

Result<Sweep> Sweep::Load(const std::string& path) {
  Result<SweepPlan> plan = LoadSweep(path);
  if (!plan.ok()) return plan.error();
  Sweep sweep;
  sweep.file_ = path;
  sweep.plan_ = std::move(plan).value();
  const auto folder = std::filesystem::path(path).parent_path();
  sweep.project_file_ = (folder / sweep.plan_.project).lexically_normal().string();
  Result<Project> project = LoadProject(sweep.project_file_);
  if (!project.ok()) return InFile(project.error(), sweep.project_file_);
  sweep.project_ = std::move(project).value();
  const Result<Compiled> compiled = CompileAnimation(sweep.project_);
  if (!compiled.ok()) return InFile(compiled.error(), sweep.project_file_);
  const Animation& animation = compiled.value().animation;
  sweep.figure_ = animation.figure;
  const Result<Done> fields = CheckFields(sweep.plan_, sweep.project_);
  if (!fields.ok()) return InFile(fields.error(), path);
  Result<std::vector<SweepColumn>> columns = ResolveMeasures(sweep.plan_, animation);
  if (!columns.ok()) return InFile(columns.error(), path);
  sweep.columns_ = std::move(columns).value();
  return sweep;
}

std::string Sweep::Identity(const std::string& program) const {
  return "{\"program\": \"" + program + "\",\n\"sweep\": " + WriteSweep(plan_) +
         ",\n\"project\": " + WriteProject(project_) +
         ",\n\"figure\": " + FigureText(project_.figure.spec) + "}\n";
}

std::string Sweep::Header() const {
  std::vector<std::string> names = {"cell"};
  for (const SweepAxis& axis : plan_.vary) names.push_back(axis.field);
  for (const SweepColumn& column : columns_) names.push_back(column.name);
  names.push_back("error");
  return CsvLine(names);
}

Result<SweptCell> Sweep::Compute(long cell, const std::atomic<bool>* cancel) const {
  Project project = project_;
  const Result<Done> applied = ApplyCell(plan_, cell, &project);
  if (!applied.ok()) return applied.error();
  if (!project.fills.empty()) {
    Result<makers::MadeFills> filled = makers::MakeFills(project, figure_, cancel);
    if (!filled.ok()) return filled.error();
    project = std::move(filled.value().project);
  }
  Result<Compiled> compiled = CompileAnimation(project, cancel, figure_);
  if (!compiled.ok()) return compiled.error();
  BakeOptions options;
  options.cancel = cancel;
  options.energy = WantsEnergy(columns_);
  options.threads = 1;
  Animation animation = std::move(compiled.value().animation);
  Result<Motion> motion = Bake(animation, options);
  if (!motion.ok()) return motion.error();
  return SweptCell{cell, std::move(project), std::move(animation), std::move(motion).value()};
}

Result<std::string> Sweep::RowOf(long cell, const Draw& draw,
                                 const std::atomic<bool>* cancel) const {
  std::vector<std::string> row = {std::to_string(cell)};
  for (std::string& value : ValuesOf(plan_, cell)) row.push_back(std::move(value));
  const Result<SweptCell> swept = Compute(cell, cancel);
  if (!swept.ok() && StopsTheSweep(swept.error())) return swept.error();
  for (const SweepColumn& column : columns_) {
    const double value =
        swept.ok() ? Measure(column, swept.value().animation, swept.value().motion) : NAN;
    row.push_back(std::isfinite(value) ? FormatNumber(value) : "");
  }
  row.push_back(swept.ok() ? "" : swept.error().ToString());
  if (swept.ok() && draw) {
    const Result<Done> drawn = draw(swept.value());
    if (!drawn.ok() && StopsTheSweep(drawn.error())) return drawn.error();
    if (!drawn.ok()) row.back() = drawn.error().ToString();
  }
  return CsvLine(row);
}

}  // namespace hazumi
