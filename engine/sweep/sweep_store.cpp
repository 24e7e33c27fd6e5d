#include "engine/sweep/sweep_store.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "engine/base/atomic_file.h"
#include "engine/project/json/json.h"
#include "engine/project/json/text_file.h"

namespace hazumi {

namespace {

namespace fs = std::filesystem;

// A block is what an interruption loses at most, and a file.
constexpr long kCellsInBlock = 20, kMostBlocks = 1000;

std::string Numbered(long number) {
  char text[32];
  std::snprintf(text, sizeof text, "%06ld", number);
  return text;
}

std::optional<Error> MakeFolder(const std::string& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (!failed) return std::nullopt;
  return Error{ErrorCode::kCannotWrite, folder, "", "cannot be made: " + failed.message()};
}

// In which parts of what Sweep::Identity has two texts differ, in words.
std::string Differences(const std::string& there, const std::string& wanted) {
  constexpr std::pair<const char*, const char*> kParts[] = {{"sweep", "the sweep"},
                                                            {"project", "the project"},
                                                            {"figure", "the project's figure"},
                                                            {"program", "the program"}};
  FirstError errors;
  const std::optional<Json> before = ParseJson(there, &errors), now = ParseJson(wanted, &errors);
  std::vector<std::string> parts;
  for (const auto& [name, words] : kParts) {
    if (!before || !now || !before->is_object() || !now->is_object()) break;
    const auto old = before->find(name), is = now->find(name);
    if (old != before->end() && is != now->end() && *old == *is) continue;
    parts.push_back(words);
    const bool is_told = name == std::string("program") && old != before->end() && old->is_string();
    if (is_told) parts.back() += " (there: " + old->get<std::string>() + ")";
  }
  if (parts.empty()) return "how it is written";
  std::string text = parts.front();
  for (size_t i = 1; i < parts.size(); ++i) {
    text += (i + 1 < parts.size() ? ", " : " and ") + parts[i];
  }
  return text;
}

}  // namespace

SweepStore::SweepStore(std::string folder, long cells)
    : folder_(std::move(folder)),
      cells_(cells),
      cells_in_block_(std::max(kCellsInBlock, (cells + kMostBlocks - 1) / kMostBlocks)),
      blocks_((cells + cells_in_block_ - 1) / cells_in_block_) {}

Result<SweepStore> SweepStore::Open(const std::string& folder, long cells,
                                    const std::string& identity) {
  for (const char* sub : {"", "/rows", "/pictures"}) {
    if (auto error = MakeFolder(folder + sub)) return *error;
  }
  const std::string plan = folder + "/plan.json";
  if (!fs::exists(plan)) {
    const Result<Done> written = WriteFileAtomically(plan, identity);
    if (!written.ok()) return written.error();
    return SweepStore(folder, cells);
  }
  const Result<std::string> there = ReadTextFile(plan);
  if (!there.ok()) return there.error();
  if (there.value() == identity) return SweepStore(folder, cells);
  return Error{ErrorCode::kSemantics, folder, "",
               "holds another sweep: its plan.json differs in " +
                   Differences(there.value(), identity) +
                   "; name another folder, or remove this one"};
}

long SweepStore::EndCell(long block) const {
  return std::min(cells_, FirstCell(block) + cells_in_block_);
}

std::string SweepStore::BlockPath(long block) const {
  return folder_ + "/rows/" + Numbered(FirstCell(block)) + ".csv";
}

bool SweepStore::HasBlock(long block) const { return fs::exists(BlockPath(block)); }

Result<Done> SweepStore::WriteBlock(long block, const std::string& rows) const {
  return WriteFileAtomically(BlockPath(block), rows);
}

std::string SweepStore::PicturePath(long cell, const char* suffix) const {
  return folder_ + "/pictures/" + Numbered(cell) + suffix;
}

Result<Done> SweepStore::Merge(const std::string& header) const {
  std::string all = header;
  for (long block = 0; block < blocks_; ++block) {
    const Result<std::string> rows = ReadTextFile(BlockPath(block));
    if (!rows.ok()) return rows.error();
    all += rows.value();
  }
  return WriteFileAtomically(CsvPath(), all);
}

}  // namespace hazumi
