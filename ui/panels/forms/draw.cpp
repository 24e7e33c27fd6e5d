// The form of an action or operator: a line for each of its parameters, in a way that fits what the
// parameter may be.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "engine/base/text.h"
#include "ui/panels/forms/offers.h"
#include "ui/panels/forms/parts.h"
#include "ui/panels/forms/texts.h"

namespace hazumi::ui {

namespace {

using edit::ParameterKind;

constexpr double kLabelWidth = 120.0;
constexpr float kMostHeight = 0.92f;  // of the window
constexpr size_t kManyOptions = 12;   // from here on a list has a field to filter it
constexpr size_t kFewWords = 4;       // up to here all are shown at once

void FaintText(const Editor& editor, const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ToIm4(editor.theme().faint_text));
  ImGui::TextWrapped("%s", text);
  ImGui::PopStyleColor();
}

// All words side by side, and below what the chosen one means.
void DrawWords(const FormState& form, const std::vector<FormOption>& options, FormField* field,
               const Editor& editor) {
  ImGui::BeginGroup();
  for (size_t i = 0; i < options.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const TabStops stops(i == 0);
    if (ImGui::RadioButton(Tr(options[i].label.c_str()), field->text == options[i].value)) {
      const bool takes_back = !field->info.is_required && field->text == options[i].value;
      field->text = takes_back ? "" : options[i].value;
    }
    const std::string meaning = MeaningOf(form.id, options[i].value);
    if (!meaning.empty()) Tooltip(Tr(meaning.c_str()));
  }
  const std::string meaning = MeaningOf(form.id, field->text);
  if (!meaning.empty()) FaintText(editor, Tr(meaning.c_str()));
  ImGui::EndGroup();
}

// What a list leaves to choose: a field that need not be given may be emptied again.
std::vector<FormOption> LeftOf(const std::vector<FormOption>& options, const FormState& form,
                               const FormField& field) {
  std::vector<FormOption> left = Filtered(options, form.filter);
  if (!field.info.is_required && form.filter.empty())
    left.insert(left.begin(), {"", "(not given)", ""});
  return left;
}

int PlaceOf(const std::string& value, const std::vector<FormOption>& options) {
  const auto found = std::find_if(options.begin(), options.end(),
                                  [&](const FormOption& o) { return o.value == value; });
  return found == options.end() ? 0 : static_cast<int>(found - options.begin());
}

// What is typed leaves fewer options, and Up and Down lead to the one that Enter takes: true.
bool DrawFilter(const std::vector<FormOption>& options, const FormField& field, Editor* editor) {
  FormState* form = &editor->dialogs.form;
  editor->dialogs.takes_arrows = true;
  const bool is_new = ImGui::IsWindowAppearing();
  if (is_new) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  const std::string before = form->filter;
  const bool is_entered = ImGui::InputTextWithHint("##filter", Tr("type to filter"), &form->filter,
                                                   ImGuiInputTextFlags_EnterReturnsTrue);
  const std::vector<FormOption> left = LeftOf(options, *form, field);
  if (is_new) form->at_option = PlaceOf(field.text, left);
  if (form->filter != before) form->at_option = 0;
  const int by = (ImGui::IsKeyPressed(kDown) ? 1 : 0) - (ImGui::IsKeyPressed(kUp) ? 1 : 0);
  const int last = std::max(0, static_cast<int>(left.size()) - 1);
  form->at_option = std::clamp(form->at_option + by, 0, last);
  return is_entered;
}

// The options that are left, below the headings of their limbs. Without a filter arrows lead
// through them.
void DrawOptions(const std::vector<FormOption>& left, std::optional<int> at, bool is_entered,
                 FormField* field) {
  std::string group;
  for (int i = 0; i < static_cast<int>(left.size()); ++i) {
    if (left[i].group != group) ImGui::TextDisabled("%s", Tr(left[i].group.c_str()));
    group = left[i].group;
    const bool is_now = left[i].value == field->text, is_at = i == at;
    const bool is_chosen = ListLine(Tr(left[i].label.c_str()), at ? is_at : is_now);
    if (is_now && !at) ImGui::SetItemDefaultFocus();
    if (is_at && (ImGui::IsWindowAppearing() || !ImGui::IsItemVisible())) ImGui::SetScrollHereY();
    if (!is_chosen && !(is_at && is_entered)) continue;
    field->text = left[i].value;
    ImGui::CloseCurrentPopup();
    return;
  }
}

void DrawOpenList(const std::vector<FormOption>& options, FormField* field, Editor* editor) {
  FormState* form = &editor->dialogs.form;
  if (ImGui::IsKeyPressed(kEscape, false)) ImGui::CloseCurrentPopup();
  if (ImGui::IsWindowAppearing()) form->filter.clear();
  const bool has_filter = options.size() > kManyOptions;
  const bool is_entered = has_filter && DrawFilter(options, *field, editor);
  const std::vector<FormOption> left = LeftOf(options, *form, *field);
  if (left.empty()) ImGui::TextDisabled("%s", Tr("Nothing is called so."));
  DrawOptions(left, has_filter ? std::optional(form->at_option) : std::nullopt, is_entered, field);
}

void DrawList(const std::vector<FormOption>& options, FormField* field, Editor* editor) {
  const auto now = std::find_if(options.begin(), options.end(),
                                [&](const FormOption& o) { return o.value == field->text; });
  std::string shown = now == options.end() ? field->text : Tr(now->label.c_str());
  if (shown.empty()) shown = field->info.is_required ? Tr("choose") : Tr("(not given)");
  if (!ImGui::BeginCombo("##list", shown.c_str(), ImGuiComboFlags_HeightLarge)) return;
  DrawOpenList(options, field, editor);
  ImGui::EndCombo();
}

void DrawColorField(FormField* field) {
  unsigned rgb = 0;
  std::sscanf(field->text.empty() ? kDefaultObjectColor : field->text.c_str(), "#%x", &rgb);
  float parts[3];
  for (int i = 0; i < 3; ++i) parts[i] = static_cast<float>((rgb >> (16 - 8 * i)) & 0xff) / 255.0f;
  if (!ImGui::ColorEdit3("##color", parts, ImGuiColorEditFlags_DisplayHex)) return;
  char text[8];
  const auto byte = [&](int i) { return static_cast<unsigned>(255.0f * parts[i] + 0.5f) & 0xffu; };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(0), byte(1), byte(2));
  field->text = text;
}

// What an empty field means: what stays as it is, or the parameter's help if it is alone.
std::string HintOf(const FormState& form, const FormField& field, const edit::Session& session,
                   bool is_alone) {
  const std::string present = PresentValue(form, field.info.name, session);
  return !present.empty() ? present : is_alone ? Tr(field.info.help) : "";
}

// The hint is inside the field if it fits there, else below, as is what a number means.
void DrawTyped(const FormState& form, FormField* field, Editor* editor, bool is_alone) {
  const std::string meaning = MeaningOf(form.id, field->info.name);
  const std::string hint = HintOf(form, *field, editor->session(), is_alone);
  const float room = ImGui::CalcItemWidth() - 2.0f * ImGui::GetStyle().FramePadding.x;
  const bool fits = ImGui::CalcTextSize(hint.c_str()).x <= room;
  const bool is_number =
      field->info.kind == ParameterKind::kNumber || field->info.kind == ParameterKind::kInteger;
  const ImGuiInputTextFlags flags = is_number ? ImGuiInputTextFlags_CharsScientific : 0;
  ImGui::BeginGroup();
  if (ImGui::InputTextWithHint("##text", fits ? hint.c_str() : "", &field->text, flags)) {
    editor->NeedGlyphs(field->text);
  }
  if (!meaning.empty()) {
    FaintText(*editor, Tr(meaning.c_str()));
  } else if (!fits) {
    FaintText(*editor, hint.c_str());
  }
  ImGui::EndGroup();
}

// Typed, or pulled beside it.
void DrawShare(const FormState& form, FormField* field, Editor* editor) {
  constexpr double kTypedWidth = 70.0;
  ImGui::BeginGroup();
  ImGui::SetNextItemWidth(Px(*editor, kTypedWidth));
  ImGui::InputText("##text", &field->text, ImGuiInputTextFlags_CharsScientific);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1.0f);
  auto share = static_cast<float>(std::atof(field->text.c_str()));
  const char* format = field->text.empty() ? Tr("(not given)") : "";
  if (ImGui::SliderFloat("##share", &share, 0.0f, 1.0f, format)) {
    field->text = FormatShort(std::round(100.0 * share) / 100.0);
  }
  const std::string meaning = MeaningOf(form.id, field->info.name);
  FaintText(*editor, Tr(meaning.empty() ? field->info.help : meaning.c_str()));
  ImGui::EndGroup();
}

// "true: ..." goes without saying beside a tick.
const char* WithoutTrue(const char* help) {
  constexpr std::string_view kTrue = "true: ";
  return std::string_view(help).starts_with(kTrue) ? help + kTrue.size() : help;
}

// True if it has a field for the keyboard.
bool IsTyped(const edit::ParameterInfo& info) {
  return info.offer.words[0] == '\0' && info.offer.thing == Thing::kAny &&
         info.kind != ParameterKind::kYesNo;
}

void DrawField(FormState* form, FormField* field, bool is_alone, Editor* editor) {
  const std::vector<FormOption> options = OptionsOf(field->info, editor->session());
  const bool are_words = field->info.offer.words[0] != '\0';
  if (field->info.kind == ParameterKind::kYesNo) {
    ImGui::Checkbox("##yes", &field->yes);
    ImGui::SameLine();
    FaintText(*editor, WithoutTrue(Tr(field->info.help)));
  } else if (field->info.kind == ParameterKind::kNames && !options.empty()) {
    DrawTicks(options, field, editor);
  } else if (field->info.offer.thing == Thing::kColor) {
    DrawColorField(field);
  } else if (field->info.range == kShare) {
    DrawShare(*form, field, editor);
  } else if (are_words && options.size() <= kFewWords) {
    DrawWords(*form, options, field, *editor);
  } else if (!options.empty()) {
    DrawList(options, field, editor);
  } else if (!IsTyped(field->info)) {
    ImGui::TextDisabled("%s", Tr("There is none in the project."));
  } else {
    DrawTyped(*form, field, editor, is_alone);
  }
}

// How long the frames from first to last are.
void DrawLength(const FormRow& row, const Editor& editor) {
  const ProjectRate& fps = editor.session().project().fps;
  const double frames =
      std::atof(row.fields[1]->text.c_str()) - std::atof(row.fields[0]->text.c_str());
  if (frames <= 0.0) return;
  ImGui::SameLine();
  const std::string seconds = FormatShort(std::round(100.0 * frames * fps.den / fps.num) / 100.0);
  ImGui::TextDisabled(Tr("%s frames, %s s"), FormatShort(frames).c_str(), seconds.c_str());
}

// Fields side by side, as wide as numbers are.
void DrawRow(const FormRow& row, FormState* form, bool has_focus, Editor* editor) {
  static constexpr const char* kAxes[] = {"X", "Y", "Z"};
  const bool is_alone = row.fields.size() == 1, is_vector = row.fields.size() == 3;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(Tr(row.label.c_str()));
  for (size_t i = 0; i < row.fields.size(); ++i) {
    FormField* field = row.fields[i];
    ImGui::PushID(field->info.name);
    ImGui::SameLine(i == 0 ? Px(*editor, kLabelWidth) : 0.0f);
    if (i > 0 || is_vector) {
      ImGui::TextDisabled("%s", is_vector ? kAxes[i] : "-");
      ImGui::SameLine();
    }
    ImGui::SetNextItemWidth(is_alone ? -1.0f : Px(*editor, is_vector ? 80 : 70));
    if (has_focus && i == 0) ImGui::SetKeyboardFocusHere();
    DrawField(form, field, is_alone, editor);
    Tooltip(Tr(field->info.help));
    ImGui::PopID();
  }
  if (std::string(row.fields.front()->info.name) == "first" && row.fields.size() == 2) {
    DrawLength(row, *editor);
  }
}

// The keyboard begins at the first field.
void DrawRows(FormState* form, Editor* editor) {
  bool has_focus = editor->dialogs.just_opened, was_main = true;
  for (const FormRow& row : RowsOf(form)) {
    const bool is_main = row.fields.front()->is_main;
    if (was_main && !is_main) {
      ImGui::Spacing();
      ImGui::TextDisabled("%s", Tr("Optional"));
    }
    was_main = is_main;
    DrawRow(row, form, has_focus, editor);
    has_focus = false;
  }
}

// What the window has no room for is scrolled to: the buttons below stay in it.
void DrawScrolledRows(FormState* form, Editor* editor) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float below = HeightOfError(form->error) + ImGui::GetFrameHeight() +
                      3.0f * style.ItemSpacing.y + style.WindowPadding.y;
  const float most = kMostHeight * ImGui::GetIO().DisplaySize.y - ImGui::GetCursorPosY() - below;
  ImGui::BeginChild("##rows", {0.0f, std::clamp(form->height, 1.0f, std::max(1.0f, most))}, false,
                    ImGuiWindowFlags_NavFlattened);
  DrawRows(form, editor);
  form->height = ImGui::GetCursorPosY();
  ImGui::EndChild();
}

}  // namespace

void DrawForm(Editor* editor) {
  FormState& form = editor->dialogs.form;
  FaintText(*editor, HelpOf(form.id));
  ImGui::Spacing();
  DrawScrolledRows(&form, editor);
  DrawError(form.error, editor->theme());
  ImGui::Spacing();
  const int clicked =
      DrawButtons(*editor, {{LabelOf(form.id), HelpOf(form.id)}, {Tr("Cancel"), ""}});
  if (clicked == 0) SubmitForm(editor);
  if (clicked == 1 || IsEscapePressed(*editor)) Close(editor);
}

}  // namespace hazumi::ui
