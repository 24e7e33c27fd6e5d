#pragma once

// What a sweep has left in its folder.

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/sweep/sweep_plan.h"

namespace hazumi {

struct SweptFolder {
  std::string folder;
  SweepPlan plan;
  std::vector<std::string> names;              // of the columns: cell, fields, measures, error
  std::vector<std::vector<std::string>> rows;  // a cell each
  // Of a cell's picture; empty: it has none that can be shown.
  std::string PictureOf(size_t cell) const;
  const std::string& ErrorOf(size_t cell) const { return rows[cell].back(); }
};

// `path`: the folder, or a file in it. Errors: kNoInput, if it has no sweep that is done; kSyntax,
// kSchema.
Result<SweptFolder> ReadSweptFolder(const std::string& path);

}  // namespace hazumi
