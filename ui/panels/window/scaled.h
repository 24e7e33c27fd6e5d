#pragma once

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// A length at the interface's scale [px].
inline float Px(const Editor& editor, double at_scale_1) {
  return static_cast<float>(at_scale_1 * editor.settings.scale);
}

}  // namespace hazumi::ui
