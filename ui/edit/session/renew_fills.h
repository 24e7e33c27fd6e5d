#pragma once

#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/figure/figure.h"
#include "engine/makers/fills/fills.h"
#include "engine/project/project.h"

namespace hazumi::edit {

// States of a project around an edit.
struct FillEdit {
  const Project& before;
  const Project* drag_start = nullptr;  // when the drag began that the edit is part of, or null
  bool is_stale = false;                // the fills could not be made after an earlier edit
};

// Makes the keys of the fills anew if the edit changed what they depend on; part of its undo step.
// - A generated key that the edit moved or changed becomes the animator's.
// - A frame on which only some hinges of a filled joint got keys gets keys of the others, with the
//   angles that are seen: the joint keeps its pose there.
// `figure`: that of `after`; null where the edit changed it. Returns a report for each fill, or
// none if they stay as they are. Errors: as MakeFills; the keys are then the old ones.
Result<std::vector<makers::FillReport>> RenewFills(const FillEdit& edit,
                                                   std::shared_ptr<const Figure> figure,
                                                   Project* after);

}  // namespace hazumi::edit
