#include "ui/panels/window/editor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/filled.h"
#include "engine/base/input_files.h"
#include "engine/base/named.h"
#include "engine/base/text.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/items.h"
#include "engine/project/project_files.h"
#include "render/motion/figure_skin.h"
#include "ui/edit/document/change.h"
#include "ui/edit/operators/keys/at_frame.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/poses/thumbnails.h"
#include "ui/panels/sweep/actions.h"
#include "ui/panels/viewport/actions.h"

namespace hazumi::ui {

Editor::Editor() {
  viewport.framed_document = session_.document_number();
  session_.set_capsules([](const Figure& figure) { return render::SkinOfLinks(figure); });
}

namespace {

// Whether what goes well says that an earlier refusal is no longer of interest; the end of a drag
// does not, for a drag ends when it is refused.
bool IsNewDeed(const std::string& id) { return id != "edit.end_drag" && id != "edit.cancel_drag"; }

bool IsUndoOrRedo(const std::string& id) { return id == "edit.undo" || id == "edit.redo"; }

// The sheet moves as far as it takes to have the frame in its middle, if it does not show it.
void ShowInSheet(double frame, SheetState* sheet) {
  if (frame >= sheet->first && frame <= sheet->last) return;
  const double half = 0.5 * (sheet->last - sheet->first);
  sheet->first = frame - half;
  sheet->last = frame + half;
}

// Nobody sees what is undone or done again on other frames than the current one: there time goes
// to the first of them, unless it is playing.
void ShowUndone(const std::string& id, const Project& before, Editor* editor) {
  edit::Session& session = editor->session();
  const std::vector<edit::FrameSpan> spans = edit::ChangedFrames(before, session.project());
  const double now = session.frame();
  const bool is_seen = std::any_of(spans.begin(), spans.end(), [&](const edit::FrameSpan& span) {
    return span.first <= now && now <= span.last;
  });
  if (spans.empty() || is_seen || editor->playback.is_on()) return;
  const auto first = std::min_element(
      spans.begin(), spans.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  session.set_frame(std::clamp<double>(first->first, editor->first_frame(), editor->last_frame()));
  ShowInSheet(session.frame(), &editor->sheet);
  const edit::Document& document = session.document();
  const bool is_undo = id == "edit.undo";
  const std::string step = *(is_undo ? document.redo_label() : document.undo_label());
  editor->Say(std::string(LabelOf(id)) + ": " + Tr(step.c_str()) + " (F" +
              FormatShort(session.frame()) + ")");
}

}  // namespace

// Of operators that pose one side: the other one too, where that is wanted and nothing else said.
Json Editor::WithMirror(const std::string& id, Json parameters) const {
  const edit::Operator* op = mirrors_poses ? edit::FindOperator(id) : nullptr;
  if (!op || parameters.contains("mirror")) return parameters;
  const auto is_mirror = [](const auto& info) { return std::string("mirror") == info.name; };
  if (std::any_of(op->parameters.begin(), op->parameters.end(), is_mirror)) {
    parameters["mirror"] = true;
  }
  return parameters;
}

Result<Done> Editor::Invoke(const std::string& id, const Json& parameters) {
  Result<Done> done = Done();
  const Message before = message;
  const long document = session_.document_number();
  std::optional<Project> undone;
  if (IsUndoOrRedo(id)) undone = session_.project();
  if (const Action* action = FindAction(id)) {
    const auto checked = edit::Parameters::Check(action->parameters, parameters);
    done = checked.ok() ? action->run(this, checked.value()) : checked.error();
  } else {
    done = session_.Run(id, WithMirror(id, parameters));
  }
  if (!done.ok()) Say(TextOf(done.error(), id), true);
  const bool is_as_before = message.text == before.text;
  const bool is_of_before =
      document != session_.document_number() || (message.is_error && IsNewDeed(id));
  if (done.ok() && is_as_before && is_of_before) Say("");
  if (done.ok()) Note(id, parameters);
  if (done.ok() && undone) ShowUndone(id, *undone, this);
  return done;
}

// A selected object that is gone is not selected, nor one of another document; joints that are
// selected take its place.
void Editor::DropObject(const std::string& id) {
  ItemId& selected = viewport.selected_object;
  if (!selected.is_valid()) return;
  const Project& project = session_.project();
  const bool is_there = hazumi::IndexOf(selected, project.scene.objects) >= 0 ||
                        hazumi::IndexOf(selected, project.held_objects) >= 0;
  const bool is_other = viewport.framed_document != session_.document_number();
  const bool selects_joints = id.starts_with("select.") && !session_.selected_joints().empty();
  if (!is_there || is_other || selects_joints) selected = ItemId();
}

// The properties open what was added and has no other place where it is changed.
void Editor::ShowAdded(const std::string& id) {
  const Project& project = session_.project();
  const auto show = [&]<typename Item>(auto kind, const std::vector<Item>& items) {
    if constexpr (HasTitle<Item>) {
      if (id == kind.kAdd) side.added = items.back().identity.id;
    }
  };
  ForEachItemList(show, project);
  if (id == "constraint.hold_on") side.added = project.constraints.back().identity.id;
}

// Says how far a fill moved joints and what it costs, or that fills could not be made.
void Editor::SayFilled(const std::string& id) {
  if (session_.fill_error()) {
    return Say(
        Filled(Tr("Fills keep their old keys: %s"), TextOf(*session_.fill_error(), id).c_str()),
        true);
  }
  if (id != "fill.add" && id != "fill.set") return;
  const auto measured = [&](const char* name) {
    const auto* value = FindNamed(session_.outcome().measured, name);
    return value ? value->value : 0.0;
  };
  if (measured("keys") == 0.0) return Say(Tr("Nothing to fill: the keys' curves do as well."));
  std::string text =
      Filled(Tr("Filled: at most %s cm from where it was (F%d)"),
             FormatShort(measured("moved_cm")).c_str(), static_cast<int>(measured("moved_at")));
  if (measured("torque_n_m") > 0.0) {
    text += Filled(Tr("; torque %s N m, before %s"), FormatShort(measured("torque_n_m")).c_str(),
                   FormatShort(measured("torque_before_n_m")).c_str());
  }
  if (measured("stepped") > 0.0) {
    text += Filled(Tr("; %d curves keep parts that hold, are linear or eased"),
                   static_cast<int>(measured("stepped")));
  }
  if (measured("unfilled") > 0.0) {
    text +=
        Filled(Tr("; %d curves are not filled: too few keys, or keys that are whole turns apart"),
               static_cast<int>(measured("unfilled")));
  }
  Say(text);
}

AimAnswer AnswerOf(const edit::Session& session) {
  const auto measured = [&](const char* name) {
    const auto* value = FindNamed(session.outcome().measured, name);
    return value ? value->value : 0.0;
  };
  if (measured("loose") > 0.0) return {Tr("Arrives by itself, without muscle.")};
  const double muscle = measured("muscle");
  if (muscle == 0.0) return {Tr("Arrives.")};
  const bool is_caution = muscle > 1.0;
  const std::string percent = FormatShort(100.0 * muscle);
  if (!FindNamed(session.outcome().measured, "strongest")) {
    const char* text = is_caution ? "Arrives, but asks for %s %% of what muscles can give."
                                  : "Arrives with %s %% of what muscles can give, at most.";
    return {Filled(Tr(text), percent.c_str()), is_caution};
  }
  const std::string joint =
      session.figure().joint(JointIndex(static_cast<int>(measured("strongest")))).name;
  const char* text = is_caution ? "Arrives, but asks for %s %% of what muscles can give (%s, F%d)."
                                : "Arrives with %s %% of what muscles can give, at most (%s, F%d).";
  return {
      Filled(Tr(text), percent.c_str(), joint.c_str(), static_cast<int>(measured("strongest_at"))),
      is_caution};
}

// A key that was made while a region moves its joint is not seen there: who wonders why is told.
void Editor::SayIfSwung(const std::string& id, const Json& parameters) {
  constexpr const char* kPosing[] = {"key.insert", "key.set",     "pose.clear", "pose.paste",
                                     "pose.reach", "pose.rotate", "pose.blend", "pose.breakdown",
                                     "pose.relax", "pose.push",   "pose.swivel"};
  if (std::find(std::begin(kPosing), std::end(kPosing), id) == std::end(kPosing)) return;
  const double frame = parameters.value("frame", session_.frame());
  std::set<std::string> hinges = session_.selected_joints();
  for (const char* one : {"joint", "curve"}) {
    if (parameters.contains(one)) hinges = {parameters[one].get<std::string>()};
  }
  for (const ProjectRegion& by : session_.project().regions) {
    if (!edit::HasTakenOver(by, frame)) continue;
    const std::vector<bool> moved = JointsOf(by, session_.figure());
    const auto first = std::find_if(hinges.begin(), hinges.end(), [&](const std::string& name) {
      const auto hinge = session_.figure().FindJoint(name);
      return hinge && moved[hinge->value()];
    });
    if (first == hinges.end()) continue;
    return Say(Filled(Tr("In this frame the region \"%s\" moves %s, not its key. Split"
                         " the region here (menu Region), or pose it after frame %d."),
                      by.name.c_str(), first->c_str(), by.last_frame));
  }
}

void Editor::OpenOutside(const std::string& path) {
  constexpr size_t kMost = 100;
  session_.media().Allow(path);
  std::vector<std::string>& files = settings.opened_outside;
  const std::string file = FollowLinks(path);
  std::erase(files, file);
  files.insert(files.begin(), file);
  if (files.size() > kMost) files.resize(kMost);
}

// Who chose a file outside of the project's folder is not asked about it.
void Editor::KeepAgreement(const std::string& id, const Json& parameters) {
  if ((id != "audio.set" && id != "reference.set") || !parameters.contains("file")) return;
  const Project& project = session_.project();
  const std::string& path = session_.document().path();
  const std::string file =
      id == "audio.set" ? SoundPath(project, path) : ReferencePath(project, path);
  if (edit::MediaAccess().WhyClosed(file, path)) OpenOutside(file);
}

// What follows from something that was done.
void Editor::Note(const std::string& id, const Json& parameters) {
  const ExecutedCommand deed = {id, parameters, session_.frame(), session_.selected_joints()};
  dialogs.first_steps = After(std::move(dialogs.first_steps), deed);
  DropObject(id);
  SelectAdded(this, id);
  ShowAdded(id);
  KeepAgreement(id, parameters);
  SayIfSwung(id, parameters);
  SayFilled(id);
  if (id == "goal.add") {
    Say(Filled(Tr("\"%s\" is added; Aim, in its list, makes it come true."),
               session_.project().goals.back().name.c_str()));
  }
  if (id == "goal.aim" || id == "goal.reach") {
    const AimAnswer answer = AnswerOf(session_);
    Say(answer.text, answer.is_caution);
  }
  FrameNewDocument(this);
  CloseSweepOfOther(this);
  if (id == "time.range" && !parameters.contains("drag")) Do("sheet.frame_all");
  if (id == "file.open" || id == "file.save") AddRecent(session_.document().path(), &settings);
}

void Editor::NeedGlyphs(const std::string& text) {
  const auto is_foreign = [](char c) { return static_cast<unsigned char>(c) >= 0x80; };
  if (std::any_of(text.begin(), text.end(), is_foreign) &&
      glyphs_.find(text) == std::string::npos) {
    glyphs_ += text;
  }
}

void Editor::Tick(double now) {
  now_ = now;
  sound.Look(session_);
  film.Look(session_);
  if (ShowsEffort()) {
    effort.Look(&session_);
  } else {
    effort.Forget();
  }
  if (playback.is_on()) session_.set_frame(playback.Advance(now));
}

bool Editor::ShowsEffort() const {
  return viewport.overlays.effort || (sheet.kind == SheetKind::kGraph && sheet.torque);
}

double Editor::NextDeadline() const {
  constexpr double kBakingEvery = 0.1;  // what goes on beside is looked after [s]
  if (session_.bake() && session_.bake()->is_busy()) {
    return playback.is_on() ? std::min(kBakingEvery, UntilNextFrame()) : kBakingEvery;
  }
  if (!ground.is_done()) return 0.0;
  if ((sound.is_busy() || film.is_busy()) && !playback.is_on()) return kBakingEvery;
  if (effort.is_busy() && !playback.is_on()) return kBakingEvery;
  if (flights.is_busy() && !playback.is_on()) return kBakingEvery;
  if (poses.thumbnails && poses.thumbnails->is_busy()) return kBakingEvery;
  constexpr double kDialogEvery = 0.1;  // its cursor blinks, its progress goes on [s]
  if (dialogs.modal != Modal::kNone && !playback.is_on()) return kDialogEvery;
  if (!playback.is_on()) return std::numeric_limits<double>::infinity();
  return UntilNextFrame();
}

double Editor::UntilNextFrame() const { return std::max(0.0, playback.NextFrameTime() - now_); }

void Editor::Take(std::unique_ptr<Tool> next) {
  ToolInput cancel;
  cancel.cancel = true;
  if (tool_) tool_->Update(this, cancel);
  tool_ = std::move(next);
}

void Editor::DropTool() {
  tool_.reset();
  sheet.box.reset();
  viewport.box.reset();
  sheet.paint.reset();
}

void Editor::UpdateTool(const ToolInput& input) {
  viewport.aimed.reset();
  if (!tool_) return;
  std::unique_ptr<Tool> tool = std::move(tool_);
  const bool stays = tool->Update(this, input);
  if (stays && !tool_) tool_ = std::move(tool);
  if (!tool_) viewport.aimed.reset();
}

}  // namespace hazumi::ui
