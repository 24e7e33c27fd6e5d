#include "ui/panels/timeline/media_watch.h"

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

void FilmWatch::Look(const edit::Session& session) {
  using Watch = FileWatch<std::shared_ptr<const Film>>;
  const ProjectRate fps = session.project().fps;
  const std::string& project = session.document().path();
  const std::string file = ReferencePath(session.project(), project);
  const std::optional<Error> closed = session.media().WhyClosed(file, project);
  const auto read =
      [fps, closed](const std::string& path,
                    const Watch::IsCancelled& is_cancelled) -> Result<std::shared_ptr<const Film>> {
    if (closed) return *closed;
    Result<Film> film = DecodeFilm(path, fps.num, fps.den, is_cancelled);
    if (!film.ok()) return film.error();
    return std::make_shared<const Film>(std::move(film).value());
  };
  file_.Look(file,
             std::to_string(fps.num) + "/" + std::to_string(fps.den) + (closed ? " closed" : ""),
             read);
}

void FilmWatch::AddTo(const edit::Session& session, int frame, render::Scene* scene) {
  const auto& reference = session.project().reference;
  const std::shared_ptr<const Film>* film = file_.value();
  if (!reference || !film) return;
  if (film_ != *film) {
    film_ = *film;
    const FrameRate rate{session.project().fps.num, session.project().fps.den};
    reference_ = render::ReferenceFilm(film_, rate, rate);
    error_.clear();
  }
  const Result<Done> added = reference_.AddTo(*reference, frame, scene);
  if (!added.ok()) error_ = added.error().ToString();
}

}  // namespace hazumi::ui
