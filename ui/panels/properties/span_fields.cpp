#include <functional>

#include "engine/project/edits/holders.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/properties/field_rows.h"
#include "ui/panels/properties/sections.h"

namespace hazumi::ui {

namespace {

constexpr const char* kNoJoint = "nearest";  // to where it touches

// What is refused the status bar says.
void Set(Editor* editor, const Json& change) { (void)EditChosenBar(editor, change); }

std::vector<std::string> JointsOf(const Editor& editor) {
  std::vector<std::string> names;
  for (const JointGroup& joint : editor.session().figure().groups()) names.push_back(joint.name);
  return names;
}

// A joint; without one it is the nearest to where the figure touches something.
void DrawMaybeJoint(Editor* editor, const char* id, const char* label, const std::string& now) {
  std::vector<std::string> names = JointsOf(*editor);
  names.insert(names.begin(), kNoJoint);
  DrawChoice(editor, id, label, names, now.empty() ? kNoJoint : now, [&](const std::string& name) {
    Set(editor, {{id, name == kNoJoint ? "" : name}});
  });
}

void DrawJoint(Editor* editor, const char* id, const std::string& now) {
  DrawChoice(editor, id, Tr("Joint"), JointsOf(*editor), now, [&](const std::string& name) {
    Set(editor, {{id, name}});
  });
}

// A span that becomes pinned is so by the joint it has, or the one it lands on, or the first one.
Json OfKind(const Editor& editor, const std::string& kind, const ProjectPlacement& span) {
  Json change = {{"kind", kind}};
  if (kind != "pinned" || !span.pin.empty()) return change;
  change["pin"] = span.landing_pin.empty() ? JointsOf(editor).front() : span.landing_pin;
  return change;
}

void DrawPlacement(Editor* editor, const ProjectPlacement& span) {
  DrawChoice(editor, "kind", Tr("Kind"), {"pinned", "gravity"}, hazumi::NameOf(span.kind),
             [&](const std::string& kind) { Set(editor, OfKind(*editor, kind, span)); });
  if (span.kind == PlacementKind::kPinned) DrawJoint(editor, "pin", span.pin);
  if (span.kind != PlacementKind::kGravity) return;
  DrawMaybeJoint(editor, "pin", Tr("Stands on"), span.pin);
  DrawMaybeJoint(editor, "landing_pin", Tr("Lands on"), span.landing_pin);
}

}  // namespace

void DrawSpanFields(Editor* editor) {
  // Copies: what is done below changes the lists.
  const Project& project = editor->session().project();
  const std::optional<BarRef> bar = ChosenBar(project, editor->sheet);
  if (!bar || bar->kind == BarKind::kRegion) return;
  const auto set = [editor](Json change, const std::string& drag) {
    if (!drag.empty()) change["drag"] = drag;
    Set(editor, change);
  };
  if (bar->kind == BarKind::kHolder) {
    const auto [index, span] = AllHolders(project)[bar->index];
    const ProjectHeldObject object = project.held_objects[index];
    if (span.number >= 0) {
      return DrawFieldRows(editor, ProjectHolder(object.holders[span.number]), {}, set);
    }
    return DrawRowsOf({"joint", "offset_?", "angle_?", "release"}, editor, object, set);
  }
  if (bar->kind == BarKind::kPlacement) {
    const ProjectPlacement span = project.placements[bar->index];
    DrawPlacement(editor, span);
    return DrawFieldRows(editor, span, {"kind", "pin", "landing_pin"}, set);
  }
  std::function<void()> draw;
  ForEachItemList(
      [&]<typename Item>(ItemKind<Item> kind, const std::vector<Item>& items) {
        if constexpr (SpanItem<Item>) {
          if (kind.kThing != bar->kind) return;
          draw = [=, item = items[bar->index]] { DrawFieldRows(editor, item, {}, set); };
        }
      },
      project);
  if (draw) draw();
}

}  // namespace hazumi::ui
