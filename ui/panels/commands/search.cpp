#include "ui/panels/commands/search.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "engine/base/text.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/commands/menus.h"

namespace hazumi::ui {

namespace {

// What the editor has a better way for, or means nothing by itself.
bool IsHidden(const std::string& id) {
  for (const char* hidden :
       {"file.new", "file.open", "file.import", "file.export", "file.save", "edit.end_drag",
        "edit.cancel_drag", "app.open", "app.search", "app.form", "keys.move", "keys.scale",
        "keys.duplicate", "keys.select_all"}) {
    if (id == hidden) return true;
  }
  return false;
}

std::vector<std::string> Words(const std::string& query) {
  std::istringstream stream(LowerCase(query));
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// At the beginning of the text 3, of a word 2, elsewhere 1, nowhere 0.
int PlaceIn(const std::string& text, const std::string& word) {
  const size_t at = text.find(word);
  if (at == std::string::npos) return 0;
  if (at == 0) return 3;
  const bool begins_word = text.find(" " + word) != std::string::npos;
  return begins_word ? 2 : 1;
}

// 0: some word is not there.
int Rank(const Command& command, const std::vector<std::string>& words) {
  const std::string label = LowerCase(command.label), english = LowerCase(command.english);
  int rank = 1;
  for (const std::string& word : words) {
    const int place = std::max(2 * std::max(PlaceIn(label, word), PlaceIn(english, word)),
                               command.id.find(word) != std::string::npos ? 1 : 0);
    if (place == 0) return 0;
    rank += place;
  }
  return rank;
}

bool Has(const std::vector<Command>& commands, const std::string& id, const Json& parameters) {
  return std::any_of(commands.begin(), commands.end(), [&](const Command& command) {
    return command.id == id && command.parameters == parameters;
  });
}

std::string EnglishOf(const MenuEntry& entry) {
  const std::string id = entry.id;
  if (entry.label) return entry.label;
  if (const Action* action = FindAction(id)) return action->label;
  return edit::FindOperator(id)->label;
}

void Add(const MenuEntry& entry, std::vector<Command>* commands) {
  if (IsHidden(entry.id) || Has(*commands, entry.id, entry.parameters)) return;
  std::string label = LabelOf(entry), english = EnglishOf(entry);
  // A label of a menu in a menu says too little by itself.
  const std::string own = LabelOf(std::string(entry.id));
  const bool is_part = entry.label && !entry.parameters.empty();
  if (is_part && label.find(own) == std::string::npos) label = own + ": " + label;
  commands->push_back({entry.id, entry.parameters, label, english});
}

}  // namespace

std::vector<Command> AllCommands() {
  std::vector<Command> commands;
  for (const MenuEntry& entry : FlatMenus()) Add(entry, &commands);
  for (const Action& action : AllActions()) Add({action.id}, &commands);
  for (const edit::Operator& op : edit::AllOperators()) Add({op.id}, &commands);
  return commands;
}

std::vector<Command> Search(const std::vector<Command>& commands, const std::string& query) {
  const std::vector<std::string> words = Words(query);
  std::vector<std::pair<int, const Command*>> ranked;
  for (const Command& command : commands) {
    if (const int rank = Rank(command, words)) ranked.emplace_back(rank, &command);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Command> found;
  found.reserve(ranked.size());
  for (const auto& [rank, command] : ranked) found.push_back(*command);
  return found;
}

}  // namespace hazumi::ui
