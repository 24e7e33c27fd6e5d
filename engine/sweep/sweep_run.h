#pragma once

// Computes the cells of a sweep.

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/sweep/quantities.h"
#include "engine/sweep/sweep_plan.h"

namespace hazumi {

// What a cell's values make of the project.
struct SweptCell {
  long number = 0;
  Project project;
  Animation animation;
  Motion motion;
};

class Sweep {
 public:
  // Reads the sweep file and the project that it names, and checks every field, value and measure.
  // Errors: of reading both; kSchema and kSemantics of what does not fit, with file and place.
  static Result<Sweep> Load(const std::string& path);

  const SweepPlan& plan() const { return plan_; }
  const Project& project() const { return project_; }
  const std::string& project_file() const { return project_file_; }
  const std::vector<SweepColumn>& columns() const { return columns_; }
  long cells() const { return CellCount(plan_); }
  // Whatever makes the rows: the sweep, the project with its figure, and `program`.
  std::string Identity(const std::string& program) const;

  // "cell,regions[arms].friction.default,...,landing_x_m ball,...,error"
  std::string Header() const;
  // Draws a cell, or says why not.
  using Draw = std::function<Result<Done>(const SweptCell& cell)>;
  // The cell's row, with its line end. Whatever is wrong with a cell stands in its last column;
  // only an interruption and what `draw` cannot write (kCannotWrite) are errors. `draw` may be
  // empty.
  Result<std::string> RowOf(long cell, const Draw& draw,
                            const std::atomic<bool>* cancel = nullptr) const;

 private:
  Sweep() = default;
  Result<SweptCell> Compute(long cell, const std::atomic<bool>* cancel) const;

  std::string file_, project_file_;
  SweepPlan plan_;
  Project project_;
  std::shared_ptr<const Figure> figure_;
  std::vector<SweepColumn> columns_;
};

}  // namespace hazumi
