#include "ui/panels/actions.h"
#include "ui/panels/panels.h"
#include "ui/panels/widgets.h"

namespace hazumi::ui {

namespace {

// A menu entry that does something.
struct Entry {
  const char* id;  // null: a line
  Json parameters = Json::object();
};

void DrawEntry(Editor* editor, const Entry& entry) {
  if (!entry.id) return ImGui::Separator();
  std::string label = LabelOf(entry.id);
  for (const auto& [name, value] : entry.parameters.items()) {
    if (value.is_string()) label += std::string(": ") + Tr(value.get<std::string>().c_str());
  }
  const std::string key = KeyOf(entry.id, entry.parameters);
  if (ImGui::MenuItem(label.c_str(), key.empty() ? nullptr : key.c_str())) {
    editor->Do(entry.id, entry.parameters);
  }
  Tooltip(HelpOf(entry.id));
}

void DrawMenu(Editor* editor, const char* name, const std::vector<Entry>& entries) {
  if (!ImGui::BeginMenu(Tr(name))) return;
  for (const Entry& entry : entries) DrawEntry(editor, entry);
  ImGui::EndMenu();
}

}  // namespace

void DrawMenuBar(Editor* editor, const Rect&) {
  if (!ImGui::BeginMainMenuBar()) return;
  DrawMenu(editor, "File", {{"file.new"}, {"file.save"}, {nullptr}, {"app.quit"}});
  DrawMenu(editor, "Edit", {{"edit.undo"}, {"edit.redo"}, {nullptr}, {"select.all"}});
  DrawMenu(editor, "View",
           {{"view.side", {{"side", "front"}}},
            {"view.side", {{"side", "right"}}},
            {"view.side", {{"side", "top"}}},
            {"view.orthographic"},
            {"view.camera"},
            {nullptr},
            {"view.sheet"},
            {"view.theme"},
            {"view.language", {{"language", "en"}}},
            {"view.language", {{"language", "ja"}}}});
  DrawMenu(editor, "Pose",
           {{"key.insert"},
            {"pose.copy"},
            {"pose.paste"},
            {"pose.paste", {{"flipped", true}}},
            {"pose.clear"}});
  ImGui::EndMainMenuBar();
}

}  // namespace hazumi::ui
