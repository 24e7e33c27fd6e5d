#include "ui/shell/input_queue.h"

#include <imgui.h>

#include <optional>
#include <set>
#include <utility>

#include "ui/panels/commands/keys.h"

namespace hazumi::ui {

namespace {

using Kind = InputEvent::Kind;

bool IsModifier(int key) { return key >= kLeftShift && key <= kRightAlt; }

// What a frame has room for once.
bool IsDeed(const InputEvent& event) {
  const bool goes_down = event.kind == Kind::kKey && event.is_down && !IsModifier(event.code);
  return goes_down || event.kind == Kind::kButton || event.kind == Kind::kWheel;
}

// Whether what happened after a deed may be seen with it.
bool GoesWith(const InputEvent& event, const InputEvent& deed) {
  if (deed.kind == Kind::kWheel) return event.kind == Kind::kWheel;
  if (deed.kind != Kind::kKey) return false;
  const bool goes_up = event.kind == Kind::kKey && !event.is_down;
  return event.kind == Kind::kText ||
         (goes_up && event.code != deed.code && !IsModifier(event.code));
}

void SetKey(int key, bool is_down, ImGuiIO* io) {
  if (key < 0 || key >= IM_ARRAYSIZE(io->KeysDown)) return;
  io->KeysDown[key] = is_down;
  const auto held = [io](Key left, Key right) { return io->KeysDown[left] || io->KeysDown[right]; };
  io->KeyShift = held(kLeftShift, kRightShift);
  io->KeyCtrl = held(kLeftControl, kRightControl);
  io->KeyAlt = held(kLeftAlt, kRightAlt);
}

void Apply(const InputEvent& event, ImGuiIO* io) {
  switch (event.kind) {
    case Kind::kMove:
      io->MousePos = {event.x, event.y};
      break;
    case Kind::kButton:
      if (event.code >= 0 && event.code < IM_ARRAYSIZE(io->MouseDown)) {
        io->MouseDown[event.code] = event.is_down;
      }
      break;
    case Kind::kWheel:
      io->MouseWheelH += event.x;
      io->MouseWheel += event.y;
      break;
    case Kind::kKey:
      SetKey(event.code, event.is_down, io);
      break;
    case Kind::kText:
      io->AddInputCharacter(static_cast<unsigned>(event.code));
      break;
  }
}

}  // namespace

// A key that gives a letter, which is told right after it.
bool InputQueue::IsLetter() const {
  const bool is_key = events_.front().kind == Kind::kKey && events_.front().is_down;
  return is_key && events_.size() > 1 && events_[1].kind == Kind::kText;
}

// A drag goes to where the button was let go before it is over.
void InputQueue::Feed(bool types, ImGuiIO* io) {
  // A field that Tab leads to takes letters from the frame after the next on.
  if (frames_to_wait_ > 0 && frames_to_wait_-- > 0) return;
  std::optional<InputEvent> deed;
  bool has_text = false, has_moved = false;
  std::set<int> released;  // a key that goes down again does so in another frame
  while (!events_.empty()) {
    const InputEvent event = events_.front();
    if (types && !deed && IsLetter()) {  // the field asks for the letter, not for the key
      events_.pop_front();
      continue;
    }
    const bool ends_drag = event.kind == Kind::kButton && !event.is_down && has_moved;
    const bool is_down_again =
        event.kind == Kind::kKey && event.is_down && released.contains(event.code);
    if (ends_drag || is_down_again || (deed ? !GoesWith(event, *deed) : has_text && IsDeed(event)))
      return;
    Apply(event, io);
    events_.pop_front();
    if (IsDeed(event)) deed = event;
    if (event.kind == Kind::kKey && event.is_down && event.code == kTab) frames_to_wait_ = 2;
    if (event.kind == Kind::kKey && !event.is_down) released.insert(event.code);
    has_text |= event.kind == Kind::kText;
    has_moved |= event.kind == Kind::kMove;
  }
}

}  // namespace hazumi::ui
