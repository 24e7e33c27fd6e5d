#include "ui/panels/commands/actions.h"

#include <algorithm>
#include <cmath>

#include "ui/edit/operator.h"
#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/dope_sheet/span_actions.h"
#include "ui/panels/poses/actions.h"
#include "ui/panels/sheet/actions.h"
#include "ui/panels/sweep/actions.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/overlays.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

namespace {

using edit::ParameterKind;
using edit::Parameters;

// The preview range as far as it lies in the animation, or all.
ProjectFrames PlayedFrames(const Editor& editor) {
  ProjectFrames all = {editor.first_frame(), editor.last_frame(), {}};
  const std::optional<ProjectFrames>& preview = editor.session().project().preview;
  if (!preview) return all;
  const int first = std::clamp(preview->first, all.first, all.last);
  return {first, std::clamp(preview->last, first, all.last), {}};
}

Result<Done> Play(Editor* editor, const Parameters&) {
  if (editor->playback.is_on()) {
    editor->playback.Stop();
    return Done();
  }
  const ProjectRate& fps = editor->session().project().fps;
  const ProjectFrames frames = PlayedFrames(*editor);
  editor->playback.Start(editor->now(), static_cast<int>(std::lround(editor->session().frame())),
                         frames.first, frames.last, static_cast<double>(fps.num) / fps.den);
  return Done();
}

Result<Done> Step(Editor* editor, const Parameters& p) {
  const double frame = std::round(editor->session().frame()) + p.integer("by");
  const int first = editor->first_frame(), last = editor->last_frame();
  return editor->session().Run("time.frame", {{"frame", std::clamp<double>(frame, first, last)}});
}

Result<Done> ToEnd(Editor* editor, const Parameters& p) {
  const bool is_last = p.yes("last");
  const ProjectFrames frames = PlayedFrames(*editor);
  return editor->session().Run("time.frame", {{"frame", is_last ? frames.last : frames.first}});
}

// The frames with keys of the selected joints, or of all.
Result<Done> ToKey(Editor* editor, const Parameters& p) {
  const edit::Session& session = editor->session();
  const bool is_next = p.yes("next");
  const double now = session.frame();
  std::optional<double> best;
  const auto look = [&](const ProjectCurve& curve) {
    for (const ProjectKey& key : curve.keys) {
      if (is_next ? key.frame <= now : key.frame >= now) continue;
      if (!best || (is_next ? key.frame < *best : key.frame > *best)) best = key.frame;
    }
  };
  const std::set<std::string>& chosen = session.selected_joints();
  for (const auto& [name, curve] : session.project().joints) {
    if (chosen.empty() || chosen.contains(name)) look(curve);
  }
  if (chosen.empty() || session.is_root_selected()) {
    for (const ProjectCurve& curve : session.project().root.curves) look(curve);
  }
  if (best) return editor->session().Run("time.frame", {{"frame", *best}});
  return Error{ErrorCode::kSchema, "", "",
               is_next ? "there is no later key" : "there is no earlier key"};
}

constexpr double kQuarter = 1.57079632679489661923;  // [rad]

Result<Done> Look(Editor* editor, const Parameters& p) {
  OrbitCamera& camera = editor->viewport.camera;
  const std::string side = p.text("side");
  editor->viewport.through_project_camera = false;
  if (side == "front") return camera.azimuth = 0.0, camera.elevation = 0.0, Done();
  if (side == "back") return camera.azimuth = 2.0 * kQuarter, camera.elevation = 0.0, Done();
  if (side == "left") return camera.azimuth = kQuarter, camera.elevation = 0.0, Done();
  if (side == "right") return camera.azimuth = -kQuarter, camera.elevation = 0.0, Done();
  if (side == "top") return camera.azimuth = -kQuarter, camera.elevation = kQuarter, Done();
  return Error{ErrorCode::kSchema, "", "side",
               "\"" + side + "\" is none of front, back, left, right, top"};
}

Result<Done> LookThrough(Editor* editor, const Parameters&) { return LookThroughCamera(editor); }

Result<Done> Orthographic(Editor* editor, const Parameters&) {
  editor->viewport.camera.is_orthographic = !editor->viewport.camera.is_orthographic;
  return Done();
}

Result<Done> ChooseTheme(Editor* editor, const Parameters& p) {
  editor->settings.dark = p.yes("dark", !editor->settings.dark);
  return Done();
}

Result<Done> ChooseLanguage(Editor* editor, const Parameters& p) {
  const std::string name = p.text("language");
  if (name != "en" && name != "ja") {
    return Error{ErrorCode::kSchema, "", "language", "\"" + name + "\" is none of en, ja"};
  }
  editor->settings.language = name == "ja" ? Language::kJapanese : Language::kEnglish;
  editor->settings.has_chosen_language = true;
  return Done();
}

Result<Done> ChooseScale(Editor* editor, const Parameters& p) {
  editor->settings.scale = std::clamp(p.number("scale"), 0.75, 3.0);
  return Done();
}

Result<Done> ChooseSheet(Editor* editor, const Parameters& p) {
  SheetState& sheet = editor->sheet;
  const bool is_graph = p.has("graph") ? p.yes("graph") : sheet.kind != SheetKind::kGraph;
  sheet.kind = is_graph ? SheetKind::kGraph : SheetKind::kDopeSheet;
  return Done();
}

Result<Done> ChooseSection(Editor* editor, const Parameters& p) {
  const std::pair<const char*, Section> all[] = {
      {"pose", Section::kPose},   {"poses", Section::kPoses},     {"region", Section::kRegion},
      {"scene", Section::kScene}, {"project", Section::kProject}, {"problems", Section::kProblems}};
  const std::string name = p.text("section");
  for (const auto& [known, section] : all) {
    if (name != known) continue;
    editor->side.section = section;
    return Done();
  }
  return Error{ErrorCode::kSchema, "", "section",
               "\"" + name + "\" is none of pose, poses, region, scene, project, problems"};
}

// Without anything to stop it is no mistake: the key for it is pressed for many reasons.
Result<Done> Stop(Editor* editor, const Parameters&) {
  editor->session().StopBaking();
  if (!editor->playback.is_on()) return Done();
  editor->playback.Stop();
  return editor->session().Run("time.frame", {{"frame", editor->playback.start_frame()}});
}

Result<Done> ResumeBaking(Editor* editor, const Parameters&) {
  editor->session().ResumeBaking();
  return Done();
}

Result<Done> Quit(Editor* editor, const Parameters&) {
  return AskToSave(editor, [](Editor* asked) -> Result<Done> {
    asked->wants_to_quit = true;
    return Done();
  });
}

}  // namespace

const std::vector<Action>& AllActions() {
  using enum ParameterKind;
  static const std::vector<Action> actions = {
      {"app.quit", "Quit", "Leaves Hazumi; asks what to do with unsaved changes.", {}, Quit},
      {"motion.stop",
       "Stop",
       "Ends playback where it began, and the computation of a motion that takes long.",
       {},
       Stop},
      {"motion.compute",
       "Compute motion",
       "Computes the motion that was stopped.",
       {},
       ResumeBaking},
      {"time.play", "Play", "Plays in real time, or stops.", {}, Play},
      {"time.step", "Step", "Some frames on or back.", {{"by", kInteger, true, "frames"}}, Step},
      {"time.to_end",
       "Jump to end",
       "To the first or the last frame.",
       {{"last", kYesNo, true, "true: the last"}},
       ToEnd},
      {"time.to_key",
       "Jump to key",
       "To the next or the previous key of what is selected.",
       {{"next", kYesNo, true, "true: the next"}},
       ToKey},
      {"view.side",
       "View from side",
       "Looks from a side.",
       {{"side", kText, true, "front, back, left, right, top", "front back left right top"}},
       Look},
      {"view.camera",
       "Through camera",
       "Looks through the project's camera, or not.",
       {},
       LookThrough},
      {"view.set_camera",
       "Set camera to the view",
       "The project's camera looks from where you look now.",
       {},
       [](Editor* editor, const Parameters&) { return SetCameraToView(editor); }},
      {"view.orthographic",
       "Orthographic",
       "Parallel lines stay parallel, or not.",
       {},
       Orthographic},
      {"view.frame_selected",
       "Frame selected",
       "Looks at what is selected, or else at the figure.",
       {},
       [](Editor* editor, const Parameters&) { return FrameSelected(editor); }},
      {"view.frame_all",
       "Frame all",
       "Looks at the whole motion.",
       {},
       [](Editor* editor, const Parameters&) { return FrameAll(editor); }},
      {"tool.rotate",
       "Rotate",
       "Turns the selected joints, or the object in a hand, with the mouse or by typed degrees.",
       {},
       [](Editor* editor, const Parameters&) { return TakeRotateTool(editor); }},
      {"tool.move",
       "Move",
       "Drags the selected joint, its limb following, or the selected object.",
       {},
       [](Editor* editor, const Parameters&) { return TakeMoveTool(editor); }},
      {"tool.box",
       "Box select joints",
       "Selects the joints in a rectangle; with Shift these too, with Ctrl without these.",
       {},
       [](Editor* editor, const Parameters&) { return TakeBoxTool(editor); }},
      {"view.overlay",
       "Overlay",
       "Shows or hides something beside the figure, or its skin.",
       {{"name", kText, true, "skin, paths, ghosts, keyed, marks, tint, limits, forces, shadow",
         "skin paths ghosts keyed marks tint limits forces shadow"},
        {"on", kYesNo, false, "not given: the other way round"}},
       SetOverlay},
      {"view.ghosts",
       "Ghosts of frames",
       "Shows ghosts, and says of which frames; what is not given stays.",
       {{"every", kInteger, false, "frames from one to the next", {}, "", "", kGhostReach},
        {"before", kInteger, false, "frames before the current one", {}, "", "", kGhostReach},
        {"after", kInteger, false, "frames after the current one", {}, "", "", kGhostReach},
        {"at_keys", kYesNo, false, "true: of frames with a key alone"}},
       SetGhosts},
      {"view.theme",
       "Theme",
       "Dark or light.",
       {{"dark", kYesNo, false, "not given: the other"}},
       ChooseTheme},
      {"view.language",
       "Language",
       "The language of the interface.",
       {{"language", kText, true, "en or ja", "en ja"}},
       ChooseLanguage},
      {"view.scale",
       "Interface scale",
       "How large everything is.",
       {{"scale", kNumber, true, "1 is normal, 0.75 to 3"}},
       ChooseScale},
      {"view.properties",
       "Properties",
       "Which properties are shown.",
       {{"section", kText, true, "pose, poses, region, scene, project, problems",
         "pose poses region scene project problems"}},
       ChooseSection},
      {"view.sheet",
       "Dope sheet or graph editor",
       "Which of them is below the viewport.",
       {{"graph", kYesNo, false, "not given: the other one"}},
       ChooseSheet},
      {"sheet.move", "Move keys", "Moves the selected keys with the mouse.", {}, sheet::MoveKeys},
      {"sheet.duplicate",
       "Duplicate keys",
       "Copies the selected keys and moves the copies with the mouse.",
       {},
       sheet::DuplicateKeys},
      {"sheet.scale",
       "Scale keys",
       "Stretches the selected keys about the playhead with the mouse.",
       {},
       sheet::ScaleKeys},
      {"sheet.box", "Box select", "Selects the keys in a rectangle.", {}, sheet::BoxSelect},
      {"sheet.select_all",
       "Select all keys shown",
       "Selects the keys of all rows or curves that are shown.",
       {},
       sheet::SelectAll},
      {"sheet.delete",
       "Delete",
       "Takes the selected keys away; without any, the bar that was clicked.",
       {},
       sheet::Delete},
      {"sheet.mute",
       "Mute or unmute",
       "Lets the region whose bar was clicked act no more, or act again.",
       {},
       sheet::Mute},
      {"sheet.mark_region",
       "Mark dynamics region",
       "Paints a region over rows and frames, or marks the selected joints.",
       {},
       sheet::MarkRegion},
      {"sheet.rename",
       "Rename marker or region",
       "Opens the name of the marker on the current frame, or else of the region whose bar was"
       " clicked.",
       {},
       sheet::Rename},
      {"sheet.preview",
       "Preview range",
       "Sets the frames that are played with the mouse.",
       {},
       sheet::PreviewRange},
      {"sheet.open",
       "Choose for keys",
       "Opens the choice of interpolation, handles or key type.",
       {{"popup", kText, true, "interpolation, handles or key_type",
         "interpolation handles key_type"}},
       sheet::Open},
      {"sheet.only_selected",
       "Only selected",
       "Shows the rows of the selected joints alone, or all.",
       {},
       sheet::OnlySelected},
      {"span.pin",
       "Pin figure from here",
       "The selected joint stays where it is from the current frame on; the figure turns about it.",
       {},
       span::Pin},
      {"span.gravity",
       "Place by gravity from here",
       "Gravity and contact place the figure from the current frame on.",
       {},
       span::Gravity},
      {"span.hold",
       "Hold joint from here",
       "Inverse kinematics keeps the selected joint where it is from the current frame on.",
       {},
       span::Hold},
      {"sheet.frame_all", "Show all frames", "Shows the whole animation.", {}, sheet::FrameAll},
      {"sheet.frame_selected",
       "Show selected keys",
       "Shows the selected keys as large as can be.",
       {},
       sheet::FrameSelected},
  };
  static const std::vector<Action> all = [] {
    std::vector<Action> together = actions;
    for (auto&& list : {DialogActions(), GraphActions(), KeymapActions(), ObjectActions(),
                        PoseLibraryActions(), SweepActions()}) {
      together.insert(together.end(), list.begin(), list.end());
    }
    return together;
  }();
  return all;
}

const Action* FindAction(const std::string& id) {
  const std::vector<Action>& all = AllActions();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Action& a) { return id == a.id; });
  return found == all.end() ? nullptr : &*found;
}

std::string TextOf(const Error& error, const std::string& id) {
  if (!error.file.empty()) {
    return NameIn(error.file) + (error.place.empty() ? "" : ", " + error.place) + ": " +
           error.message;
  }
  if (!error.place.starts_with(id)) return error.ToString();
  const std::string place = error.place.size() > id.size() ? error.place.substr(id.size() + 1) : "";
  return std::string(LabelOf(id)) + (place.empty() ? "" : " (" + place + ")") + ": " +
         error.message;
}

const char* LabelOf(const std::string& id) {
  if (const Action* action = FindAction(id)) return Tr(action->label);
  const edit::Operator* op = edit::FindOperator(id);
  return op ? Tr(op->label) : "";
}

const char* HelpOf(const std::string& id) {
  if (const Action* action = FindAction(id)) return Tr(action->help);
  const edit::Operator* op = edit::FindOperator(id);
  return op ? Tr(op->help) : "";
}

}  // namespace hazumi::ui
