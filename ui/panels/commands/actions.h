#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/edit/parameters.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Something that changes what is seen, not the document: by menu, key, search or script.
struct Action {
  const char* id;  // "view.side"
  const char* label;
  const char* help;
  std::vector<edit::ParameterInfo> parameters;
  std::function<Result<Done>(Editor*, const edit::Parameters&)> run;
  bool asks = false;  // opens a dialog before it does anything: "..." behind its label
};

// Of one file, which are among all.
std::vector<Action> KeymapActions();
std::vector<Action> GraphActions();
const std::vector<Action>& AllActions();
const Action* FindAction(const std::string& id);

// What a key does: an action or an operator with these parameters.
struct Shortcut {
  Chord chord;
  Place place;
  const char* id;
  Json parameters = Json::object();
};
// As they are without a keymap, and with it; in the same order. One without a key has chord none.
const std::vector<Shortcut>& DefaultShortcuts();
const std::vector<Shortcut>& AllShortcuts();
const Shortcut* FindShortcut(const Chord& chord, Place place);
// The key of an action or operator as menus and tooltips show it; empty if it has none.
std::string KeyOf(const std::string& id, const Json& parameters = Json::object());

// What was wrong with an action or operator, as an animator reads it: "throw.kfa, line 2: ...",
// "Set gravity (gravity): ...".
std::string TextOf(const Error& error, const std::string& id);

// The label and the help of an action or operator, in the interface's language.
const char* LabelOf(const std::string& id);
const char* HelpOf(const std::string& id);

}  // namespace hazumi::ui
