#include "ui/panels/properties/field_rows.h"

#include "engine/project/checks/joint_names.h"
#include "ui/panels/text/number_text.h"

namespace hazumi::ui {

namespace {

constexpr const char* kNone = "none";

// As many decimals as a step of the field needs, and its unit: "%.3f m".
std::string FormatOf(const Field& field) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(field.step) - 1e-9)));
  return "%." + std::to_string(decimals) + "f" + Suffix(field);
}

}  // namespace

SetItem SetBy(Editor* editor, const char* id, Json item) {
  return [editor, id, item = std::move(item)](Json change, const std::string& drag) {
    change.update(item);
    if (!drag.empty()) change["drag"] = drag;
    editor->Do(id, change);
  };
}

Instead InsteadBy(ProjectSolver solver) {
  if (!solver.step_s) solver.step_s = kDefaultStep;
  if (!solver.tolerance_deg) solver.tolerance_deg = kDefaultToleranceDeg;
  return [solver](const std::string& parameter) { return edit::FieldValue(solver, parameter); };
}

bool FieldRows::IsLeftOut(const Field& field) const {
  return std::find(without_.begin(), without_.end(), ParameterOf(field)) != without_.end();
}

NumberField FieldRows::NumberFieldOf(const Field& field, double value) const {
  NumberField number{ParameterOf(field), Tr(field.label), value};
  number.speed = field.step;
  number.is_slider = field.range == kShare;
  if (field.range == NumberRange()) return number;
  number.lower = field.range.lower;
  number.upper = field.range.upper;
  return number;
}

void FieldRows::operator()(const Field& field, double value) {
  if (IsLeftOut(field)) return;
  const std::string format = FormatOf(field);
  NumberField number = NumberFieldOf(field, value);
  number.format = format.c_str();
  DrawNumber(editor_, number, [&](double wanted, const std::string& drag) {
    set_({{ParameterOf(field), wanted}}, drag);
  });
  Tooltip(Tr(field.help));
}

void FieldRows::operator()(const Field& field, int value) {
  if (IsLeftOut(field)) return;
  DrawInteger(editor_, ParameterOf(field), Tr(field.label), value,
              [&](int wanted, const std::string& drag) {
                const double number = std::max<double>(wanted, field.range.lower);
                set_({{ParameterOf(field), static_cast<int>(number)}}, drag);
              });
  Tooltip(Tr(field.help));
}

void FieldRows::operator()(const Field& field, bool value) {
  if (IsLeftOut(field)) return;
  DrawCheck(editor_, ParameterOf(field), Tr(field.label), value, [&](bool on) {
    set_({{ParameterOf(field), on}}, "");
  });
  Tooltip(Tr(field.help));
}

void FieldRows::operator()(const Field& field, const std::string& value) {
  if (IsLeftOut(field)) return;
  if (field.thing == Thing::kColor) {
    DrawColor(editor_, ParameterOf(field), Tr(field.label), value,
              [&](const std::string& color, const std::string& drag) {
                set_({{ParameterOf(field), color}}, drag);
              });
  } else if (field.thing == Thing::kJoint || field.thing == Thing::kJointOrRoot ||
             field.thing == Thing::kSceneOrHeldObject) {
    DrawThings(field, value);
  } else {
    DrawText(editor_, ParameterOf(field), Tr(field.label), value, [&](const std::string& text) {
      set_({{ParameterOf(field), text}}, "");
    });
  }
}

void FieldRows::operator()(const Field& field, const Vec3& value) {
  if (IsLeftOut(field)) return;
  const std::string format = FormatOf(field);
  for (int i = 0; i < 3; ++i) {
    const char axis = field.axes[i];
    const char* name = edit::NameOfAxis(ParameterOf(field), axis);
    const auto capital = static_cast<char>(std::toupper(static_cast<unsigned char>(axis)));
    const std::string label = (i == 0 ? std::string(Tr(field.label)) + "  " : "") + capital;
    NumberField number = NumberFieldOf(field, value[i]);
    number.id = name;
    number.label = label;
    number.format = format.c_str();
    DrawNumber(editor_, number, [&](double wanted, const std::string& drag) {
      set_({{name, wanted}}, drag);
    });
    Tooltip(Tr(field.help));
  }
}

void FieldRows::DrawThings(const Field& field, const std::string& value) {
  const edit::Session& session = editor_->session();
  const Project& project = session.project();
  std::vector<std::string> names;
  const auto add = [&](const auto& things) {
    for (const auto& thing : things) names.push_back(thing.name);
  };
  const std::string root = NameOfRoot(session.figure());
  if (field.thing == Thing::kJointOrRoot && !root.empty()) names.push_back(root);
  if (field.thing != Thing::kSceneOrHeldObject) {
    add(session.figure().groups());
  } else {
    add(project.scene.objects);
    add(project.held_objects);
  }
  if (!field.may_be_none) return DrawWords(field, names, value);
  if (IsLeftOut(field)) return;
  names.insert(names.begin(), kNone);
  DrawChoice(editor_, ParameterOf(field), Tr(field.label), names, value.empty() ? kNone : value,
             [&](const std::string& name) {
               set_({{ParameterOf(field), name == kNone ? "" : name}}, "");
             });
}

void FieldRows::DrawWords(const Field& field, const std::vector<std::string>& words,
                          const std::string& value) {
  if (IsLeftOut(field)) return;
  DrawChoice(editor_, ParameterOf(field), Tr(field.label), words, value,
             [&](const std::string& word) {
               set_({{ParameterOf(field), word}}, "");
             });
}

}  // namespace hazumi::ui
