#include "ui/panels/dope_sheet/bar_types.h"

#include <algorithm>

#include "engine/project/edits/holders.h"

namespace hazumi::ui {

std::string TitleOf(const ProjectPlacement& span) {
  const std::string kind = Tr(hazumi::NameOf(span.kind));
  return span.kind == PlacementKind::kPinned ? kind + ": " + span.pin : kind;
}

std::string TitleOf(const ProjectHold& hold) { return std::string(Tr("held")) + ": " + hold.joint; }

namespace {

// Bars of the items of a list of the project.
template <typename Item>
class ListBars : public BarType {
 public:
  ListBars(BarTexts with_texts, std::optional<SrgbColor> with_color, bool thin)
      : BarType({ItemKind<Item>::kThing, with_texts, with_color, thin}) {}

  int Num(const Project& project) const override {
    return static_cast<int>(ItemKind<Item>::In(project).size());
  }
  ItemId Id(const Project& project, int index) const override {
    return At(project, index).identity.id;
  }
  ProjectFrames Frames(const Project& project, int index) const override {
    const Item& item = At(project, index);
    return {item.first_frame, item.last_frame, {}};
  }
  std::string Title(const Project& project, int index) const override {
    return TitleOfItem(At(project, index));
  }
  Result<Done> Edit(Editor* editor, int index, Json change) const override {
    return editor->Invoke(ItemKind<Item>::kSet, Naming(*editor, index, std::move(change)));
  }
  Result<Done> Remove(Editor* editor, int index) const override {
    return editor->Invoke(texts.remove, Naming(*editor, index, Json::object()));
  }

 protected:
  static const Item& At(const Project& project, int index) {
    return ItemKind<Item>::In(project)[static_cast<size_t>(index)];
  }

 private:
  static std::string TitleOfItem(const Item& item) {
    if constexpr (HasUniqueName<Item>) {
      return item.name;
    } else {
      return TitleOf(item);
    }
  }
  // Adds the parameter that says which item is meant.
  static Json Naming(const Editor& editor, int index, Json parameters) {
    if constexpr (HasUniqueName<Item>) {
      parameters[ItemKind<Item>::kParameter] = At(editor.session().project(), index).name;
    } else {
      parameters[ItemKind<Item>::kParameter] = index;
    }
    return parameters;
  }
};

class PlacementBars : public ListBars<ProjectPlacement> {
 public:
  PlacementBars()
      : ListBars({"Move placement", "Stretch placement", "Placement", "placement.remove"},
                 std::nullopt, false) {}

  std::string Details(const Project& project, int index) const override {
    const ProjectPlacement& span = At(project, index);
    if (span.kind == PlacementKind::kKeyed) return Tr("The root's keys place the figure.");
    if (span.kind == PlacementKind::kPinned) return Tr("The figure turns about this joint.");
    std::string flies = Tr("The figure flies until it touches something.");
    if (span.landing_pin.empty()) return flies;
    return flies + "\n" + Tr("Pinned after a landing") + ": " + span.landing_pin;
  }
  BarRows Rows(const Project&, int) const override { return {true, {}, {}}; }
  // Its neighbours give way, so that its index may change. In a drag the operator counts as when
  // that began.
  Result<Done> Edit(Editor* editor, int index, Json change) const override {
    const edit::Document& document = editor->session().document();
    const auto* start = document.drag_start(change.value("drag", ""));
    const ItemId id = Id(document.project(), index);
    change["index"] = IndexOf(id, (start ? start->project : document.project()).placements);
    return editor->Invoke("placement.edit", change);
  }
};

// Who has an object, by index of AllHolders.
class HolderBars : public BarType {
 public:
  HolderBars()
      : BarType(
            {BarKind::kHolder,
             {"Change frames of holder", "Change frames of holder", "Holder", "held.remove_holder"},
             colors::kHeld}) {}

  int Num(const Project& project) const override {
    return static_cast<int>(AllHolders(project).size());
  }
  ItemId Id(const Project& project, int index) const override { return At(project, index).id; }
  ProjectFrames Frames(const Project& project, int index) const override {
    const HolderSpan span = At(project, index);
    return {span.first, span.last, {}};
  }
  std::string Title(const Project& project, int index) const override {
    return At(project, index).joint;
  }
  std::string Details(const Project&, int) const override {
    return Tr("This joint holds it; then it flies.");
  }
  BarRows Rows(const Project& project, int index) const override {
    return {false, {}, {NameOfObject(project, index)}};
  }
  // Its frames; or else its fields, which for the first holder are the object's own.
  Result<Done> Edit(Editor* editor, int index, Json change) const override {
    const Project& project = editor->session().project();
    const HolderSpan span = At(project, index);
    change["object"] = NameOfObject(project, index);
    if (change.contains("first")) {
      change["release"] = change["last"];
      change.erase("last");
      change["number"] = span.number;
      return editor->Invoke("held.set_frames", change);
    }
    if (span.number < 0) return editor->Invoke("held.set", change);
    change["number"] = span.number;
    return editor->Invoke("held.set_holder", change);
  }
  Result<Done> Remove(Editor* editor, int index) const override {
    const Project& project = editor->session().project();
    const HolderSpan span = At(project, index);
    const std::string name = NameOfObject(project, index);
    if (span.number < 0) return editor->Invoke("held.set", {{"object", name}, {"joint", ""}});
    return editor->Invoke(texts.remove, {{"object", name}, {"number", span.number}});
  }

 private:
  static HolderSpan At(const Project& project, int index) {
    return AllHolders(project)[static_cast<size_t>(index)].second;
  }
  static std::string NameOfObject(const Project& project, int index) {
    const int object = AllHolders(project)[static_cast<size_t>(index)].first;
    return project.held_objects[static_cast<size_t>(object)].name;
  }
};

class RegionBars : public ListBars<ProjectRegion> {
 public:
  RegionBars()
      : ListBars({"Move region", "Stretch region", "Dynamics region", "region.remove"},
                 colors::kDynamics, false) {}

  std::string Details(const Project& project, int index) const override {
    const ProjectRegion& region = At(project, index);
    if (region.mute) return Tr("Muted: its joints follow their keys.");
    const ProjectContacts& contacts = region.contacts;
    std::string touches;
    if (contacts.scene) touches += Tr("What it moves stays out of the scene's planes and boxes.");
    if (contacts.scene && contacts.self) touches += "\n";
    if (contacts.self) touches += Tr("What it moves stays out of the own body.");
    return touches;
  }
  BarRows Rows(const Project&, int) const override { return {}; }
};

class HoldBars : public ListBars<ProjectHold> {
 public:
  HoldBars()
      : ListBars({"Move hold", "Stretch hold", "Held joint", "hold.remove"}, colors::kHeld, true) {}

  std::string Details(const Project& project, int index) const override {
    return Tr(At(project, index).orientation
                  ? "Inverse kinematics keeps it in its place and turned as it is."
                  : "Inverse kinematics keeps it in its place.");
  }
  BarRows Rows(const Project& project, int index) const override {
    return {false, {At(project, index).joint}, {}};
  }
};

class ConstraintBars : public ListBars<ProjectConstraint> {
 public:
  ConstraintBars()
      : ListBars({"Move constraint", "Stretch constraint", "Constraint", "constraint.remove"},
                 colors::kHeld, true) {}

  std::string Details(const Project& project, int index) const override {
    const ProjectConstraint& constraint = At(project, index);
    return std::string(Tr(hazumi::NameOf(constraint.kind))) + ": " + NameOfEnd(constraint.a) +
           " - " + NameOfEnd(constraint.b);
  }
  BarRows Rows(const Project& project, int index) const override {
    BarRows rows;
    for (const ProjectConstraintEnd& end : {At(project, index).a, At(project, index).b}) {
      if (!end.joint.empty()) rows.joints.push_back(end.joint);
      if (!end.object.empty()) rows.objects.push_back(end.object);
    }
    return rows;
  }

 private:
  static std::string NameOfEnd(const ProjectConstraintEnd& end) {
    if (!end.joint.empty()) return end.joint;
    return end.object.empty() ? Tr("the world") : end.object;
  }
};

class FillBars : public ListBars<ProjectFill> {
 public:
  FillBars()
      : ListBars({"Move fill", "Stretch fill", "Fill", "fill.remove"}, colors::kGenerated, true) {}

  std::string Details(const Project&, int) const override {
    return Tr("Filled in between your keys; made anew when they change.");
  }
  BarRows Rows(const Project&, int) const override { return {}; }
};

}  // namespace

const std::vector<const BarType*>& AllBarTypes() {
  static const PlacementBars placements;
  static const HolderBars holders;
  static const RegionBars regions;
  static const HoldBars holds;
  static const ConstraintBars constraints;
  static const FillBars fills;
  static const std::vector<const BarType*> all = {&placements, &holders,     &regions,
                                                  &holds,      &constraints, &fills};
  return all;
}

const BarType& TypeOf(BarKind kind) {
  const auto& all = AllBarTypes();
  return **std::find_if(all.begin(), all.end(),
                        [&](const BarType* type) { return type->kind == kind; });
}

}  // namespace hazumi::ui
