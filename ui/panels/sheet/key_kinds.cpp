#include "ui/panels/sheet/key_kinds.h"

namespace hazumi::ui {

const std::vector<KeyChoice>& InterpolationChoices() {
  const auto kind = [](const char* word, const char* label, bool begins_group = false) {
    return KeyChoice{"keys.interpolation", {{"interpolation", word}}, label, begins_group};
  };
  const auto easing = [](const char* word, const char* label, bool begins_group = false) {
    return KeyChoice{"keys.easing", {{"easing", word}}, label, begins_group};
  };
  static const std::vector<KeyChoice> choices = {
      kind("hold", "Hold"),
      kind("linear", "Linear"),
      kind("quadratic", "Quadratic"),
      kind("cubic", "Cubic"),
      kind("least_acceleration", "Least acceleration"),
      kind("least_jerk", "Least jerk"),
      kind("sine", "Sine", true),
      kind("quintic", "Quintic"),
      kind("exponential", "Exponential"),
      kind("back", "Overshoot"),
      kind("bounce", "Bounce"),
      kind("elastic", "Elastic"),
      easing("in", "Ease in", true),
      easing("out", "Ease out"),
      easing("in_out", "Ease in and out"),
  };
  return choices;
}

const std::vector<KeyChoice>& HandleChoices() {
  const auto kind = [](const char* word, const char* label, bool begins_group = false) {
    return KeyChoice{"keys.handles", {{"kind", word}}, label, begins_group};
  };
  static const std::vector<KeyChoice> choices = {
      kind("auto", "Automatic"),
      kind("flat", "Flat"),
      kind("aligned", "Aligned"),
      kind("broken", "Broken"),
      kind("free_length", "Free length", true),
      kind("fixed_length", "Fixed length"),
  };
  return choices;
}

const std::vector<KeyChoice>& KeyTypeChoices() {
  const auto type = [](const char* word, const char* label) {
    return KeyChoice{"keys.type", {{"type", word}}, label};
  };
  static const std::vector<KeyChoice> choices = {
      type("keyframe", "Keyframe"), type("breakdown", "Breakdown"),     type("extreme", "Extreme"),
      type("jitter", "Jitter"),     type("moving_hold", "Moving hold"),
  };
  return choices;
}

}  // namespace hazumi::ui
