#pragma once

#include "engine/media/peaks.h"
#include "ui/edit/session/session.h"
#include "ui/panels/timeline/file_watch.h"

namespace hazumi::ui {

// The project's sound, to be drawn and heard.
class SoundWatch {
 public:
  void Look(const edit::Session& session);
  bool is_busy() const { return file_.is_busy(); }
  // Null while they are not known.
  const Peaks* peaks() const { return file_.value() ? &file_.value()->peaks : nullptr; }
  const Sound* sound() const { return file_.value() ? &file_.value()->sound : nullptr; }
  // Why there are none; empty: there are, or it is being read.
  std::string error() const { return file_.error(); }

 private:
  struct Heard {
    Sound sound;
    Peaks peaks;
  };
  FileWatch<Heard> file_;
};

}  // namespace hazumi::ui
