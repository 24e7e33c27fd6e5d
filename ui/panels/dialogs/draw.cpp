#include <imgui_internal.h>

#include "ui/panels/dialogs/parts.h"
#include "ui/panels/window/panels.h"

namespace hazumi::ui {

namespace {

constexpr const char* kId = "###dialog";  // of all of them: one is open at a time

struct Frame {
  const char* title;
  double width, height;  // at scale 1 [px]; height 0: as high as it needs to be
};

Frame FrameOf(const DialogsState& dialogs) {
  switch (dialogs.modal) {
    case Modal::kFiles:
      return {dialogs.files.purpose->title, 680, 430};
    case Modal::kUnsaved:
      return {"Unsaved changes", 400, 0};
    case Modal::kChangedElsewhere:
      return {"Changed elsewhere", 520, 0};
    case Modal::kSearch:
      return {"Search", 480, 0};
    case Modal::kForm:
      return {"Parameters", 580, 0};
    case Modal::kImport:
      return {"Import character", 560, 0};
    case Modal::kExport:
      return {"Export", 620, 560};
    case Modal::kRender:
      return {"Render", 520, 0};
    case Modal::kProgress:
      return {"Rendering", 420, 0};
    case Modal::kManual:
      return {"Manual", 720, 560};
    case Modal::kAbout:
      return {"About Hazumi", 430, 0};
    case Modal::kPreferences:
      return {"Preferences", 600, 520};
    case Modal::kOutsideFile:
      return {"File outside of the project's folder", 520, 0};
    case Modal::kNone:
      break;
  }
  return {"", 100, 0};
}

void DrawUnsaved(Editor* editor) {
  const std::string& path = editor->session().document().path();
  const std::string name = path.empty() ? Tr("Untitled") : NameIn(path);
  ImGui::TextWrapped(Tr("\"%s\" has changes that are not saved."), name.c_str());
  ImGui::Spacing();
  const int clicked =
      DrawButtons(*editor, {{Tr("Save"), ""}, {Tr("Don't save (D)"), ""}, {Tr("Cancel"), ""}});
  if (clicked == 0) AnswerSave(editor);
  if (clicked == 1 || ImGui::IsKeyPressed('D', false)) AnswerDiscard(editor);
  if (clicked == 2 || IsEscapePressed(*editor)) AnswerCancel(editor);
}

void DrawChangedElsewhere(Editor* editor) {
  const std::string name = NameIn(editor->session().document().path());
  ImGui::TextWrapped(Tr("Another program has changed \"%s\" since it was read."), name.c_str());
  ImGui::Spacing();
  const int clicked = DrawButtons(
      *editor, {{Tr("Save as"), Tr("Saves yours under another name. Both are kept.")},
                {Tr("Keep mine (K)"), Tr("Saves yours; what the file holds is lost.")},
                {Tr("Take theirs (T)"), Tr("Opens the file again; what is not saved is lost.")},
                {Tr("Cancel"), ""}});
  if (clicked == 0) AnswerSaveAs(editor);
  if (clicked == 1 || ImGui::IsKeyPressed('K', false)) AnswerKeepMine(editor);
  if (clicked == 2 || ImGui::IsKeyPressed('T', false)) AnswerTakeTheirs(editor);
  if (clicked == 3 || IsEscapePressed(*editor)) AnswerCancel(editor);
}

void DrawContent(Editor* editor) {
  switch (editor->dialogs.modal) {
    case Modal::kFiles:
      return DrawFileDialog(editor);
    case Modal::kUnsaved:
      return DrawUnsaved(editor);
    case Modal::kChangedElsewhere:
      return DrawChangedElsewhere(editor);
    case Modal::kSearch:
      return DrawSearch(editor);
    case Modal::kForm:
      return DrawForm(editor);
    case Modal::kImport:
      return DrawImport(editor);
    case Modal::kExport:
      return DrawExport(editor);
    case Modal::kRender:
      return DrawRenderDialog(editor);
    case Modal::kProgress:
      return DrawProgress(editor);
    case Modal::kManual:
      return DrawManual(editor);
    case Modal::kAbout:
      return DrawAbout(editor);
    case Modal::kPreferences:
      return DrawPreferences(editor);
    case Modal::kOutsideFile:
      return DrawOutsideFile(editor);
    case Modal::kNone:
      break;
  }
}

// The title of a form is what it will do.
std::string TitleOf(const DialogsState& dialogs) {
  if (dialogs.modal == Modal::kForm) return LabelOf(dialogs.form.id);
  return Tr(FrameOf(dialogs).title);
}

}  // namespace

void DrawFieldLabel(const char* text, const Editor& editor) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(Px(editor, 130));
}

namespace {

bool IsEnterDown() {
  return ImGui::IsKeyPressed(kEnter, false) || ImGui::IsKeyPressed(kPadEnter, false);
}

// Tab shows where the keyboard is, and leads on.
void FollowTab(bool just_opened) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  const bool tabs = ImGui::IsKeyPressed(kTab);
  if (just_opened || tabs) context.NavDisableHighlight = false;
  // From what takes no text ImGui would begin at the first field again.
  if (tabs && context.NavTabbingDir == 0 && context.NavId != 0) context.NavTabbingDir = 1;
}

// Panels have keys of their own.
void LetArrowsLead(bool lead) {
  ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
  flags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  if (lead) flags |= ImGuiConfigFlags_NavEnableKeyboard;
}

}  // namespace

TabStops::TabStops(bool are_stops) {
  // To ImGui these are fields to type into; buttons and ticks take no text and are left as they
  // are.
  ImGui::PushItemFlag(ImGuiItemFlags_Inputable, are_stops);
  ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, !are_stops);
}
TabStops::~TabStops() {
  ImGui::PopItemFlag();
  ImGui::PopItemFlag();
}

bool HasKeyboard() {
  return ImGui::IsItemFocused() && !ImGui::GetCurrentContext()->NavDisableHighlight;
}

bool ListLine(const std::string& label, bool is_selected) {
  const bool is_clicked = ImGui::Selectable(label.c_str(), is_selected);
  if (!HasKeyboard() || !IsEnterDown()) return is_clicked;
  const bool is_popup = (ImGui::GetCurrentWindow()->Flags & ImGuiWindowFlags_Popup) != 0;
  if (is_popup) ImGui::CloseCurrentPopup();
  return true;
}

bool IsEnterPressed(const Editor& editor) {
  return !editor.dialogs.has_list && !editor.dialogs.takes_enter && IsEnterDown();
}
bool IsEscapePressed(const Editor& editor) {
  return !editor.dialogs.has_list && ImGui::IsKeyPressed(kEscape, false);
}

namespace {

constexpr float kErrorLines = 4.0f;  // seen at once

float HeightOfText(const std::string& error) {
  return ImGui::CalcTextSize(("! " + error).c_str(), nullptr, false,
                             ImGui::GetContentRegionAvail().x)
      .y;
}

}  // namespace

float HeightOfError(const std::string& error) {
  if (error.empty()) return 0.0f;
  const float most = kErrorLines * ImGui::GetTextLineHeight();
  return std::min(HeightOfText(error), most) + ImGui::GetStyle().ItemSpacing.y;
}

void DrawError(const std::string& error, const Theme& theme) {
  if (error.empty()) return;
  const float high = HeightOfError(error) - ImGui::GetStyle().ItemSpacing.y;
  const bool scrolls = HeightOfText(error) > high;
  if (scrolls) ImGui::BeginChild(ImGui::GetID(error.c_str()), {0.0f, high});
  ImGui::PushStyleColor(ImGuiCol_Text, ToIm4(theme.warning));
  ImGui::TextWrapped("! %s", error.c_str());
  ImGui::PopStyleColor();
  if (scrolls) ImGui::EndChild();
}

int DrawButtons(const Editor& editor, std::initializer_list<ButtonText> buttons) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float total = -style.ItemSpacing.x;
  const auto width = [&](const ButtonText& button) {
    return std::max(Px(editor, 90), ImGui::CalcTextSize(button.label).x + Px(editor, 24));
  };
  for (const ButtonText& button : buttons) total += width(button) + style.ItemSpacing.x;
  ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - total);
  int clicked = -1, i = 0;
  for (const ButtonText& button : buttons) {
    if (i > 0) ImGui::SameLine();
    const bool is_first = i == 0;
    if (is_first) ImGui::PushStyleColor(ImGuiCol_Button, ToIm4(editor.theme().accent));
    if (ImGui::Button(button.label, {width(button), 0.0f})) clicked = i;
    if (is_first) ImGui::PopStyleColor();
    if (HasKeyboard() && IsEnterPressed(editor)) clicked = i;
    Tooltip(button.help);
    ++i;
  }
  // Not the key that opened the dialog.
  if (clicked < 0 && IsEnterPressed(editor) && !editor.dialogs.just_opened) clicked = 0;
  return clicked;
}

void DrawDialogs(Editor* editor, const Rect& window) {
  DialogsState& dialogs = editor->dialogs;
  if (dialogs.shows_first_steps && !editor->aims()) DrawFirstSteps(editor, window);
  AskAboutOutsideFile(editor);
  if (dialogs.modal != Modal::kNone && !ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
  if (!ImGui::IsPopupOpen(kId)) return LetArrowsLead(false);
  const Frame frame = FrameOf(dialogs);
  const float width = std::min(Px(*editor, frame.width), 0.96f * window.w);
  const float height = std::min(Px(*editor, frame.height), 0.92f * window.h);
  const bool is_search = dialogs.modal == Modal::kSearch;
  const Rect card = dialogs.shows_first_steps ? dialogs.first_steps_card : Rect();
  ImGui::SetNextWindowPos(
      {MiddleOfDialog(width, window, card), (is_search ? 0.15f : 0.5f) * window.h},
      ImGuiCond_Always, {0.5f, is_search ? 0.0f : 0.5f});
  ImGui::SetNextWindowSize({width, height});
  constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNavFocus |
                                      ImGuiWindowFlags_NoSavedSettings;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {Px(*editor, 12), Px(*editor, 10)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  const bool is_drawn = ImGui::BeginPopupModal((TitleOf(dialogs) + kId).c_str(), nullptr, kFlags);
  ImGui::PopStyleVar(2);
  if (!is_drawn) return;
  const Modal drawn = dialogs.modal;
  const bool was_just_opened = dialogs.just_opened;
  FollowTab(was_just_opened);
  dialogs.takes_enter = dialogs.takes_arrows = false;
  {
    const TabStops stops(true);
    DrawContent(editor);
  }
  // Unless what was drawn has opened another.
  if (was_just_opened && dialogs.modal == drawn) dialogs.just_opened = false;
  LetArrowsLead(!dialogs.takes_arrows || ImGui::IsKeyPressed(kTab));
  dialogs.has_list = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
  if (dialogs.modal == Modal::kNone) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace hazumi::ui
