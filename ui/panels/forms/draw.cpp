// The form of an action or operator: a line for each of its parameters, in a way that fits what the
// parameter may be.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/base/text.h"
#include "ui/panels/forms/parts.h"
#include "ui/panels/forms/suggestions.h"
#include "ui/panels/forms/texts.h"

namespace hazumi::ui {

namespace {

using edit::ParameterKind;

constexpr double kLabelWidth = 120.0;
constexpr size_t kManyOptions = 12;  // from here on a list has a field to filter it
constexpr size_t kFewWords = 4;      // up to here all are shown at once

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

// The options that are left, below the headings of their limbs; the first one is what Enter takes.
void DrawOptions(const std::vector<FormOption>& options, bool takes_first, FormField* field) {
  std::string group;
  for (const FormOption& option : options) {
    if (option.group != group) ImGui::TextDisabled("%s", Tr(option.group.c_str()));
    group = option.group;
    const bool is_chosen = ImGui::Selectable(Tr(option.label.c_str()), option.value == field->text);
    if (!is_chosen && !takes_first) continue;
    field->text = option.value;
    ImGui::CloseCurrentPopup();
    return;
  }
}

void DrawOpenList(const std::vector<FormOption>& options, FormState* form, FormField* field) {
  if (ImGui::IsKeyPressed(kEscape, false)) ImGui::CloseCurrentPopup();
  bool takes_first = false;
  if (options.size() > kManyOptions) {
    if (ImGui::IsWindowAppearing()) {
      form->filter.clear();
      ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1.0f);
    takes_first = ImGui::InputTextWithHint("##filter", Tr("type to filter"), &form->filter,
                                           ImGuiInputTextFlags_EnterReturnsTrue);
  } else {
    form->filter.clear();
  }
  if (!field->info.is_required && form->filter.empty() &&
      ImGui::Selectable(Tr("(not given)"), field->text.empty())) {
    field->text.clear();
  }
  const std::vector<FormOption> left = Filtered(options, form->filter);
  if (left.empty()) ImGui::TextDisabled("%s", Tr("Nothing is called so."));
  DrawOptions(left, takes_first, field);
}

void DrawList(const std::vector<FormOption>& options, FormState* form, FormField* field) {
  const auto now = std::find_if(options.begin(), options.end(),
                                [&](const FormOption& o) { return o.value == field->text; });
  std::string shown = now == options.end() ? field->text : Tr(now->label.c_str());
  if (shown.empty()) shown = field->info.is_required ? Tr("choose") : Tr("(not given)");
  if (!ImGui::BeginCombo("##list", shown.c_str(), ImGuiComboFlags_HeightLarge)) return;
  DrawOpenList(options, form, field);
  ImGui::EndCombo();
}

void DrawColorField(FormField* field) {
  unsigned rgb = 0xb0b0b0;
  if (!field->text.empty()) std::sscanf(field->text.c_str(), "#%x", &rgb);
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
    DrawList(options, form, field);
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

void DrawRows(FormState* form, Editor* editor) {
  bool has_focus = editor->dialogs.just_opened, was_main = true;
  for (const FormRow& row : RowsOf(form)) {
    const bool is_main = row.fields.front()->is_main;
    if (was_main && !is_main) {
      ImGui::Spacing();
      ImGui::TextDisabled("%s", Tr("Optional"));
    }
    was_main = is_main;
    const bool is_typed = IsTyped(row.fields.front()->info);
    DrawRow(row, form, has_focus && is_typed, editor);
    has_focus &= !is_typed;
  }
}

}  // namespace

void DrawForm(Editor* editor) {
  FormState& form = editor->dialogs.form;
  FaintText(*editor, HelpOf(form.id));
  ImGui::Spacing();
  DrawRows(&form, editor);
  DrawError(form.error, editor->theme());
  ImGui::Spacing();
  const int clicked = DrawButtons(*editor, {{LabelOf(form.id), HelpOf(form.id)},
                                            {Tr("Cancel"), Tr("Leaves everything as it is.")}});
  if (clicked == 0) SubmitForm(editor);
  if (clicked == 1 || IsEscapePressed(*editor)) Close(editor);
}

}  // namespace hazumi::ui
