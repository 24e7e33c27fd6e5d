#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "engine/project/compile.h"
#include "ui/edit/document/document.h"
#include "ui/edit/media_files.h"
#include "ui/edit/operator.h"
#include "ui/edit/session/background_bake.h"
#include "ui/edit/session/renew_fills.h"

namespace hazumi::edit {

// A pose to be pasted: angles by hinge [degrees].
using Pose = std::vector<Named<double>>;

// Makes a skin of a figure's capsules.
using SkinMaker = std::function<Skin(const Figure&)>;

// Told of operators. Either may be empty.
struct SessionObserver {
  std::function<void()> before;  // it may still be refused
  std::function<void(const std::string& id, const Json& parameters)> after;  // it succeeded
};

// An editor without a screen: the document, what is selected, the current frame, and the motion,
// which follows every edit.
class Session {
 public:
  // A new project: the human that comes with Hazumi, standing on the ground.
  Session();

  Document& document() { return *document_; }
  const Document& document() const { return *document_; }
  const Project& project() const { return document_->project(); }
  // Takes the place of the document; nothing stays selected, hidden or locked.
  void Replace(Project project, const std::string& path);
  // Counts up whenever another document takes the place.
  long document_number() const { return document_number_; }

  // One undo step: `change` edits the project. A change that fails, or after which a project could
  // no longer be animated that could be before, or whose file could no longer be read, is undone,
  // and the error returned.
  Result<Done> Edit(const std::string& label, const std::function<Result<Done>(Project*)>& change,
                    const std::string& merge = "");

  // Does it, or says why not and leaves everything as it was.
  Result<Done> Run(const std::string& id, const Json& parameters = Json::object());
  // Returns what the latest operator made and measured.
  const Outcome& outcome() const { return outcome_; }
  void ForgetOutcome() { outcome_ = Outcome(); }
  // Operators tell it what they measured.
  void Measured(const std::string& name, double value) {
    outcome_.measured.push_back({name, value});
  }
  // Tells of each operator, but not of those that an operator runs itself, as long as what this
  // returns is kept.
  [[nodiscard]] std::shared_ptr<const SessionObserver> Observe(SessionObserver observer);

  double frame() const { return frame_; }
  void set_frame(double frame) { frame_ = frame; }
  const std::set<std::string>& selected_joints() const { return selected_joints_; }
  bool is_root_selected() const { return selected_joints_.contains(figure_->root_name()); }
  void set_selected_joints(std::set<std::string> names) { selected_joints_ = std::move(names); }
  // Hinges without marks, and hinges that are not posed.
  const std::set<std::string>& hidden_joints() const { return hidden_joints_; }
  void set_hidden_joints(std::set<std::string> names) { hidden_joints_ = std::move(names); }
  const std::set<std::string>& locked_joints() const { return locked_joints_; }
  void set_locked_joints(std::set<std::string> names) { locked_joints_ = std::move(names); }
  const KeySelection& selected_keys() const { return document_->selected_keys(); }
  void set_selected_keys(KeySelection keys) { document_->set_selected_keys(std::move(keys)); }
  const std::vector<Named<ProjectKey>>& key_clipboard() const { return key_clipboard_; }
  void set_key_clipboard(std::vector<Named<ProjectKey>> keys) { key_clipboard_ = std::move(keys); }
  const Pose& clipboard() const { return clipboard_; }
  void set_clipboard(Pose pose) { clipboard_ = std::move(pose); }

  // Reports of the fills that the latest edit made anew; empty if it left them alone.
  const std::vector<makers::FillReport>& fill_reports() const { return fill_reports_; }
  // Why their keys are older than the latest edit; none: they are not.
  const std::optional<Error>& fill_error() const { return fill_error_; }

  // Files are saved only if they can be read back and animated (see check_saved.h): for whoever is
  // not there to look.
  bool saves_checked() const { return saves_checked_; }
  void set_saves_checked(bool checked) { saves_checked_ = checked; }

  // Permission to open sounds and references.
  MediaAccess& media() { return media_; }
  const MediaAccess& media() const { return media_; }

  // For files of other programs. Empty unless whoever owns the session can draw capsules.
  const SkinMaker& capsules() const { return capsules_; }
  void set_capsules(SkinMaker maker) { capsules_ = std::move(maker); }

  // The figure of the project; every project has one.
  const Figure& figure() const { return *figure_; }
  // What the project says; null if it cannot be animated.
  const Animation* animation();
  // Bakes what an edit changed up to a frame of the project, or all. The motion is as far as that
  // right, and what it was before elsewhere. Errors: of CompileAnimation, Bake, and kInterrupted if
  // it takes longer than the session has patience for.
  Result<const Motion*> MotionTo(int frame);
  Result<const Motion*> WholeMotion();
  // Why there is no motion, as far as that is known by now: nothing is baked for it.
  std::optional<Error> KnownError();
  // The motion at the frame nearest to the current one.
  Result<const MotionFrame*> FrameNow();
  // The same to be looked at: where it is not there yet or there is none, as it was before. An
  // error only where there was nothing before.
  Result<const Motion*> ShownMotionTo(int frame);
  Result<const MotionFrame*> ShownFrame();
  // Seconds that a motion is waited for; what takes longer goes on beside. None: without end.
  std::optional<double> patience() const { return patience_; }
  void set_patience(std::optional<double> seconds) { patience_ = seconds; }
  // What goes on beside; null if nothing does or ever did.
  const BackgroundBake* bake() const { return bake_.get(); }
  void StopBaking();
  void ResumeBaking();
  // What a curve would have to say at the current frame for what is seen there, whatever moves it:
  // of a hinge or of the root, degrees, of the root's position metres.
  Result<double> ValueNow(const std::string& curve);

 private:
  Result<std::vector<makers::FillReport>> Refill(const Project& before, const std::string& merge,
                                                 Project* after);
  Result<Done> RunUnobserved(const std::string& id, const Json& parameters);
  void Tell(const std::function<void(const SessionObserver&)>& what) const;
  void Compile();
  void Take(Result<Compiled> compiled);
  Result<Compiled> CompileProject(const Project& project) const;
  void TakeFigure(std::shared_ptr<const Figure> figure);
  int NearestFrame() const;

  std::unique_ptr<Document> document_;
  std::set<std::string> selected_joints_, hidden_joints_, locked_joints_;
  double frame_ = 0.0;
  Pose clipboard_;
  std::vector<Named<ProjectKey>> key_clipboard_;  // by curve
  std::vector<std::weak_ptr<const SessionObserver>> observers_;
  bool is_running_ = false;  // an operator
  Outcome outcome_;
  std::vector<makers::FillReport> fill_reports_;
  std::optional<Error> fill_error_;
  bool saves_checked_ = false;
  MediaAccess media_;
  long document_number_ = 0;

  ProjectFigure figure_source_;  // figure_ was built from
  std::shared_ptr<const Figure> figure_;
  long compiled_revision_ = -1;
  std::optional<Animation> animation_;
  std::optional<Error> compile_error_;
  std::unique_ptr<BackgroundBake> bake_;
  std::optional<double> patience_;
  SkinMaker capsules_;
};

}  // namespace hazumi::edit
