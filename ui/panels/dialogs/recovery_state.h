#pragma once

#include <functional>
#include <vector>

#include "ui/edit/recovery/recovery.h"

namespace hazumi::ui {

// What a crash left behind and the user has not been asked about yet.
struct RecoveryState {
  std::vector<edit::AbandonedJournal> journals;
  // Takes the work up again, or throws it away; given by whoever keeps the journals.
  std::function<void(const edit::AbandonedJournal& journal, bool recovers)> answer;
};

}  // namespace hazumi::ui
