#include "ui/panels/window/status_line.h"

#include <cmath>
#include <cstdio>

#include "engine/base/text.h"
#include "engine/base/version.h"

namespace hazumi::ui {

std::string MemoryText(size_t bytes) {
  char text[32];
  const double kilobytes = std::ceil(static_cast<double>(bytes) / 1000.0);
  if (kilobytes < 1000.0) {
    std::snprintf(text, sizeof text, "%.0f kB", kilobytes);
  } else {
    std::snprintf(text, sizeof text, "%.1f MB", kilobytes / 1000.0);
  }
  return text;
}

std::string BakingText(const Editor& editor) {
  const edit::BackgroundBake* bake = editor.session().bake();
  if (bake && bake->is_stopped()) return Tr("The motion is not computed");
  if (!bake || !bake->is_busy()) return "";
  return std::string(Tr("Computing the motion: frame")) + " " + std::to_string(bake->done_until()) +
         " / " + std::to_string(editor.last_frame()) + "   Esc: " + Tr("stop");
}

std::string FittingHint(const std::string& hint, float room,
                        const std::function<float(const std::string&)>& width_of) {
  constexpr const char* kBetween = "   ";
  size_t end = hint.find(kBetween);
  while (end != std::string::npos) {
    const size_t next = hint.find(kBetween, hint.find_first_not_of(' ', end));
    if (width_of(hint.substr(0, next)) > room) return hint.substr(0, end);
    end = next;
  }
  return hint;
}

std::vector<std::string> StatusParts(const Editor& editor) {
  const edit::Session& session = editor.session();
  const edit::Document& document = session.document();
  const std::string name = document.path().empty() ? Tr("Untitled") : NameIn(document.path());
  const std::string saved = document.is_saved() ? Tr("saved") : Tr("not saved");
  return {name + " (" + saved + ")",
          std::string(Tr("Frame")) + " " + FormatShort(session.frame()) + " / " +
              std::to_string(session.project().frames.last),
          std::string(Tr("Undo")) + " " + MemoryText(document.history_bytes()),
          std::string("Hazumi ") + kVersion};
}

}  // namespace hazumi::ui
