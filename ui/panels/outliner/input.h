#pragma once

#include <vector>

#include "ui/panels/outliner/hit_test.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// A click into the outliner: opens or closes a row, or selects what it stands for.
void ClickOutliner(Editor* editor, const std::vector<OutlinerRow>& rows, const OutlinerHit& hit,
                   ClickMode click);

}  // namespace hazumi::ui
