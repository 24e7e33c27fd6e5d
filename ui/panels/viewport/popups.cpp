// Small windows over the viewport: what can be done with a joint, the root, an object or the view,
// and what can be added.

#include "ui/panels/viewport/popups.h"

#include <algorithm>

#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/dope_sheet/bar_tools.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

// Things to do, in groups that lines part.
using Items = std::vector<std::vector<MenuEntry>>;

std::vector<std::string> SelectedJointNames(const edit::Session& session) {
  std::vector<std::string> names;
  for (const GroupIndex joint : SelectedJoints(session)) {
    names.push_back(session.figure().group(joint).name);
  }
  return names;
}

// A region of the joints with all that is beyond them.
Json RegionOutwards(const edit::Session& session) {
  Json joints = Json::array();
  for (const std::string& name : SelectedJointNames(session)) joints.push_back(name + "+");
  if (session.is_root_selected()) joints.push_back(session.figure().root_name() + "+");
  const ProjectFrames frames = FramesToMark(session);
  return {{"first", frames.first},
          {"last", frames.last},
          {"joints", joints},
          {"contacts", TouchesWhenMade(session.project())}};
}

Items JointItems(const edit::Session& session) {
  return {{{"key.insert"}, {"key.delete"}},
          {{"tool.rotate"}, {"tool.move"}, {"pose.clear"}},
          {{"region.add", RegionOutwards(session), "Dynamics region from here outwards"},
           {"span.hold"},
           {"span.pin"},
           {"tool.hold_on"},
           {"tool.aim"},
           {"held.add_ball"}},
          {{"select.mirror"}, {"joint.hide"}, {"joint.lock"}},
          {{"view.frame_selected"}, {"view.properties", {{"section", "pose"}}, "Properties"}}};
}

Items RootItems(const edit::Session& session) {
  return {{{"key.insert"}, {"key.delete"}},
          {{"tool.move"}, {"tool.rotate"}, {"root.to_ground"}, {"tool.jump"}},
          {{"region.add", RegionOutwards(session), "Dynamics region from here outwards"},
           {"span.gravity"}},
          {{"joint.hide"}},
          {{"view.frame_selected"}, {"view.properties", {{"section", "pose"}}, "Properties"}}};
}

Items ObjectItems(const Editor& editor) {
  const Json object = {{"object", NameOfSelectedObject(editor)}};
  std::vector<MenuEntry> own = {{"tool.move"}};
  if (SelectedHeldObject(editor)) {
    own.push_back({"tool.rotate"});
    for (const char* id : {"held.let_go", "held.pass", "held.key"}) own.push_back({id, object});
    own.push_back({"tool.throw"});
  } else {
    own.push_back({"view.duplicate_object"});
  }
  return {own,
          {{"view.remove_object"}},
          {{"view.frame_selected"}, {"view.properties", {{"section", "scene"}}, "Properties"}}};
}

Items EmptyItems() {
  return {{{"select.all"}, {"select.none"}, {"tool.box"}},
          {{"tool.add_box"}},
          {{"joint.show_all"}},
          {{"view.frame_selected"}, {"view.frame_all"}, {"view.orthographic"}, {"view.camera"}}};
}

Items AddItems() {
  return {{{"held.add_ball"}, {"held.add_box"}, {"file.mesh_dialog", Json::object(), "Add mesh"}},
          {{"tool.add_box"}, {"object.add_box"}, {"object.add_plane"}}};
}

Items ItemsOf(ViewportPopup popup, const Editor& editor) {
  switch (popup) {
    case ViewportPopup::kJoint:
      return JointItems(editor.session());
    case ViewportPopup::kRoot:
      return RootItems(editor.session());
    case ViewportPopup::kObject:
      return ObjectItems(editor);
    case ViewportPopup::kAdd:
      return AddItems();
    case ViewportPopup::kNothing:
    case ViewportPopup::kNone:
      break;
  }
  return EmptyItems();
}

// What it is about.
std::string TitleOf(ViewportPopup popup, const Editor& editor) {
  if (popup == ViewportPopup::kRoot) return editor.session().figure().root_name();
  if (popup == ViewportPopup::kObject) return NameOfSelectedObject(editor);
  if (popup == ViewportPopup::kAdd) return Tr("Add");
  if (popup != ViewportPopup::kJoint) return "";
  const std::vector<std::string> names = SelectedJointNames(editor.session());
  if (names.empty()) return "";
  return names.size() == 1 ? names[0] : names[0] + " +" + std::to_string(names.size() - 1);
}

void DrawItem(Editor* editor, const MenuEntry& entry) {
  const std::string key = KeyOf(entry.id, entry.parameters);
  if (ImGui::MenuItem(LabelOf(entry).c_str(), key.empty() ? nullptr : key.c_str(), false,
                      CanDo(*editor, entry.id))) {
    (void)RunOrAsk(editor, entry.id, entry.parameters);  // the status bar says what is refused
  }
  Tooltip(HelpOf(entry.id));
}

ViewportPopup PopupOf(const ViewportHit& hit) {
  if (hit.joint) return ViewportPopup::kJoint;
  if (hit.is_root) return ViewportPopup::kRoot;
  return hit.object.is_valid() ? ViewportPopup::kObject : ViewportPopup::kNothing;
}

const char* IdOf(ViewportPopup popup) {
  constexpr const char* kIds[] = {"", "##joint", "##root", "##object", "##nothing", "##add"};
  return kIds[static_cast<int>(popup)];
}

}  // namespace

static std::vector<MenuEntry> Flat(const Items& items) {
  std::vector<MenuEntry> all;
  for (const std::vector<MenuEntry>& group : items) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

std::vector<MenuEntry> ItemsAt(const Editor& editor, const ViewportHit& hit) {
  return Flat(ItemsOf(PopupOf(hit), editor));
}

std::vector<MenuEntry> ItemsToAdd() { return Flat(AddItems()); }

void OpenViewportPopup(Editor* editor, const ViewportHit& hit) {
  const edit::Session& session = editor->session();
  const Figure& figure = session.figure();
  const std::vector<GroupIndex> selected = SelectedJoints(session);
  const bool is_joint_selected =
      hit.joint && std::find(selected.begin(), selected.end(), *hit.joint) != selected.end();
  if (hit.joint && !is_joint_selected) {
    editor->Do("select.joints", {{"joints", {figure.group(*hit.joint).name}}});
  }
  if (hit.is_root && !session.is_root_selected()) {
    editor->Do("select.joints", {{"joints", {figure.root_name()}}});
  }
  if (hit.object.is_valid()) {
    editor->Do("select.joints", {{"joints", Json::array()}});
    SelectObject(editor, hit.object);
  }
  editor->viewport.popup = PopupOf(hit);
}

void DrawViewportPopups(Editor* editor) {
  using enum ViewportPopup;
  ViewportPopup& wanted = editor->viewport.popup;
  if (wanted != kNone) ImGui::OpenPopup(IdOf(wanted));
  wanted = kNone;
  for (const ViewportPopup popup : {kJoint, kRoot, kObject, kNothing, kAdd}) {
    if (!ImGui::BeginPopup(IdOf(popup))) continue;
    const std::string title = TitleOf(popup, *editor);
    if (!title.empty()) ImGui::TextDisabled("%s", title.c_str());
    bool is_first = title.empty();
    for (const std::vector<MenuEntry>& group : ItemsOf(popup, *editor)) {
      if (!is_first) ImGui::Separator();
      is_first = false;
      for (const MenuEntry& entry : group) DrawItem(editor, entry);
    }
    ImGui::EndPopup();
  }
}

}  // namespace hazumi::ui
