#include "ui/panels/timeline/sound_watch.h"

#include <utility>

#include "ui/edit/media_files.h"

namespace hazumi::ui {

void SoundWatch::Look(const edit::Session& session) {
  using Watch = FileWatch<Heard>;
  const auto read = [](const std::string& path,
                       const Watch::IsCancelled& is_cancelled) -> Result<Heard> {
    Result<Sound> sound = DecodeSound(path, {}, is_cancelled);
    if (!sound.ok()) return sound.error();
    Peaks peaks(sound.value());
    return Heard{std::move(sound).value(), std::move(peaks)};
  };
  file_.Look(edit::SoundPath(session.project(), session.document().path()), "", read);
}

}  // namespace hazumi::ui
