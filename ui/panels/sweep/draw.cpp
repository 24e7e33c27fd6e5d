// The sweep among the properties: its cells in a table, the picture of the one that is looked at.

#include <algorithm>

#include "engine/sweep/table_text.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/properties/fields.h"
#include "ui/panels/properties/sections.h"
#include "ui/panels/sweep/actions.h"

namespace hazumi::ui {

namespace {

constexpr int kMostColumns = 60;  // ImGui has 64 at most

// Those of fields and measures; the error is said in words.
int ColumnsOf(const SweptFolder& swept) {
  return std::min(static_cast<int>(swept.names.size()) - 1, kMostColumns);
}

// Its place is there whether it is or not, so that the table below stays where the mouse is.
void DrawPicture(Editor* editor) {
  const SweepState& state = editor->sweep;
  const unsigned picture = PictureOfCell(editor);
  if (state.aspect <= 0.0) return;
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 size = {width, width / static_cast<float>(state.aspect)};
  if (picture != 0) {
    const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture));
    return ImGui::Image(texture, size);
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const char* text =
      state.cell ? Tr("This cell has no picture.") : Tr("Click on a cell to see its picture.");
  ImGui::GetWindowDrawList()->AddText(nullptr, 0.0f, at, ToIm(editor->theme().faint_text), text,
                                      nullptr, width);
  ImGui::Dummy(size);
}

void DrawRow(Editor* editor, const SweptFolder& swept, size_t cell, bool is_kept,
             std::optional<size_t>* chosen) {
  ImGui::TableNextRow();
  if (is_kept) {
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, ToIm(colors::kInterpolated, 0.4f));
  }
  const std::vector<std::string>& row = swept.rows[cell];
  const bool failed = !swept.ErrorOf(cell).empty();
  for (int column = 0; column < ColumnsOf(swept); ++column) {
    ImGui::TableSetColumnIndex(column);
    const std::string& whole = row[static_cast<size_t>(column)];
    std::string text = ShortDecimal(whole, 4);
    if (is_kept && column == 0) text += std::string("  ") + Tr("kept");
    if (column > 0) {
      ImGui::TextUnformatted(text.c_str());
      if (text != whole) Tooltip(whole);
      continue;
    }
    if (failed) ImGui::PushStyleColor(ImGuiCol_Text, ToIm4(colors::kSinking));
    if (ImGui::Selectable(text.c_str(), editor->sweep.cell == cell,
                          ImGuiSelectableFlags_SpanAllColumns)) {
      *chosen = cell;
    }
    if (failed) ImGui::PopStyleColor();
    if (failed) Tooltip(swept.ErrorOf(cell));
  }
}

void DrawHead(const SweptFolder& swept) {
  ImGui::TableSetupScrollFreeze(1, 1);
  for (int column = 0; column < ColumnsOf(swept); ++column) {
    const std::string& name = swept.names[static_cast<size_t>(column)];
    ImGui::TableSetupColumn(column == 0 ? Tr("Cell") : ShortName(name).c_str());
  }
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int column = 0; column < ColumnsOf(swept); ++column) {
    ImGui::TableSetColumnIndex(column);
    ImGui::TableHeader(ImGui::TableGetColumnName(column));
    if (column > 0) Tooltip(swept.names[static_cast<size_t>(column)]);
  }
}

void DrawTable(Editor* editor, const SweptFolder& swept) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                     ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                     ImGuiTableFlags_SizingFixedFit;
  const float least = 8.0f * ImGui::GetTextLineHeightWithSpacing();
  const float height = std::max(least, ImGui::GetContentRegionAvail().y);
  if (!ImGui::BeginTable("##cells", ColumnsOf(swept), kFlags, {0.0f, height})) return;
  DrawHead(swept);
  const size_t kept = HasKeptCell(*editor) ? *editor->sweep.kept : swept.rows.size();
  std::optional<size_t> chosen;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(swept.rows.size()));
  while (clipper.Step()) {
    for (int cell = clipper.DisplayStart; cell < clipper.DisplayEnd; ++cell) {
      const bool is_kept = kept == static_cast<size_t>(cell);
      DrawRow(editor, swept, static_cast<size_t>(cell), is_kept, &chosen);
    }
  }
  ImGui::EndTable();
  if (chosen) editor->Do("sweep.preview", {{"cell", static_cast<int>(*chosen)}});
}

void DrawButtons(Editor* editor) {
  const auto button = [&](const char* id, const Json& parameters, const char* label) {
    if (DrawButton(label, HelpOf(id), 2)) editor->Do(id, parameters);
  };
  button("sweep.step", {{"by", -1}}, Tr("Cell before"));
  ImGui::SameLine();
  button("sweep.step", {{"by", 1}}, Tr("Cell after"));
  button("sweep.adopt", Json::object(), LabelOf("sweep.adopt"));
  ImGui::SameLine();
  button("sweep.leave", Json::object(), LabelOf("sweep.leave"));
}

}  // namespace

void DrawSweepSection(Editor* editor) {
  if (!DrawHeading(Tr("Sweep"))) return;
  // A copy: a button may close it.
  const std::shared_ptr<const SweptFolder> swept = editor->sweep.swept;
  if (!swept) {
    DrawNote(
        Tr("Variations of the open project, made with hazumi --sweep, are looked at and one is "
           "kept."));
    if (DrawButton(Tr("Open sweep..."), HelpOf("file.sweep_dialog")))
      editor->Do("file.sweep_dialog");
    return;
  }
  DrawNote(swept->folder);
  editor->NeedGlyphs(swept->folder);
  DrawButtons(editor);
  if (!editor->sweep.swept) return;
  DrawPicture(editor);
  DrawTable(editor, *swept);
}

}  // namespace hazumi::ui
