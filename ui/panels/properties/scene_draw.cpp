// The scene: what places the figure, objects, gravity and the camera.

#include <algorithm>
#include <cmath>

#include "engine/project/edits/holders.h"
#include "engine/project/fields/project_fields.h"
#include "engine/project/items.h"
#include "ui/edit/operators/edits.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/properties/field_rows.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/properties/sections.h"
#include "ui/panels/sheet/drag.h"

namespace hazumi::ui {

namespace {

// A line of a list that a click chooses, with a button that takes it away; below it the fields of
// the chosen one. False if it was taken away.
bool DrawSpan(Editor* editor, const BarRef& bar) {
  const Project& project = editor->session().project();
  const ProjectFrames frames = FramesOf(project, bar);
  const std::string text = SpanText(frames.first, frames.last) + "   " + TitleOf(project, bar);
  const std::optional<BarRef> chosen = ChosenBar(project, editor->sheet);
  const bool is_chosen = chosen && *chosen == bar;
  ImGui::PushID(bar.index);
  const float button = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetContentRegionAvail().x - button - gap;
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0f, 0.5f});
  if (ImGui::Selectable(text.c_str(), is_chosen, 0, {room, button})) ChooseBar(editor, bar);
  ImGui::PopStyleVar();
  Tooltip(DetailsOf(project, bar));
  ImGui::SameLine(0.0f, gap);
  const bool is_removed = ImGui::Button("×", {button, 0.0f});
  Tooltip(Tr("Remove"));
  if (is_removed) {
    ChooseBar(editor, bar);
    (void)RemoveChosenBar(editor);
  } else if (is_chosen) {
    DrawSpanFields(editor);
  }
  ImGui::PopID();
  return !is_removed;
}

// Stops when the list is another one.
void DrawSpans(Editor* editor, BarKind kind, size_t count) {
  const long revision = editor->session().document().revision();
  for (size_t i = 0; i < count; ++i) {
    if (!DrawSpan(editor, {kind, static_cast<int>(i)})) return;
    if (editor->session().document().revision() != revision) return;
  }
}

void DrawPlacement(Editor* editor) {
  if (!DrawHeading(Tr("Placement"))) return;
  ImGui::PushID("placement");
  const size_t count = editor->session().project().placements.size();
  DrawSpans(editor, BarKind::kPlacement, count);
  ImGui::PopID();
  if (count == 0) DrawNote(Tr("The root's keys place the figure."));
  if (DrawButton(Tr("Pin from here"), HelpOf("span.pin"), 2)) editor->Do("span.pin");
  ImGui::SameLine();
  if (DrawButton(Tr("Gravity from here"), HelpOf("span.gravity"), 2)) editor->Do("span.gravity");
}

void DrawHolds(Editor* editor) {
  if (!DrawHeading(Tr("Holds"), !editor->session().project().holds.empty())) return;
  ImGui::PushID("holds");
  DrawSpans(editor, BarKind::kHold, editor->session().project().holds.size());
  ImGui::PopID();
  if (DrawButton(Tr("Hold from here"), HelpOf("span.hold"))) editor->Do("span.hold");
}

// What was selected in the viewport opens once, and what was added.
bool ObjectNode(Editor* editor, const std::string& name, ItemId id) {
  const bool is_selected = editor->viewport.selected_object == id;
  if (is_selected && editor->side.shown_object != id) ImGui::SetNextItemOpen(true);
  if (is_selected) editor->side.shown_object = id;
  if (editor->side.added == id) {
    ImGui::SetNextItemOpen(true);
    editor->side.added = ItemId();
  }
  return ImGui::TreeNodeEx(name.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth |
                                             ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                             (is_selected ? ImGuiTreeNodeFlags_Selected : 0));
}

// Of a list whose heading opens where something was added to it.
template <typename Items>
bool DrawHeadingOf(const Editor& editor, const char* title, const Items& items) {
  if (IndexOf(editor.side.added, items) >= 0) ImGui::SetNextItemOpen(true);
  return DrawHeading(title, !items.empty());
}

// Draws buttons of operators that do something with an item. Returns whether one of them ran.
template <typename Item>
bool DrawDeeds(Editor*, const Item&) {
  return false;
}
bool DrawDeeds(Editor* editor, const ProjectGoal& goal) {
  const bool is_wanted = DrawButton(LabelOf("goal.aim"), HelpOf("goal.aim"));
  if (is_wanted) editor->Do("goal.aim", {{"goal", goal.name}});
  return is_wanted;
}

// Draws buttons for fields that an item may leave out. Returns whether one of them changed it.
template <typename Item>
bool DrawOffers(const Item&, const SetItem&) {
  return false;
}
bool DrawOffers(const ProjectConstraint& constraint, const SetItem& set) {
  const auto offer = [&](const char* label, const char* help, const Json& change, int share) {
    const bool is_wanted = DrawButton(label, help, share);
    if (is_wanted) set(change, "");
    return is_wanted;
  };
  const bool closes = constraint.arrive_frames.has_value();
  const bool breaks = constraint.break_force_n || constraint.break_impulse_n_s;
  if (closes ? offer(Tr("No gap"), Tr("true: there is no gap that has to close"),
                     {{"no_gap", true}}, 1)
             : offer(Tr("Close gap"), Tr("a gap closes to 1 % in so many frames"), {{"arrive", 5}},
                     1)) {
    return true;
  }
  if (breaks) {
    return offer(Tr("Unbreakable"), Tr("true: nothing breaks it"), {{"unbreakable", true}}, 1);
  }
  if (offer(Tr("Breaks by force"), Tr("it breaks under more, and is gone from then on"),
            {{"break_force", 1000.0}}, 2)) {
    return true;
  }
  ImGui::SameLine();
  return offer(Tr("Breaks by impulse"),
               Tr("it breaks under a greater one, and is gone from then on"),
               {{"break_impulse", 20.0}}, 2);
}

// One of a list whose items have names.
template <typename Item>
void DrawItem(Editor* editor, const Item& item, const char* remove) {
  const Json named = {{ItemKind<Item>::kParameter, item.name}};
  ImGui::PushID(item.name.c_str());
  if (ObjectNode(editor, item.name, item.identity.id)) {
    const SetItem set = SetBy(editor, ItemKind<Item>::kSet, named);
    DrawFieldRows(editor, item, {}, set);
    if (!DrawDeeds(editor, item) && !DrawOffers(item, set) &&
        DrawButton(Tr("Remove"), HelpOf(remove))) {
      editor->Do(remove, named);
    }
  }
  ImGui::PopID();
}

void DrawObjects(Editor* editor) {
  if (!DrawHeading(Tr("Objects"))) return;
  const ProjectScene scene = editor->session().project().scene;
  for (const ProjectSceneObject& object : scene.objects) DrawItem(editor, object, "object.remove");
  if (DrawButton(LabelOf("tool.add_box"), HelpOf("tool.add_box"), 2)) {
    (void)editor->Invoke("tool.add_box");
  }
  ImGui::SameLine();
  if (DrawButton(LabelOf("object.add_plane"), HelpOf("object.add_plane"), 2)) {
    editor->Do("object.add_plane",
               {{"name", FreeObjectName("plane", editor->session().project())}});
  }
  DrawFieldRows(editor, scene, {}, SetBy(editor, "scene.gravity"));
}

// When it is let go, if ever.
void DrawRelease(Editor* editor, const ProjectHeldObject& object, const SetItem& set) {
  const int now = static_cast<int>(std::lround(editor->session().frame()));
  DrawCheck(editor, "is released", Tr("Let go"), object.release_frame.has_value(), [&](bool on) {
    set(on ? Json{{"release", now}} : Json{{"never", true}}, "");
  });
  if (!object.release_frame) return;
  DrawInteger(editor, "release", Tr("Release frame"), *object.release_frame,
              [&](int frame, const std::string& drag) {
                set({{"release", frame}}, drag);
              });
}

// Who has it later, and what can be done in the current frame.
void DrawHolders(Editor* editor, const ProjectHeldObject& object) {
  const long revision = editor->session().document().revision();
  const auto all = AllHolders(editor->session().project());
  for (size_t i = 0; i < all.size(); ++i) {
    const auto& [of, span] = all[i];
    if (span.number < 0 || editor->session().project().held_objects[of].name != object.name)
      continue;
    if (!DrawSpan(editor, {BarKind::kHolder, static_cast<int>(i)})) return;
    if (editor->session().document().revision() != revision) return;
  }
  const Json of = {{"object", object.name}};
  if (DrawButton(LabelOf("held.let_go"), HelpOf("held.let_go"), 2)) editor->Do("held.let_go", of);
  ImGui::SameLine();
  if (DrawButton(LabelOf("held.pass"), HelpOf("held.pass"), 2)) editor->Do("held.pass", of);
  if (DrawButton(LabelOf("held.key"), HelpOf("held.key"), 2)) editor->Do("held.key", of);
  ImGui::SameLine();
  if (DrawButton(Tr("Remove"), HelpOf("held.remove"), 2)) editor->Do("held.remove", of);
}

void DrawHeldObject(Editor* editor, const ProjectHeldObject& object) {
  ImGui::PushID(object.name.c_str());
  if (ObjectNode(editor, object.name, object.identity.id)) {
    const SetItem set = SetBy(editor, "held.set", {{"object", object.name}});
    DrawFieldRows(editor, object, {"release"}, set);
    if (!object.joint.empty()) DrawRelease(editor, object, set);
    DrawHolders(editor, object);
  }
  ImGui::PopID();
}

void DrawHeldObjects(Editor* editor) {
  if (!DrawHeading(Tr("Held objects"))) return;
  // A copy: what is done below changes the list.
  const std::vector<ProjectHeldObject> held = editor->session().project().held_objects;
  ImGui::PushID("held");
  for (const ProjectHeldObject& object : held) DrawHeldObject(editor, object);
  if (DrawButton(LabelOf("held.add_ball"), HelpOf("held.add_ball"), 2)) editor->Do("held.add_ball");
  ImGui::SameLine();
  if (DrawButton(LabelOf("held.add_box"), HelpOf("held.add_box"), 2)) editor->Do("held.add_box");
  ImGui::PopID();
}

template <typename Item>
void DrawAddButtons(Editor* editor) {
  const char* const add = ItemKind<Item>::kAdd;
  if constexpr (HasKind<Item>) {
    static_assert(!kAddLabels<Item>.empty());
    constexpr size_t kInARow = 3;
    size_t i = 0;
    ForEachKind<Item>([&](const Item&, const char* kind) {
      if (i % kInARow > 0) ImGui::SameLine();
      if (DrawButton(Tr(kAddLabels<Item>[i++]), HelpOf(add), kInARow)) {
        editor->Do(add, {{"kind", kind}});
      }
    });
  } else if (DrawButton(LabelOf(add), HelpOf(add))) {
    editor->Do(add);
  }
}

template <HasTitle Item>
void DrawList(Editor* editor) {
  using Kind = ItemKind<Item>;
  // A copy: what is done below changes the list.
  const std::vector<Item> items = Kind::In(editor->session().project());
  if (!DrawHeadingOf(*editor, Tr(Kind::kTitle), items)) return;
  ImGui::PushID(Kind::kList);
  for (const Item& item : items) DrawItem(editor, item, Kind::kRemove);
  DrawAddButtons<Item>(editor);
  ImGui::PopID();
}

void DrawCamera(Editor* editor) {
  if (!DrawHeading(Tr("Camera"), false)) return;
  const std::optional<ProjectCamera> camera = editor->session().project().camera;
  if (camera) {
    DrawFieldRows(editor, *camera, {}, SetBy(editor, "camera.set"));
  } else {
    DrawNote(Tr("The project has no camera of its own: pictures are framed by themselves."));
  }
  if (DrawButton(Tr("Set from view"), HelpOf("view.set_camera"))) editor->Do("view.set_camera");
}

// What has a file: its fields, and what chooses and removes it.
template <typename Item>
void DrawMedia(Editor* editor, const std::optional<Item>& item, const char* set, const char* choose,
               const char* remove) {
  if (item) DrawFieldRows(editor, *item, {}, SetBy(editor, set));
  if (DrawButton(LabelOf(choose), HelpOf(choose), item ? 2 : 1)) editor->Do(choose);
  if (!item) return;
  ImGui::SameLine();
  if (DrawButton(Tr("Remove"), HelpOf(remove), 2)) editor->Do(remove);
}

void DrawSound(Editor* editor) {
  if (!DrawHeading(Tr("Sound"), false)) return;
  const std::optional<ProjectAudio> audio = editor->session().project().audio;
  DrawMedia(editor, audio, "audio.set", "file.sound_dialog", "audio.remove");
}

void DrawReference(Editor* editor) {
  if (!DrawHeading(Tr("Reference"), false)) return;
  const std::optional<ProjectReference> reference = editor->session().project().reference;
  DrawMedia(editor, reference, "reference.set", "file.reference_dialog", "reference.remove");
  const std::string error = editor->film.error();
  if (!error.empty()) ImGui::TextWrapped("%s", error.c_str());
}

}  // namespace

void DrawSceneSection(Editor* editor) {
  DrawPlacement(editor);
  DrawHolds(editor);
  DrawObjects(editor);
  DrawHeldObjects(editor);
  ForEachItemList([&]<typename Item>(ItemKind<Item>) {
    if constexpr (HasTitle<Item>) DrawList<Item>(editor);
  });
  DrawCamera(editor);
  DrawSound(editor);
  DrawReference(editor);
}

}  // namespace hazumi::ui
