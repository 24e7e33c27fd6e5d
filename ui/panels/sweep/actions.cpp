#include "ui/panels/sweep/actions.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/base/filled.h"
#include "engine/project/address/field_address.h"
#include "ui/panels/dialogs/folder_list.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

namespace {

using enum edit::ParameterKind;

constexpr const char* kDragName = "sweep";

Error Refused(const char* message) { return {ErrorCode::kSchema, "", "", message}; }

void CloseSweep(Editor* editor) {
  DropPicture(editor);
  editor->sweep = {};
}

Result<Done> OpenSweep(Editor* editor, const edit::Parameters& p) {
  Result<SweptFolder> swept = ReadSweptFolder(p.text("path"));
  if (!swept.ok()) return swept.error();
  CloseSweep(editor);
  editor->sweep.swept = std::make_shared<const SweptFolder>(std::move(swept).value());
  editor->sweep.document = editor->session().document_number();
  editor->sweep.aspect = AspectOfPictures(*editor->sweep.swept);
  editor->side.section = Section::kSweep;
  return Done();
}

Result<Done> ShowCell(size_t cell, Editor* editor) {
  const SweepPlan& plan = editor->sweep.swept->plan;
  const std::vector<std::string> values = ValuesOf(plan, static_cast<long>(cell));
  Json fields = Json::array(), texts = Json::array();
  for (size_t i = 0; i < plan.vary.size(); ++i) {
    for (const std::string* field : FieldsOf(plan.vary[i])) {
      fields.push_back(*field);
      texts.push_back(values[i]);
    }
  }
  Result<Done> set =
      editor->Invoke("field.set", {{"fields", fields}, {"values", texts}, {"drag", kDragName}});
  if (!set.ok()) return set;
  editor->sweep.cell = cell;
  return Done();
}

Result<Done> Preview(Editor* editor, const edit::Parameters& p) {
  if (!editor->sweep.swept) return Refused("no sweep is open");
  const int cell = p.integer("cell");
  const size_t cells = editor->sweep.swept->rows.size();
  if (cell < 0 || static_cast<size_t>(cell) >= cells) return Refused("there is no such cell");
  return ShowCell(static_cast<size_t>(cell), editor);
}

// As many cells on; the first one if none is looked at yet.
Result<Done> Step(Editor* editor, const edit::Parameters& p) {
  if (!editor->sweep.swept) return Refused("no sweep is open");
  const auto last = static_cast<int>(editor->sweep.swept->rows.size()) - 1;
  const int by = p.integer("by", 1);
  const int cell =
      editor->sweep.cell ? std::clamp(static_cast<int>(*editor->sweep.cell) + by, 0, last) : 0;
  return ShowCell(static_cast<size_t>(cell), editor);
}

// "friction.default = 0.7, release_frame = 12", as many as a line of the status bar has room for.
std::string ValuesInWords(const SweepPlan& plan, size_t cell) {
  constexpr size_t kMost = 150;
  const std::vector<std::string> values = ValuesOf(plan, static_cast<long>(cell));
  std::string text;
  for (size_t i = 0; i < plan.vary.size(); ++i) {
    const std::string part = ShortName(plan.vary[i].field) + " = " + values[i];
    if (text.size() + part.size() > kMost) return text + (i == 0 ? "..." : ", ...");
    text += (i == 0 ? "" : ", ") + part;
  }
  return text;
}

Result<Done> Adopt(Editor* editor, const edit::Parameters&) {
  SweepState& state = editor->sweep;
  if (!state.cell) return Refused("choose a cell first");
  Result<Done> kept = editor->Invoke("edit.end_drag");
  if (!kept.ok()) return kept;
  state.kept = std::exchange(state.cell, std::nullopt);
  editor->Say(Filled(Tr("Cell %d is kept: %s. Undo takes it back."), static_cast<int>(*state.kept),
                     ValuesInWords(state.swept->plan, *state.kept).c_str()));
  return Done();
}

Result<Done> Leave(Editor* editor, const edit::Parameters&) {
  const bool is_untouched = editor->session().document().drag_start(kDragName) != nullptr;
  if (editor->sweep.cell && is_untouched) {
    Result<Done> back = editor->Invoke("edit.cancel_drag");
    if (!back.ok()) return back;
  }
  if (editor->sweep.cell && !is_untouched) {
    editor->Say(Tr("The project was changed since a cell was looked at: undo goes back."));
  }
  CloseSweep(editor);
  return Done();
}

}  // namespace

std::string ShortName(const std::string& name) {
  const size_t item = name.find("].");
  return item == name.npos ? name : name.substr(item + 2);
}

void CloseSweepOfOther(Editor* editor) {
  const SweepState& state = editor->sweep;
  if (!state.swept || state.document == editor->session().document_number()) return;
  const std::string folder = NameIn(state.swept->folder);
  CloseSweep(editor);
  editor->Say(Filled(Tr("The sweep %s is closed: it belongs to another project."), folder.c_str()));
}

bool HasKeptCell(const Editor& editor) {
  const SweepState& state = editor.sweep;
  if (!state.kept) return false;
  const SweepPlan& plan = state.swept->plan;
  const std::vector<std::string> values = ValuesOf(plan, static_cast<long>(*state.kept));
  // Looking at another one takes nothing back.
  const edit::Session& session = editor.session();
  const edit::Document::State* before = session.document().drag_start(kDragName);
  const Project& project = before ? before->project : session.project();
  for (size_t i = 0; i < plan.vary.size(); ++i) {
    const auto address = ParseAddress(plan.vary[i].field);
    if (!address.ok()) return false;
    const auto now = GetField(address.value(), project);
    if (!now.ok() || now.value() != values[i]) return false;
  }
  return true;
}

std::vector<Action> SweepActions() {
  return {
      {"sweep.open",
       "Open sweep",
       "Shows the cells of a sweep that was made with hazumi --sweep.",
       {{"path", kText, true, "its folder, or a file in it"}},
       OpenSweep},
      {"sweep.preview",
       "Look at cell",
       "Gives the project the values of a cell for the time being.",
       {{"cell", kInteger, true, "its number"}},
       Preview},
      {"sweep.step",
       "Look at next cell",
       "Goes to another cell of the sweep.",
       {{"by", kInteger, false, "so many cells on; not given: one"}},
       Step},
      {"sweep.adopt",
       "Keep this cell",
       "The project keeps the values of the cell that is looked at; one step back undoes it.",
       {},
       Adopt},
      {"sweep.leave",
       "Close sweep",
       "The project is as it was before a cell was looked at.",
       {},
       Leave},
  };
}

}  // namespace hazumi::ui
