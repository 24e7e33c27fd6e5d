#pragma once

#include <memory>
#include <optional>

#include "engine/sweep/swept_folder.h"

namespace hazumi::ui {

// The sweep whose cells are looked at, among the properties.
struct SweepState {
  std::shared_ptr<const SweptFolder> swept;  // null: none is open
  std::optional<size_t> cell;                // whose values the project has for the time being
  std::optional<size_t> pictured;            // the cell whose picture was read last
  unsigned texture = 0;                      // with it; 0: there is none
  double aspect = 0.0;                       // width over height of all pictures; 0: there are none
  std::optional<size_t> kept;                // the cell that was kept last
  long document = 0;                         // the session's number of the one it was opened for
};

}  // namespace hazumi::ui
