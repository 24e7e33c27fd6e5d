#pragma once

#include <memory>

#include "engine/media/peaks.h"
#include "render/motion/reference_film.h"
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

// The project's reference picture or video, to be seen behind or in the scene.
class FilmWatch {
 public:
  void Look(const edit::Session& session);
  bool is_busy() const { return file_.is_busy(); }
  bool is_there() const { return file_.value() != nullptr; }
  // Why there is none; empty: there is, or it is being read.
  std::string error() const { return error_.empty() ? file_.error() : error_; }
  // Adds the picture of a frame.
  void AddTo(const edit::Session& session, int frame, render::Scene* scene);

 private:
  FileWatch<std::shared_ptr<const Film>> file_;
  std::shared_ptr<const Film> film_;
  render::ReferenceFilm reference_;  // of it
  std::string error_;                // of its pictures
};

}  // namespace hazumi::ui
