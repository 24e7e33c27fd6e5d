#pragma once

#include <vector>

#include "ui/panels/editor.h"
#include "ui/panels/outliner_hit_test.h"

namespace hazumi::ui {

// A click into the outliner: opens or closes a row, or selects what it stands for.
void ClickOutliner(Editor* editor, const std::vector<OutlinerRow>& rows, const OutlinerHit& hit,
                   ClickMode click);

}  // namespace hazumi::ui
