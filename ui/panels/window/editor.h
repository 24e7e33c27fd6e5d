#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/mesh/flat_mesh.h"
#include "render/motion/figure_skin.h"
#include "render/motion/thing_models.h"
#include "render/scene/scene.h"
#include "ui/edit/session/session.h"
#include "ui/panels/commands/keymap.h"
#include "ui/panels/commands/tool.h"
#include "ui/panels/dialogs/state.h"
#include "ui/panels/poses/state.h"
#include "ui/panels/properties/state.h"
#include "ui/panels/sheet/state.h"
#include "ui/panels/sweep/state.h"
#include "ui/panels/text/catalogue.h"
#include "ui/panels/timeline/effort_watch.h"
#include "ui/panels/timeline/flight_watch.h"
#include "ui/panels/timeline/key_watch.h"
#include "ui/panels/timeline/media_watch.h"
#include "ui/panels/timeline/playback.h"
#include "ui/panels/viewport/state.h"
#include "ui/panels/window/layout.h"
#include "ui/panels/window/theme.h"

namespace hazumi::ui {

using edit::Json;

// What a user chooses once and for all projects.
struct Settings {
  bool dark = true;
  Language language = Language::kEnglish;
  bool has_chosen_language = false;  // else it is that of the system, each time anew
  double scale = 1.0;                // of the interface
  Shares shares;
  std::vector<std::string> recent_files;    // the latest first
  std::vector<std::string> opened_outside;  // sounds and references that may be, the latest first
  bool has_seen_first_steps = false;
  Keymap keymap;  // keys that are not as they come
  bool operator==(const Settings&) const = default;
};

// What the status bar says about the last thing done.
struct Message {
  std::string text;
  bool is_error = false;
};

// Draws a scene into a texture and returns it; given by whoever owns the GL context.
using ScenePainter = std::function<Result<unsigned>(const render::Scene& scene,
                                                    render::PictureSize size, bool shadow)>;

// The editor as it is at the moment, on a screen or not: a session, and all that is seen of it.
// Panels read it and change the document by operators alone.
class Editor {
 public:
  Editor();

  edit::Session& session() { return session_; }
  const edit::Session& session() const { return session_; }

  // Runs an action of the editor or else an operator of the session. What is refused is shown in
  // the status bar, and changes nothing.
  Result<Done> Invoke(const std::string& id, const Json& parameters = Json::object());
  // The same, when nobody asks what became of it.
  bool Do(const std::string& id, const Json& parameters = Json::object()) {
    return Invoke(id, parameters).ok();
  }
  void Say(const std::string& text, bool is_error = false) { message = {text, is_error}; }

  // Time passes: playback goes on. `now` counts up from anywhere [s].
  void Tick(double now);
  double now() const { return now_; }
  // Seconds until the editor changes by itself; a large number if it does not.
  double NextDeadline() const;

  // Takes a tool in hand; one that was is cancelled.
  void Take(std::unique_ptr<Tool> next);
  bool has_tool() const { return tool_ != nullptr; }
  bool aims() const { return tool_ && tool_->aims(); }
  std::string tool_hint() const { return tool_ ? tool_->hint() : ""; }
  void UpdateTool(const ToolInput& input);
  // Puts down what was in hand for a document that is no longer there.
  void DropTool();

  // Frames from first to last that are played: the preview range, or all.
  int first_frame() const { return session_.project().frames.first; }
  int last_frame() const { return session_.project().frames.last; }

  // Agrees that a sound or reference outside of a project's folder is opened, now and later.
  void OpenOutside(const std::string& path);

  // A text with letters that fonts may have to be loaded for, such as the name of a file.
  void NeedGlyphs(const std::string& text);
  const std::string& glyphs() const { return glyphs_; }

  const Theme& theme() const { return settings.dark ? DarkTheme() : LightTheme(); }

  Settings settings;
  Message message;
  Playback playback;
  ViewportState viewport;
  render::SkinCache skins;  // of the document
  render::ThingCache things;
  SheetState sheet;
  SideState side;
  PosesState poses;
  SweepState sweep;
  bool mirrors_poses = false;  // posing one side poses the other as its mirror image
  RecoveryState recovery;
  DialogsState dialogs;
  GroundWatch ground;
  TurnWatch turns;
  FlightWatch flights;
  EffortWatch effort;
  SoundWatch sound;
  FilmWatch film;
  std::optional<Splitter> dragged_splitter;
  Point mouse;  // where a window saw it last [px]
  bool wants_to_quit = false;
  ScenePainter paint_scene;
  PictureKeeper pictures;
  PictureWriter write_pictures;  // from any thread

 private:
  void Note(const std::string& id, const Json& parameters);
  void SayFilled(const std::string& id);
  void SayIfSwung(const std::string& id, const Json& parameters);
  void DropObject(const std::string& id);
  void ShowAdded(const std::string& id);
  void KeepAgreement(const std::string& id, const Json& parameters);
  Json WithMirror(const std::string& id, Json parameters) const;
  double UntilNextFrame() const;  // of playback [s]
  bool ShowsEffort() const;

  edit::Session session_;
  std::unique_ptr<Tool> tool_;
  double now_ = 0.0;
  std::string glyphs_;
};

// Result of an aim: how much muscle it takes, and where most.
struct AimAnswer {
  std::string text;
  bool is_caution = false;  // it asks for more than muscles can give
};
AimAnswer AnswerOf(const edit::Session& session);

}  // namespace hazumi::ui
