#include "ui/panels/timeline/sound_watch.h"

#include <utility>

#include "engine/project/project_files.h"

namespace hazumi::ui {

void SoundWatch::Look(const edit::Session& session) {
  using Watch = FileWatch<Heard>;
  const std::string& project = session.document().path();
  const std::string file = SoundPath(session.project(), project);
  const std::optional<Error> closed = session.media().WhyClosed(file, project);
  const auto read = [closed](const std::string& path,
                             const Watch::IsCancelled& is_cancelled) -> Result<Heard> {
    if (closed) return *closed;
    Result<Sound> sound = DecodeSound(path, {}, is_cancelled);
    if (!sound.ok()) return sound.error();
    Peaks peaks(sound.value());
    return Heard{std::move(sound).value(), std::move(peaks)};
  };
  file_.Look(file, closed ? "closed" : "", read);
}

}  // namespace hazumi::ui
