#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

#include "ui/edit/fields/item_fields.h"
#include "ui/panels/properties/fields.h"

namespace hazumi::ui {

// What is set of an item, by the names of its parameters, and the drag that it belongs to.
using SetItem = std::function<void(const Json& change, const std::string& drag)>;

// By an operator that needs nothing but what is set, and what names the item.
SetItem SetBy(Editor* editor, const char* id, Json item = Json::object());

// What is used in place of a field that the item may leave out and does, by its parameter; null:
// there is nothing to show.
using Instead = std::function<Json(const std::string& parameter)>;

// Of regions and the project: what the solver is, its defaults put in.
Instead InsteadBy(ProjectSolver solver);

// Rows for an item's fields, one a field, as their descriptions say (engine/project/fields).
class FieldRows {
 public:
  FieldRows(Editor* editor, std::vector<std::string> without, SetItem set, Instead instead)
      : editor_(editor),
        without_(std::move(without)),
        set_(std::move(set)),
        instead_(std::move(instead)) {}

  void operator()(const Field& field, double value);
  void operator()(const Field& field, int value);
  void operator()(const Field& field, bool value);
  void operator()(const Field& field, const std::string& value);
  void operator()(const Field& field, const Vec3& value);
  template <FileEnum Enum>
  void operator()(const Field& field, Enum value) {
    DrawWords(field, edit::WordsOf(edit::Offer(edit::WordsOf<Enum>())), hazumi::NameOf(value));
  }
  template <typename T>
  void operator()(const Field& field, const std::optional<T>& value) {
    if (value) return (*this)(field, *value);
    const Json other = instead_ ? instead_(ParameterOf(field)) : Json();
    if (!other.is_null()) (*this)(field, edit::FromJson<T>(other));
  }
  // The panel draws joints in a way of their own.
  void operator()(const Field&, const std::vector<JointRef>&) {}

 private:
  bool IsLeftOut(const Field& field) const;
  NumberField NumberFieldOf(const Field& field, double value) const;
  void DrawThings(const Field& field, const std::string& value);
  void DrawWords(const Field& field, const std::vector<std::string>& words,
                 const std::string& value);

  Editor* editor_;
  std::vector<std::string> without_;
  SetItem set_;
  Instead instead_;
};

// All rows but those of the parameters in `without`, which the panel draws in a way of their own.
template <typename T>
void DrawFieldRows(Editor* editor, const T& item, std::vector<std::string> without, SetItem set,
                   Instead instead = {}) {
  FieldRows rows(editor, std::move(without), std::move(set), std::move(instead));
  edit::ForEachField(item, [&](const Field& field, const auto& value) { rows(field, value); });
}

// The rows of these parameters.
template <typename T>
void DrawRowsOf(const std::vector<std::string>& parameters, Editor* editor, const T& item,
                SetItem set, Instead instead = {}) {
  FieldRows rows(editor, {}, std::move(set), std::move(instead));
  edit::ForEachField(item, [&](const Field& field, const auto& value) {
    const auto found = std::find(parameters.begin(), parameters.end(), ParameterOf(field));
    if (found != parameters.end()) rows(field, value);
  });
}

}  // namespace hazumi::ui
