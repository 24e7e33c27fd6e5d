#include "ui/panels/timeline/film_watch.h"

#include <utility>

#include "ui/edit/media_files.h"

namespace hazumi::ui {

void FilmWatch::Look(const edit::Session& session) {
  using Watch = FileWatch<std::shared_ptr<const Film>>;
  const ProjectRate fps = session.project().fps;
  const auto read =
      [fps](const std::string& path,
            const Watch::IsCancelled& is_cancelled) -> Result<std::shared_ptr<const Film>> {
    Result<Film> film = DecodeFilm(path, fps.num, fps.den, is_cancelled);
    if (!film.ok()) return film.error();
    return std::make_shared<const Film>(std::move(film).value());
  };
  file_.Look(edit::ReferencePath(session.project(), session.document().path()),
             std::to_string(fps.num) + "/" + std::to_string(fps.den), read);
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
