// The question after a crash.

#include <ctime>

#include "ui/panels/dialogs/parts.h"
#include "ui/panels/window/panels.h"

namespace hazumi::ui {

namespace {

std::string LocalTime(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm local = {};
  localtime_r(&seconds, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &local);
  return text;
}

void Describe(const edit::AbandonedJournal& journal) {
  ImGui::TextWrapped("%s", Tr("Hazumi was not closed in order. This is not saved:"));
  ImGui::Spacing();
  ImGui::BulletText("%s", journal.path.empty() ? Tr("Untitled") : journal.path.c_str());
  ImGui::BulletText("%s: %s", Tr("Last change"), LocalTime(journal.written).c_str());
  ImGui::BulletText("%s: %d", Tr("Steps since the last snapshot"), journal.num_operators);
  if (journal.is_project_newer) {
    ImGui::TextWrapped("%s", Tr("The project's file is newer than this: it may hold more."));
  }
  if (journal.damage) ImGui::TextWrapped("! %s", journal.damage->ToString().c_str());
  ImGui::Spacing();
}

enum class Answer { kRecover, kThrowAway, kLater };

// Enter never throws anything away, Esc leaves it for the next time.
std::optional<Answer> Ask(const Editor& editor, bool can_recover) {
  const ButtonText recover = {Tr("Recover"), ""}, throw_away = {Tr("Throw away"), ""};
  const ButtonText later = {Tr("Ask again next time"), ""};
  if (IsEscapePressed(editor)) return Answer::kLater;
  const int clicked = can_recover ? DrawButtons(editor, {recover, throw_away, later})
                                  : DrawButtons(editor, {later, throw_away});
  if (clicked < 0) return std::nullopt;
  if (clicked == 1) return Answer::kThrowAway;
  return clicked == 0 && can_recover ? Answer::kRecover : Answer::kLater;
}

}  // namespace

void DrawRecovery(Editor* editor) {
  RecoveryState& recovery = editor->recovery;
  if (recovery.journals.empty()) return;
  const std::string title = std::string(Tr("Recover unsaved work")) + "##recovery";
  if (!ImGui::IsPopupOpen(title.c_str())) ImGui::OpenPopup(title.c_str());
  const ImVec2 center = ImGui::GetMainViewport()->GetCenter();
  ImGui::SetNextWindowPos(center, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({ImGui::GetFontSize() * 32.0f, 0.0f});
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr, ImGuiWindowFlags_NoResize)) return;
  const edit::AbandonedJournal journal = recovery.journals.front();
  Describe(journal);
  if (const std::optional<Answer> answer = Ask(*editor, !journal.damage)) {
    recovery.journals.erase(recovery.journals.begin());
    if (*answer != Answer::kLater) recovery.answer(journal, *answer == Answer::kRecover);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace hazumi::ui
