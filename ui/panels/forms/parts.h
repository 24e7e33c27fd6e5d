#pragma once

// Internal: the fields of a form.

#include "ui/panels/dialogs/parts.h"
#include "ui/panels/forms/offers.h"

namespace hazumi::ui {

// A list of names as ticks, a line a limb.
void DrawTicks(const std::vector<FormOption>& options, FormField* field, Editor* editor);

}  // namespace hazumi::ui
