#include "ui/panels/commands/menus.h"

#include <cmath>
#include <utility>

#include "engine/project/fields/project_fields.h"
#include "engine/project/items.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/sheet/key_kinds.h"
#include "ui/panels/viewport/overlays.h"

namespace hazumi::ui {

namespace {

MenuEntry Line() { return {}; }

MenuEntry Submenu(const char* label, std::vector<MenuEntry> entries) {
  return {nullptr, Json::object(), label, std::move(entries)};
}

MenuEntry FileMenu() {
  return Submenu("File", {{"app.new"},
                          {"file.open_dialog"},
                          {"app.open"},  // drawn as the list of recent files
                          {"file.import_dialog"},
                          Line(),
                          {"app.save"},
                          {"file.save_as"},
                          Line(),
                          {"file.export_dialog"},
                          {"file.sweep_dialog"},
                          {"render.dialog", Json::object(), "Render picture"},
                          {"render.dialog", {{"whole", true}}, "Render animation"},
                          Line(),
                          {"app.quit"}});
}

MenuEntry EditMenu() {
  return Submenu("Edit", {{"edit.undo"},
                          {"edit.redo"},
                          Submenu("Undo history", {}),  // drawn as the list of steps
                          Line(),
                          {"app.search"},
                          {"app.preferences"},
                          Line(),
                          Submenu("Theme", {{"view.theme", {{"dark", true}}, "Dark"},
                                            {"view.theme", {{"dark", false}}, "Light"}}),
                          Submenu("Language", {{"view.language", {{"language", "en"}}, "English"},
                                               {"view.language", {{"language", "ja"}}, "日本語"}}),
                          Submenu("Interface scale", {{"view.scale", {{"scale", 1.0}}, "100 %"},
                                                      {"view.scale", {{"scale", 1.25}}, "125 %"},
                                                      {"view.scale", {{"scale", 1.5}}, "150 %"},
                                                      {"view.scale", {{"scale", 2.0}}, "200 %"}})});
}

MenuEntry OverlayMenu() {
  std::vector<MenuEntry> entries;
  for (const OverlaySwitch& overlay : OverlaySwitches()) {
    entries.push_back({"view.overlay", {{"name", overlay.name}}, overlay.in_menu});
  }
  return Submenu("Overlays", std::move(entries));
}

MenuEntry GhostMenu() {
  const auto within = [](int frames, const char* label) {
    return MenuEntry{"view.ghosts", {{"before", frames}, {"after", frames}}, label};
  };
  return Submenu("Ghosts", {{"view.overlay", {{"name", "ghosts"}}, "Ghosts"},
                            Line(),
                            {"view.ghosts", {{"every", 1}, {"at_keys", false}}, "Every frame"},
                            {"view.ghosts", {{"every", 2}, {"at_keys", false}}, "Every 2 frames"},
                            {"view.ghosts", {{"every", 5}, {"at_keys", false}}, "Every 5 frames"},
                            {"view.ghosts", {{"every", 10}, {"at_keys", false}}, "Every 10 frames"},
                            {"view.ghosts", {{"at_keys", true}}, "At keys"},
                            Line(),
                            within(5, "5 frames before and after"),
                            within(15, "15 frames before and after"),
                            within(30, "30 frames before and after"),
                            within(90, "90 frames before and after")});
}

MenuEntry ViewMenu() {
  return Submenu("View", {{"view.side", {{"side", "front"}}, "From the front"},
                          {"view.side", {{"side", "back"}}, "From the back"},
                          {"view.side", {{"side", "right"}}, "From the right"},
                          {"view.side", {{"side", "left"}}, "From the left"},
                          {"view.side", {{"side", "top"}}, "From above"},
                          Line(),
                          {"view.orthographic"},
                          {"view.camera"},
                          {"view.set_camera"},
                          {"view.frame_selected"},
                          {"view.frame_all"},
                          OverlayMenu(),
                          GhostMenu(),
                          Line(),
                          Submenu("Sheet", {{"view.sheet"},
                                            {"sheet.only_selected"},
                                            {"sheet.normalize"},
                                            {"sheet.torque"},
                                            {"sheet.frame_selected"},
                                            {"sheet.frame_all"}}),
                          Line(),
                          {"time.play"},
                          {"time.to_end", {{"last", false}}, "To the first frame"},
                          {"time.to_end", {{"last", true}}, "To the last frame"},
                          {"time.to_key", {{"next", true}}, "To the next key"},
                          {"time.to_key", {{"next", false}}, "To the previous key"},
                          Line(),
                          {"time.range"},
                          {"time.rate"},
                          {"sheet.preview"},
                          {"time.preview", {{"off", true}}, "No preview range"},
                          {"marker.add", Json::object(), "Add marker"},
                          {"sheet.rename"}});
}

MenuEntry SelectMenu() {
  return Submenu("Select", {{"select.all"},
                            {"select.none"},
                            {"select.mirror"},
                            {"tool.box"},
                            {"select.set"},  // drawn as the list of sets
                            {"select.save_set"},
                            {"select.remove_set"},
                            Line(),
                            {"joint.hide"},
                            {"joint.show_all"},
                            {"joint.lock"},
                            {"joint.lock", {{"on", false}}, "Unlock joints"},
                            Line(),
                            {"sheet.select_all"},
                            {"sheet.box"},
                            {"keys.select_column"},
                            {"keys.select_side", {{"side", "before"}}, "Keys before this frame"},
                            {"keys.select_side", {{"side", "after"}}, "Keys after this frame"}});
}

MenuEntry PoseMenu() {
  return Submenu("Pose", {{"pose.copy"},
                          {"pose.paste"},
                          {"pose.paste", {{"flipped", true}}, "Paste pose flipped"},
                          Line(),
                          {"view.properties", {{"section", "poses"}}, "Pose library"},
                          {"pose.save"},
                          Line(),
                          {"tool.breakdown"},
                          {"tool.relax"},
                          {"tool.push"},
                          {"pose.live_mirror"},
                          Line(),
                          {"tool.rotate"},
                          {"tool.move"},
                          {"pose.clear"},
                          {"root.to_ground"},
                          Line(),
                          {"pose.rotate"},
                          {"pose.reach"},
                          {"pose.swivel"},
                          {"hold.add"},
                          Line(),
                          Submenu("Figure", {{"figure.joint_limits"},
                                             {"figure.link"},
                                             {"figure.role"},
                                             {"figure.embed"},
                                             {"figure.skin", {{"skin", "human"}}, "Human skin"},
                                             {"figure.skin", {{"skin", "none"}}, "No skin"}})});
}

MenuEntry KeyMenu() {
  const auto submenu = [](const char* label, const std::vector<KeyChoice>& choices) {
    std::vector<MenuEntry> entries;
    for (const KeyChoice& choice : choices) {
      if (choice.begins_group) entries.push_back(Line());
      entries.push_back({choice.id, choice.parameters, choice.label});
    }
    return Submenu(label, std::move(entries));
  };
  return Submenu("Key", {{"key.insert"},
                         {"key.delete", Json::object(), "Delete keys of this frame"},
                         {"keys.delete"},
                         Line(),
                         {"keys.copy"},
                         {"keys.paste"},
                         {"sheet.duplicate"},
                         Line(),
                         {"sheet.move"},
                         {"sheet.scale"},
                         Line(),
                         submenu("Interpolation", InterpolationChoices()),
                         submenu("Handles", HandleChoices()),
                         submenu("Key type", KeyTypeChoices()),
                         {"key.rate"},
                         Line(),
                         {"fill.add"}});
}

MenuEntry RegionMenu() {
  return Submenu(
      "Region",
      {{"sheet.mark_region"},
       {"region.add"},
       {"region.set"},
       {"region.add_joints"},
       {"region.remove_joints"},
       {"region.friction"},
       {"region.start_rate"},
       Submenu(
           "Muscle",
           {{"drive.add"}, {"drive.set"}, {"drive.key"}, {"drive.remove_key"}, {"drive.remove"}}),
       {"sheet.mute"},
       {"region.split"},
       {"region.remove"},
       {"region.to_keys"},
       Line(),
       {"motion.stop"},
       {"motion.compute"},
       Line(),
       {"solver.set"}});
}

// Returns entries that the menu of a kind of items has besides.
template <typename Item>
std::vector<MenuEntry> MoreEntries(ItemKind<Item>) {
  return {};
}
std::vector<MenuEntry> MoreEntries(ItemKind<ProjectGoal>) {
  return {{"tool.aim"}, {"goal.aim"}, {"goal.reach"}, {"goal.let_loose"}};
}
std::vector<MenuEntry> MoreEntries(ItemKind<ProjectConstraint>) {
  return {{"tool.hold_on"}, {"constraint.hold_on"}};
}

template <HasTitle Item>
MenuEntry MenuOf(ItemKind<Item> kind) {
  std::vector<MenuEntry> entries;
  if constexpr (HasKind<Item>) {
    static_assert(!kAddLabels<Item>.empty());
    ForEachKind<Item>([&](const Item&, const char* word) {
      entries.push_back({kind.kAdd, {{"kind", word}}, kAddLabels<Item>[entries.size()]});
    });
  } else {
    entries.push_back({kind.kAdd});
  }
  for (MenuEntry& entry : MoreEntries(kind)) entries.push_back(std::move(entry));
  for (const MenuEntry& entry : {Line(), MenuEntry{kind.kSet}, MenuEntry{kind.kRemove}}) {
    entries.push_back(entry);
  }
  return Submenu(kind.kTitle, std::move(entries));
}

MenuEntry SceneMenu() {
  std::vector<MenuEntry> entries = {{"scene.gravity"},
                                    {"tool.add_box"},
                                    {"object.add_box"},
                                    {"object.add_plane"},
                                    {"held.add_ball"},
                                    {"held.add_box"},
                                    {"file.mesh_dialog", Json::object(), "Add mesh"},
                                    {"held.let_go"},
                                    {"held.pass"},
                                    {"held.key"},
                                    {"held.turn"},
                                    {"view.duplicate_object"},
                                    {"object.remove"},
                                    Line()};
  ForEachItemList([&]<typename Item>(ItemKind<Item> kind) {
    if constexpr (HasTitle<Item>) entries.push_back(MenuOf(kind));
  });
  for (MenuEntry& entry : std::vector<MenuEntry>{
           Line(),
           {"tool.throw"},
           {"tool.jump"},
           Submenu("Throw or jump by numbers",
                   {{"throw.add"}, {"held.throw_onto"}, {"jump.add"}, {"jump.aim"}}),
           Line(),
           {"span.pin"},
           {"span.gravity"},
           {"span.hold"},
           {"placement.set"},
           {"placement.flight"},
           Line(),
           {"file.sound_dialog"},
           {"audio.remove"},
           {"file.reference_dialog"},
           {"reference.remove"}}) {
    entries.push_back(std::move(entry));
  }
  return Submenu("Scene", std::move(entries));
}

MenuEntry HelpMenu() {
  return Submenu("Help", {{"help.first_steps"}, {"help.manual"}, Line(), {"help.about"}});
}

void Flatten(const std::vector<MenuEntry>& entries, std::vector<MenuEntry>* flat) {
  for (const MenuEntry& entry : entries) {
    if (entry.id) flat->push_back(entry);
    Flatten(entry.entries, flat);
  }
}

bool NeedsRegion(const std::string& id) {
  return (id.starts_with("region.") && id != "region.add") || id.starts_with("drive.") ||
         id == "sheet.mute";
}

bool NeedsSelectedKeys(const std::string& id) {
  for (const char* tool : {"sheet.move", "sheet.scale", "sheet.duplicate"}) {
    if (id == tool) return true;
  }
  return id.starts_with("keys.") && !id.starts_with("keys.select") && id != "keys.paste";
}

}  // namespace

const std::vector<MenuEntry>& AllMenus() {
  static const std::vector<MenuEntry> menus = {FileMenu(),   EditMenu(),  ViewMenu(),
                                               SelectMenu(), PoseMenu(),  KeyMenu(),
                                               RegionMenu(), SceneMenu(), HelpMenu()};
  return menus;
}

std::vector<MenuEntry> FlatMenus() {
  std::vector<MenuEntry> flat;
  Flatten(AllMenus(), &flat);
  return flat;
}

std::string LabelOf(const MenuEntry& entry) {
  std::string label = entry.label ? Tr(entry.label) : LabelOf(std::string(entry.id));
  const std::string id = entry.id ? entry.id : "";
  const Action* action = FindAction(id);
  const bool asks = action && action->asks;
  if (!id.empty() && (asks || NeedsForm(id, entry.parameters))) label += "...";
  return label;
}

std::string LabelOf(const MenuEntry& entry, const Editor& editor) {
  const std::string id = entry.id ? entry.id : "";
  const edit::Document& document = editor.session().document();
  std::optional<std::string> step;
  if (id == "edit.undo") step = document.undo_label();
  if (id == "edit.redo") step = document.redo_label();
  return LabelOf(entry) + (step ? std::string(": ") + Tr(step->c_str()) : "");
}

bool CanDo(const Editor& editor, const std::string& id) {
  const edit::Session& session = editor.session();
  if (id == "edit.undo") return session.document().undo_label().has_value();
  if (id == "edit.redo") return session.document().redo_label().has_value();
  if (id == "app.save") return !session.document().is_saved() || session.document().path().empty();
  if (id == "select.set" || id == "select.remove_set") {
    return !session.project().selection_sets.empty();
  }
  if (id == "pose.paste") return !session.clipboard().empty();
  if (id == "keys.paste") return !session.key_clipboard().empty();
  if (id == "view.camera") return session.project().camera.has_value();
  if (id == "audio.remove") return session.project().audio.has_value();
  if (id == "reference.remove") return session.project().reference.has_value();
  if (id == "app.open") return !editor.settings.recent_files.empty();
  if (NeedsRegion(id)) return !session.project().regions.empty();
  if (NeedsSelectedKeys(id)) return !session.selected_keys().empty();
  return true;
}

// Whether the ghosts are those that the entry chooses.
bool HasGhosts(const ViewportOverlays& overlays, const Json& p) {
  const bool is_every = !p.contains("every") || p["every"] == overlays.ghost_every;
  const bool is_kind = !p.contains("at_keys") || p["at_keys"] == overlays.ghosts_at_keys;
  const bool is_reach = !p.contains("before") || (p["before"] == overlays.ghosts_before &&
                                                  p["after"] == overlays.ghosts_after);
  return overlays.ghosts && is_every && is_kind && is_reach;
}

std::optional<bool> IsOn(const Editor& editor, const MenuEntry& entry) {
  const std::string id = entry.id ? entry.id : "";
  const Json& p = entry.parameters;
  const Settings& settings = editor.settings;
  if (id == "view.theme") return settings.dark == p.value("dark", !settings.dark);
  if (id == "view.language") {
    return (settings.language == Language::kJapanese) == (p["language"] == "ja");
  }
  if (id == "view.scale") return std::abs(settings.scale - p["scale"].get<double>()) < 1e-6;
  if (id == "view.orthographic") return editor.viewport.camera.is_orthographic;
  if (id == "view.camera") return editor.viewport.through_project_camera;
  if (id == "pose.live_mirror") return editor.mirrors_poses;
  if (id == "help.first_steps") return editor.dialogs.shows_first_steps;
  if (id == "time.play") return editor.playback.is_on();
  if (id == "view.ghosts") return HasGhosts(editor.viewport.overlays, p);
  if (id != "view.overlay") return std::nullopt;
  for (const OverlaySwitch& overlay : OverlaySwitches()) {
    if (p["name"] == overlay.name) return editor.viewport.overlays.*overlay.is_on;
  }
  return std::nullopt;
}

}  // namespace hazumi::ui
