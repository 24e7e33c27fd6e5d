#pragma once

// The folder that a sweep fills, and goes on filling after it was interrupted, on one machine or
// by many tasks at a time:
//   plan.json           what is swept, and by which program: no other sweep goes into the folder
//   rows/000000.csv     the rows of a block of cells, by its first cell; written whole
//   pictures/000000.png what is drawn of a cell, before its row; written whole
//   sweep.csv           all rows, once all blocks are there
//   sheet.png           all cells side by side

#include <atomic>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/sweep/sweep_plan.h"

namespace hazumi {

class SweepStore {
 public:
  // Makes the folder, or goes on in it. `identity`: text that differs if anything does that makes
  // the rows, as Sweep::Identity makes it. Errors: kSemantics, if another sweep is there, with the
  // parts in which it differs; kCannotWrite.
  static Result<SweepStore> Open(const std::string& folder, long cells,
                                 const std::string& identity);

  // Cells are done in blocks, of one size but for the last.
  long blocks() const { return blocks_; }
  long FirstCell(long block) const { return block * cells_in_block_; }
  long EndCell(long block) const;  // one behind its last

  bool HasBlock(long block) const;
  Result<Done> WriteBlock(long block, const std::string& rows) const;
  std::string PicturePath(long cell, const char* suffix) const;

  // Writes sweep.csv. All blocks must be there. Errors: kNoInput, kCannotWrite.
  Result<Done> Merge(const std::string& header) const;
  std::string CsvPath() const { return folder_ + "/sweep.csv"; }
  std::string SheetPath() const { return folder_ + "/sheet.png"; }

 private:
  SweepStore(std::string folder, long cells);
  std::string BlockPath(long block) const;

  std::string folder_;
  long cells_, cells_in_block_, blocks_;
};

}  // namespace hazumi
