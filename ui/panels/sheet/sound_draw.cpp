// The row of the sound.

#include <filesystem>

#include "ui/panels/sheet/drawing.h"
#include "ui/panels/sheet/wave.h"

namespace hazumi::ui {

namespace {

// The file's name, or what is to be said in its place.
std::string NameOrTrouble(const SoundWatch& sound, const ProjectAudio& audio) {
  if (!sound.error().empty()) return Tr("Unreadable sound");
  if (sound.is_busy()) return Tr("Reading the sound");
  return std::filesystem::path(audio.file).filename().string();
}

}  // namespace

void DrawSoundRow(ImDrawList* list, Editor* editor, const SheetFrame& frame) {
  const edit::Session& session = editor->session();
  const std::optional<ProjectAudio>& audio = session.project().audio;
  if (!audio) return;
  const Theme& theme = editor->theme();
  const Rect& row = frame.sound;
  const auto s = static_cast<float>(frame.scale);
  list->AddRectFilled({frame.rect.x, row.y}, LowerRight(row), ToIm(theme.header));
  list->AddRectFilled(UpperLeft(row), LowerRight(row), ToIm(theme.window));
  list->PushClipRect(UpperLeft(row), LowerRight(row), true);
  if (const Peaks* peaks = editor->sound.peaks()) {
    const FrameRate rate{session.project().fps.num, session.project().fps.den};
    const ImU32 color = ToIm(audio->mute ? theme.faint_text : theme.accent, 0.8f);
    for (const WaveColumn& column : WaveColumns(*peaks, *audio, rate, frame)) {
      list->AddRectFilled({column.x, column.top}, {column.x + 1.0f, column.bottom}, color);
    }
  }
  list->PopClipRect();
  const float names = row.x - frame.rect.x;
  const Rect label = {frame.rect.x + 8.0f * s, row.y, names - 12.0f * s, row.h};
  const std::string error = editor->sound.error();
  editor->NeedGlyphs(audio->file);
  DrawLabel(list, label, NameOrTrouble(editor->sound, *audio),
            ToIm(error.empty() ? theme.faint_text : theme.warning));
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (label.Contains({mouse.x, mouse.y})) {
    ImGui::SetTooltip("%s", error.empty() ? audio->file.c_str() : error.c_str());
  }
}

}  // namespace hazumi::ui
