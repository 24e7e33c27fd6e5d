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
  double aspect = 1.0;                       // width over height of that picture
  unsigned texture = 0;                      // with it; 0: there is none
};

}  // namespace hazumi::ui
