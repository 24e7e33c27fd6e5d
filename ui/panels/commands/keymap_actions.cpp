// What changes the keys of the keyboard.

#include "ui/panels/commands/actions.h"

namespace hazumi::ui {

namespace {

using edit::Parameters;
using enum edit::ParameterKind;

// Which key is changed, by where it counts and what it is by default.
Result<KeyChange> KeyNamed(const Parameters& p) {
  const std::optional<Place> place = PlaceNamed(p.text("place"));
  if (!place) {
    return Error{ErrorCode::kSchema, "", "place",
                 "\"" + p.text("place") + "\" is none of anywhere, viewport, sheet"};
  }
  const std::optional<Chord> original = ChordNamed(p.text("key"));
  for (const Shortcut& shortcut : DefaultShortcuts()) {
    if (original && shortcut.place == *place && shortcut.chord == *original) {
      return KeyChange{*place, *original, *original};
    }
  }
  return Error{ErrorCode::kSchema, "", "key",
               "\"" + p.text("key") + "\" does nothing there by default"};
}

Result<Done> SetKey(Editor* editor, const Parameters& p) {
  Result<KeyChange> change = KeyNamed(p);
  if (!change.ok()) return change.error();
  if (p.has("to")) {
    const std::string to = p.text("to");
    const std::optional<Chord> chord = to.empty() ? Chord() : ChordNamed(to);
    if (!chord) return Error{ErrorCode::kSchema, "", "to", "no key is called \"" + to + "\""};
    change.value().chord = *chord;
  }
  const Chord loser = ChangeKey(change.value(), &editor->settings.keymap);
  SetKeymap(editor->settings.keymap);
  if (loser.key == kNoKey) return Done();
  for (const Shortcut& shortcut : DefaultShortcuts()) {
    if (shortcut.place != change.value().place || shortcut.chord != loser) continue;
    editor->Say(std::string(Tr("Without a key now:")) + " " + LabelOf(std::string(shortcut.id)));
  }
  return Done();
}

Result<Done> ResetKeys(Editor* editor, const Parameters&) {
  editor->settings.keymap.clear();
  SetKeymap({});
  return Done();
}

}  // namespace

std::vector<Action> KeymapActions() {
  return {
      {"keymap.set",
       "Set key of the keyboard",
       "Gives what a key does another key.",
       {{"place", kText, true, "where the mouse is: anywhere, viewport or sheet",
         "anywhere viewport sheet"},
        {"key", kText, true, "the key that it has by default: Ctrl+G"},
        {"to", kText, false, "its key now; empty: none; not given: as by default"}},
       SetKey},
      {"keymap.reset", "All keys as by default", "Takes all changes of keys back.", {}, ResetKeys}};
}

}  // namespace hazumi::ui
