// Files, history, time and selection.

#include <algorithm>
#include <filesystem>

#include "engine/figure/sides.h"
#include "engine/project/project_files.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "ui/edit/check_saved.h"
#include "ui/edit/document/document.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/new_project.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

std::string FolderOf(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, std::max<size_t>(slash, 1));
}

Result<Done> New(Session* session, const Parameters&) {
  session->Replace(NewProject(), "");
  return Done();
}

Result<Done> Open(Session* session, const Parameters& p) {
  const std::string path = p.text("path");
  const std::string digest = DigestOfFile(path);  // before, so that no change is missed
  Result<Project> project = LoadProject(path);
  if (!project.ok()) return project.error();
  session->Replace(std::move(project).value(), path);
  session->document().set_file_digest(digest);
  return Done();
}

Error NotSaved(Error error, const std::string& path) {
  if (error.file.empty()) error.file = path;
  error.message += " (so it is not saved)";
  return error;
}

// By whatever way it is named.
bool IsSameFile(const std::string& a, const std::string& b) {
  std::error_code failed;
  return a == b || std::filesystem::equivalent(a, b, failed);
}

// Under another name the figure's file is still found, and what was open stays so.
Result<Done> Save(Session* session, const Parameters& p) {
  Document& document = session->document();
  const std::string path = p.text("path", document.path());
  if (path.empty()) return Refusal("path", "the project has no file yet; give it one");
  if (IsSameFile(path, document.path()) && !p.yes("overwrite") && document.is_changed_elsewhere()) {
    return Error{
        ErrorCode::kCannotWrite, path, "",
        "another program has changed it since it was read (so it is not saved); open it "
        "again, save under another name, or save with \"overwrite\" to lose what it holds"};
  }
  Project project = document.project();
  for (const std::string& file :
       {SoundPath(project, document.path()), ReferencePath(project, document.path())}) {
    if (!session->media().WhyClosed(file, document.path())) session->media().Allow(file);
  }
  if (!document.path().empty() && FolderOf(path) != FolderOf(document.path())) {
    RebaseReferences(&project, FolderOf(document.path()), FolderOf(path));
  }
  if (session->saves_checked()) {
    const Result<Done> checked = CheckSaved(project, path);
    if (!checked.ok()) return NotSaved(checked.error(), path);
  }
  Result<Done> saved = SaveProject(project, path);
  if (!saved.ok()) return saved;
  if (project != document.project()) {
    Transaction transaction(&document);
    transaction.project() = std::move(project);
    transaction.Commit("Save under another name");
  }
  document.MarkSaved(path);
  return Done();
}

const ParameterInfo kSteps = {"steps", ParameterKind::kInteger, false, "how many; not given: one"};

// So many steps, or none at all.
template <typename Step>
Result<Done> Take(const Parameters& p, size_t available, const char* what, Step step) {
  const int steps = p.integer("steps", 1);
  if (steps < 1) return Refusal("steps", "must be 1 or more");
  if (available == 0) return Refusal("", std::string("there is nothing to ") + what);
  if (static_cast<size_t>(steps) > available) {
    return Refusal("steps", "there are " + std::to_string(available) + " to " + what);
  }
  for (int i = 0; i < steps; ++i) {
    if (!step() && i == 0) return Refusal("", std::string("there is nothing to ") + what);
  }
  return Done();
}

Result<Done> Undo(Session* session, const Parameters& p) {
  Document& document = session->document();
  return Take(p, document.undo_labels().size(), "undo", [&] { return document.Undo(); });
}

Result<Done> Redo(Session* session, const Parameters& p) {
  Document& document = session->document();
  return Take(p, document.redo_labels().size(), "redo", [&] { return document.Redo(); });
}

Result<Done> SetFrame(Session* session, const Parameters& p) {
  session->set_frame(p.number("frame"));
  return Done();
}

Result<Done> SetRange(Session* session, const Parameters& p) {
  return session->Edit(
      "Set frame range",
      [&](Project* project) -> Result<Done> {
        project->frames.first = p.integer("first", project->frames.first);
        project->frames.last = p.integer("last", project->frames.last);
        return Done();
      },
      p.text("drag"));
}

double FramesPerSecond(const ProjectRate& rate) { return static_cast<double>(rate.num) / rate.den; }

// Of all keys that have one.
void ScaleRates(double factor, Project* project) {
  const auto scale = [&](ProjectCurve* curve) {
    for (ProjectKey& key : curve->keys) {
      if (key.rate) *key.rate *= factor;
      if (key.rate_in) *key.rate_in *= factor;
    }
  };
  for (ProjectCurve& curve : project->root.curves) scale(&curve);
  for (Named<ProjectCurve>& curve : project->joints) scale(&curve.value);
}

Result<Done> SetRate(Session* session, const Parameters& p) {
  return session->Edit(
      "Set frame rate",
      [&](Project* project) -> Result<Done> {
        const double before = FramesPerSecond(project->fps);
        project->fps.den = 1;
        if (Result<Done> set = SetFields(p, &project->fps); !set.ok()) return set;
        if (p.yes("keep_shape")) ScaleRates(FramesPerSecond(project->fps) / before, project);
        return Done();
      },
      p.text("drag"));
}

Result<Done> SetName(Session* session, const Parameters& p) {
  return session->Edit("Rename project", [&](Project* project) -> Result<Done> {
    project->name = p.text("name");
    return Done();
  });
}

Result<Done> SelectJoints(Session* session, const Parameters& p) {
  const std::string mode = p.text("mode", "replace");
  if (mode != "replace" && mode != "add" && mode != "remove") {
    return Refusal("mode", "\"" + mode + "\" is none of replace, add, remove");
  }
  std::set<std::string> selected;
  if (mode != "replace") selected = session->selected_joints();
  for (const std::string& name : p.names("joints")) {
    const Result<std::vector<std::string>> hinges = HingesNamed(name, session->figure());
    if (!hinges.ok()) return hinges.error();
    for (const std::string& hinge : hinges.value()) {
      mode == "remove" ? (void)selected.erase(hinge) : (void)selected.insert(hinge);
    }
  }
  session->set_selected_joints(std::move(selected));
  return Done();
}

Result<Done> SelectAll(Session* session, const Parameters&) {
  std::set<std::string> all = {session->figure().root_name()};
  for (const Joint& joint : session->figure().joints()) all.insert(joint.name);
  session->set_selected_joints(std::move(all));
  return Done();
}

Result<Done> CancelDrag(Session* session, const Parameters&) {
  session->document().CancelMerge();
  return Done();
}

Result<Done> SelectNone(Session* session, const Parameters&) {
  session->set_selected_joints({});
  return Done();
}

Result<Done> SelectMirror(Session* session, const Parameters& p) {
  std::set<std::string> selected;
  if (p.yes("add")) selected = session->selected_joints();
  const FigureSides sides(session->figure());
  for (const std::string& name : session->selected_joints()) {
    selected.insert(sides.OtherSideOf(name, session->figure()));
  }
  session->set_selected_joints(std::move(selected));
  return Done();
}

Result<Done> EndDrag(Session* session, const Parameters&) {
  session->document().EndMerge();
  return Done();
}

}  // namespace

Result<std::vector<std::string>> HingesNamed(const std::string& name, const Figure& figure) {
  std::vector<std::string> hinges;
  if (const auto group = figure.FindGroup(name)) {
    const JointGroup& joint = figure.group(*group);
    for (int j = joint.first.value(); j <= joint.last().value(); ++j) {
      hinges.push_back(figure.joints()[j].name);
    }
  } else if (const auto hinge = figure.FindJoint(name)) {
    hinges.push_back(figure.joint(*hinge).name);
  } else if (name == figure.root_name()) {
    hinges.push_back(name);
  }
  if (hinges.empty()) return Refusal("joints", "the figure has no joint \"" + name + "\"");
  return hinges;
}

std::string FirstSelectedJoint(const Session& session) {
  const Figure& figure = session.figure();
  for (const Joint& hinge : figure.joints()) {
    if (session.selected_joints().contains(hinge.name)) return figure.group(hinge.group).name;
  }
  return "";
}

std::string LikelyJoint(const Session& session) {
  const Figure& figure = session.figure();
  if (std::string selected = FirstSelectedJoint(session); !selected.empty()) return selected;
  return figure.groups().empty() ? figure.root_name() : figure.groups().front().name;
}

std::vector<std::string> JointNames(const std::set<std::string>& hinges, const Figure& figure) {
  std::vector<std::string> names;
  for (const JointGroup& joint : figure.groups()) {
    std::vector<std::string> meant;
    for (int j = joint.first.value(); j <= joint.last().value(); ++j) {
      if (hinges.contains(figure.joints()[j].name)) meant.push_back(figure.joints()[j].name);
    }
    if (static_cast<int>(meant.size()) == joint.size) meant = {joint.name};
    names.insert(names.end(), meant.begin(), meant.end());
  }
  return names;
}

std::vector<std::string> SelectedNames(const Session& session) {
  const Figure& figure = session.figure();
  std::vector<std::string> names = JointNames(session.selected_joints(), figure);
  if (session.is_root_selected()) names.insert(names.begin(), figure.root_name());
  return names;
}

std::vector<Operator> SessionOperators() {
  return {
      {"file.new", "New", "A new project: the human, standing on the ground.", {}, New},
      {"file.open", "Open", "Opens a project.", {{"path", kText, true, "a .kfa file"}}, Open},
      {"file.save",
       "Save",
       "Saves the project, whole or not at all.",
       {{"path", kText, false, "where to; not given: where it came from"},
        {"overwrite", kYesNo, false, "true: also what another program has written there since"}},
       Save},
      {"edit.undo", "Undo", "Takes the last steps back.", {kSteps}, Undo},
      {"edit.redo", "Redo", "Takes the last steps that were undone again.", {kSteps}, Redo},
      {"edit.end_drag", "End drag", "The next edit is an undo step of its own.", {}, EndDrag},
      {"edit.cancel_drag",
       "Cancel drag",
       "Takes the drag back, as if it had never been.",
       {},
       CancelDrag},
      {"time.frame",
       "Go to frame",
       "Sets the current frame.",
       {{"frame", kNumber, true, "may lie between frames"}},
       SetFrame},
      {"time.range", "Set frame range", "Sets the first and last frame of the animation.",
       Joined({FieldsOf<ProjectFrames>(), {kDrag}}), SetRange},
      {"time.rate", "Set frame rate", "Sets the frames per second. Keys stay on their frames.",
       Joined({Requiring({"num"}, FieldsOf<ProjectRate>()),
               {{"keep_shape", kYesNo, false,
                 "true: curves keep their shape frame by frame, the rates of keys change with it"},
                kDrag}}),
       SetRate},
      {"project.rename",
       "Rename project",
       "Names the project.",
       {{"name", kText, true, "its name"}},
       SetName},
      {"select.joints",
       "Select joints",
       "Selects hinges, joints with all their hinges, or the root.",
       {{"joints", kNames, true, "names; none of them: nothing is selected", Thing::kJointOrHinge},
        {"mode", kText, false, "replace, add or remove", "replace add remove"}},
       SelectJoints},
      {"select.all", "Select all", "Selects the root and all joints.", {}, SelectAll},
      {"select.none", "Select none", "No joint stays selected.", {}, SelectNone},
      {"select.mirror",
       "Select mirror",
       "Selects left for right and right for left.",
       {{"add", kYesNo, false, "true: what was selected stays so"}},
       SelectMirror}};
}

}  // namespace hazumi::edit
