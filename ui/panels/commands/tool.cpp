#include "ui/panels/commands/tool.h"

#include <cstdlib>

namespace hazumi::ui {

bool TypedNumber::Take(const Chord& chord) {
  if (chord.ctrl || chord.alt) return false;
  const bool is_pad = chord.key >= kPad0 && chord.key < kPad0 + 10;
  const int key = is_pad ? chord.key - kPad0 + '0' : chord.key;
  constexpr int kPadMinus = 333;
  if (key >= '0' && key <= '9') {
    if (text_ == "0") text_.clear();
    text_ += static_cast<char>(key);
  } else if ((key == kPeriod || key == kPadPeriod) && text_.find('.') == std::string::npos) {
    text_ += '.';
  } else if (key == '-' || key == kPadMinus) {
    is_negative_ = !is_negative_;
  } else if (key == kBackspace && !text_.empty()) {
    text_.pop_back();
  } else {
    return false;
  }
  return true;
}

double TypedNumber::value() const {
  const double size = std::strtod(text_.c_str(), nullptr);
  return is_negative_ ? -size : size;
}

std::string TypedNumber::shown() const { return (is_negative_ ? "-" : "") + text_ + "|"; }

}  // namespace hazumi::ui
