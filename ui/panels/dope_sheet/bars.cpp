#include "ui/panels/dope_sheet/bars.h"

namespace hazumi::ui {

namespace {

Error NothingChosen() { return {ErrorCode::kSchema, "", "", "no bar is chosen; click one"}; }

}  // namespace

ProjectFrames FramesOf(const Project& project, const BarRef& bar) {
  return TypeOf(bar.kind).Frames(project, bar.index);
}

std::string TitleOf(const Project& project, const BarRef& bar) {
  return TypeOf(bar.kind).Title(project, bar.index);
}

std::string DetailsOf(const Project& project, const BarRef& bar) {
  return TypeOf(bar.kind).Details(project, bar.index);
}

std::optional<BarRef> FindBar(const Project& project, const BarId& bar) {
  for (const BarType* type : AllBarTypes()) {
    if (type->kind != bar.kind) continue;
    for (int i = 0; i < type->Num(project); ++i) {
      if (type->Id(project, i) == bar.id) return BarRef{type->kind, i};
    }
  }
  return std::nullopt;
}

std::optional<BarRef> ChosenBar(const Project& project, const SheetState& sheet) {
  if (!sheet.bar || !sheet.bar->id.is_valid()) return std::nullopt;
  return FindBar(project, *sheet.bar);
}

BarId IdOf(const Project& project, const BarRef& bar) {
  return {bar.kind, TypeOf(bar.kind).Id(project, bar.index)};
}

void ChooseBar(Editor* editor, const BarRef& bar) {
  editor->sheet.bar = IdOf(editor->session().project(), bar);
  if (bar.kind == BarKind::kRegion) editor->side.region = editor->sheet.bar->id;
}

void ChooseNoBar(SheetState* sheet) { sheet->bar.reset(); }

Result<Done> EditChosenBar(Editor* editor, Json change) {
  const std::optional<BarRef> bar = ChosenBar(editor->session().project(), editor->sheet);
  if (!bar) return NothingChosen();
  return TypeOf(bar->kind).Edit(editor, bar->index, std::move(change));
}

Result<Done> RemoveChosenBar(Editor* editor) {
  const std::optional<BarRef> bar = ChosenBar(editor->session().project(), editor->sheet);
  if (!bar) return NothingChosen();
  ChooseNoBar(&editor->sheet);
  return TypeOf(bar->kind).Remove(editor, bar->index);
}

}  // namespace hazumi::ui
