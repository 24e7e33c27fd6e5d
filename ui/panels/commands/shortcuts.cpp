#include "ui/panels/commands/actions.h"
#include "ui/panels/commands/keymap.h"

namespace hazumi::ui {

// As in Blender. What has a place goes before what counts anywhere.
const std::vector<Shortcut>& DefaultShortcuts() {
  using enum Place;
  static const std::vector<Shortcut> shortcuts = {
      {{'N', true}, kAnywhere, "app.new"},
      {{'O', true}, kAnywhere, "file.open_dialog"},
      {{'S', true}, kAnywhere, "app.save"},
      {{'S', true, true}, kAnywhere, "file.save_as"},
      {{kComma, true}, kAnywhere, "app.preferences"},
      {{kF1}, kAnywhere, "help.manual"},
      {{kF3}, kAnywhere, "app.search"},
      {{kEscape}, kAnywhere, "motion.stop"},
      {{kF12}, kAnywhere, "render.dialog"},
      {{kF12, true}, kAnywhere, "render.dialog", {{"whole", true}}},
      {{'Q', true}, kAnywhere, "app.quit"},
      {{'Z', true}, kAnywhere, "edit.undo"},
      {{'Z', true, true}, kAnywhere, "edit.redo"},
      {{'C', true}, kViewport, "pose.copy"},
      {{'V', true}, kViewport, "pose.paste"},
      {{'V', true, true}, kAnywhere, "pose.paste", {{"flipped", true}}},
      {{'I'}, kAnywhere, "key.insert"},
      {{'I', false, false, true}, kAnywhere, "key.delete"},
      {{'A'}, kViewport, "select.all"},
      {{'A', false, false, true}, kViewport, "select.joints", {{"joints", Json::array()}}},
      {{'A', false, true}, kViewport, "view.add_menu"},
      {{'R', false, false, true}, kViewport, "pose.clear"},
      {{'G', false, false, true}, kViewport, "root.to_ground"},
      {{'E', false, true}, kViewport, "tool.breakdown"},
      {{'E', false, false, true}, kViewport, "tool.relax"},
      {{'H'}, kViewport, "joint.hide"},
      {{'H', false, false, true}, kViewport, "joint.show_all"},
      {{kSpace}, kAnywhere, "time.play"},
      {{kRight}, kAnywhere, "time.step", {{"by", 1}}},
      {{kLeft}, kAnywhere, "time.step", {{"by", -1}}},
      {{kRight, false, true}, kAnywhere, "time.to_end", {{"last", true}}},
      {{kLeft, false, true}, kAnywhere, "time.to_end", {{"last", false}}},
      {{kUp}, kAnywhere, "time.to_key", {{"next", true}}},
      {{kDown}, kAnywhere, "time.to_key", {{"next", false}}},
      {{'R'}, kViewport, "tool.rotate"},
      {{'B'}, kViewport, "tool.box"},
      {{'G'}, kViewport, "tool.move"},
      {{'J'}, kViewport, "tool.jump"},
      {{'T'}, kViewport, "tool.throw"},
      {{'D', false, true}, kViewport, "view.duplicate_object"},
      {{'X'}, kViewport, "view.remove_object"},
      {{kDelete}, kViewport, "view.remove_object"},
      {{kPeriod}, kViewport, "view.frame_selected"},
      {{kPadPeriod}, kViewport, "view.frame_selected"},
      {{kHome}, kViewport, "view.frame_all"},
      {{kPad1}, kViewport, "view.side", {{"side", "front"}}},
      {{kPad1, true}, kViewport, "view.side", {{"side", "back"}}},
      {{kPad3}, kViewport, "view.side", {{"side", "right"}}},
      {{kPad3, true}, kViewport, "view.side", {{"side", "left"}}},
      {{kPad7}, kViewport, "view.side", {{"side", "top"}}},
      {{kPad5}, kViewport, "view.orthographic"},
      {{kPad0}, kViewport, "view.camera"},
      {{kTab, true}, kAnywhere, "view.sheet"},
      {{'G'}, kSheet, "sheet.move"},
      {{'S'}, kSheet, "sheet.scale"},
      {{'D', false, true}, kSheet, "sheet.duplicate"},
      {{'D'}, kSheet, "sheet.mark_region"},
      {{'B'}, kSheet, "sheet.box"},
      {{'A'}, kSheet, "sheet.select_all"},
      {{'A', false, false, true},
       kSheet,
       "keys.select",
       {{"curves", Json::array()}, {"frames", Json::array()}}},
      {{'K'}, kSheet, "keys.select_column"},
      {{kLeftBracket}, kSheet, "keys.select_side", {{"side", "before"}}},
      {{kRightBracket}, kSheet, "keys.select_side", {{"side", "after"}}},
      {{'H'}, kSheet, "sheet.mute"},
      {{'X'}, kSheet, "sheet.delete"},
      {{kDelete}, kSheet, "sheet.delete"},
      {{'C', true}, kSheet, "keys.copy"},
      {{'V', true}, kSheet, "keys.paste"},
      {{'T'}, kSheet, "sheet.open", {{"popup", "interpolation"}}},
      {{'V'}, kSheet, "sheet.open", {{"popup", "handles"}}},
      {{'R'}, kSheet, "sheet.open", {{"popup", "key_type"}}},
      {{'M'}, kSheet, "marker.add"},
      {{kF2}, kSheet, "sheet.rename"},
      {{'P'}, kSheet, "sheet.preview"},
      {{'P', false, false, true}, kSheet, "time.preview", {{"off", true}}},
      {{kHome}, kSheet, "sheet.frame_all"},
      {{kPeriod}, kSheet, "sheet.frame_selected"},
      {{kPadPeriod}, kSheet, "sheet.frame_selected"},
  };
  return shortcuts;
}

namespace {

struct Current {
  Keymap keymap;
  std::vector<Shortcut> shortcuts = DefaultShortcuts();
};
Current& Now() {
  static Current current;
  return current;
}

const KeyChange* ChangeOf(const Shortcut& by_default, const Keymap& keymap) {
  for (const KeyChange& change : keymap) {
    if (change.place == by_default.place && change.original == by_default.chord) return &change;
  }
  return nullptr;
}

Chord ChordOf(const Shortcut& by_default, const Keymap& keymap) {
  const KeyChange* change = ChangeOf(by_default, keymap);
  return change ? change->chord : by_default.chord;
}

void Put(const KeyChange& change, Keymap* keymap) {
  std::erase_if(*keymap, [&](const KeyChange& old) {
    return old.place == change.place && old.original == change.original;
  });
  if (change.chord != change.original) keymap->push_back(change);
}

}  // namespace

void SetKeymap(const Keymap& keymap) {
  Current& now = Now();
  if (now.keymap == keymap) return;
  now.keymap = keymap;
  const std::vector<Shortcut>& all = DefaultShortcuts();
  for (size_t i = 0; i < all.size(); ++i) now.shortcuts[i].chord = ChordOf(all[i], keymap);
}

Chord ChangeKey(const KeyChange& change, Keymap* keymap) {
  Chord loser;
  for (const Shortcut& other : DefaultShortcuts()) {
    const bool is_it = other.place == change.place && other.chord == change.original;
    if (is_it || other.place != change.place || change.chord.key == kNoKey) continue;
    if (ChordOf(other, *keymap) != change.chord) continue;
    loser = other.chord;
    Put({other.place, other.chord, Chord()}, keymap);
  }
  Put(change, keymap);
  return loser;
}

const std::vector<Shortcut>& AllShortcuts() { return Now().shortcuts; }

const Shortcut* FindShortcut(const Chord& chord, Place place) {
  const Shortcut* anywhere = nullptr;
  for (const Shortcut& shortcut : AllShortcuts()) {
    if (shortcut.chord != chord) continue;
    if (shortcut.place == place) return &shortcut;
    if (shortcut.place == Place::kAnywhere) anywhere = &shortcut;
  }
  return anywhere;
}

std::string KeyOf(const std::string& id, const Json& parameters) {
  for (const Shortcut& shortcut : AllShortcuts()) {
    if (shortcut.chord.key == kNoKey) continue;
    if (id == shortcut.id && parameters == shortcut.parameters) return NameOf(shortcut.chord);
  }
  return "";
}

}  // namespace hazumi::ui
