#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/sweep/sweep_run.h"
#include "engine/sweep/sweep_store.h"

namespace hazumi {

// The lines of sweep.csv, its header first.
using Rows = std::vector<std::vector<std::string>>;

// Draws all cells onto sheet.png: the last axis of a grid across, the one before down, a panel for
// each value of the others; other sweeps in their order. A cell is its picture, or the colour and
// number of the first measure. False, after a warning: there are too many cells to see them.
// Errors: of reading the pictures and writing.
Result<bool> WriteSweepSheet(const Sweep& sweep, const SweepStore& store, const Rows& rows);

}  // namespace hazumi
