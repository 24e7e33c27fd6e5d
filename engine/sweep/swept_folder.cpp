#include "engine/sweep/swept_folder.h"

#include <cstdio>
#include <filesystem>

#include "engine/project/json/json.h"
#include "engine/project/json/text_file.h"
#include "engine/sweep/table_text.h"

namespace hazumi {

namespace {

namespace fs = std::filesystem;

Result<SweepPlan> ReadPlan(const std::string& file) {
  const Result<std::string> text = ReadTextFile(file);
  if (!text.ok()) return text.error();
  FirstError errors;
  const std::optional<Json> json = ParseJson(text.value(), &errors);
  if (!json) return errors.In(file);
  if (!json->is_object() || !json->contains("sweep")) {
    return Error{ErrorCode::kSchema, file, "", "is no plan of a sweep"};
  }
  return ParseSweep(CompactJson((*json)["sweep"]), file);
}

// Each row has a field a column, and the fields' names are those of the plan.
bool Fits(const SweptFolder& swept) {
  if (swept.names.size() < swept.plan.vary.size() + 2) return false;
  if (swept.rows.size() != static_cast<size_t>(CellCount(swept.plan))) return false;
  for (const auto& row : swept.rows) {
    if (row.size() != swept.names.size()) return false;
  }
  return true;
}

}  // namespace

std::string SweptFolder::PictureOf(size_t cell) const {
  if (!plan.picture || plan.picture->video || !ErrorOf(cell).empty()) return "";
  char name[32];
  std::snprintf(name, sizeof name, "/pictures/%06zu.png", cell);
  return folder + name;
}

Result<SweptFolder> ReadSweptFolder(const std::string& path) {
  std::error_code failed;
  const fs::path folder =
      fs::is_directory(path, failed) ? fs::path(path) : fs::path(path).parent_path();
  SweptFolder swept;
  swept.folder = folder.string();
  Result<SweepPlan> plan = ReadPlan((folder / "plan.json").string());
  if (!plan.ok()) return plan.error();
  swept.plan = std::move(plan).value();
  const std::string csv = (folder / "sweep.csv").string();
  const Result<std::string> text = ReadTextFile(csv);
  if (!text.ok()) return text.error();
  swept.rows = ReadCsv(text.value());
  if (!swept.rows.empty()) {
    swept.names = std::move(swept.rows.front());
    swept.rows.erase(swept.rows.begin());
  }
  if (!Fits(swept)) {
    return Error{ErrorCode::kSchema, csv, "", "does not go with the plan beside it: sweep again"};
  }
  return swept;
}

}  // namespace hazumi
