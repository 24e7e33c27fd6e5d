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

// Rows for an item's fields, one a field, as their descriptions say (engine/project/fields).
class FieldRows {
 public:
  FieldRows(Editor* editor, std::vector<std::string> without, SetItem set)
      : editor_(editor), without_(std::move(without)), set_(std::move(set)) {}

  void operator()(const Field& field, double value);
  void operator()(const Field& field, int value);
  void operator()(const Field& field, bool value);
  void operator()(const Field& field, const std::string& value);
  void operator()(const Field& field, const Vec3& value);
  template <FileEnum Enum>
  void operator()(const Field& field, Enum value) {
    DrawWords(field, edit::WordsOf(edit::Offer(edit::WordsOf<Enum>())), hazumi::NameOf(value));
  }
  // What may be missing is taken from somewhere else then: its panel draws it. So are joints.
  template <typename T>
  void operator()(const Field&, const std::optional<T>&) {}
  void operator()(const Field&, const std::vector<JointRef>&) {}

 private:
  bool IsLeftOut(const Field& field) const;
  NumberField NumberFieldOf(const Field& field, double value) const;
  void DrawWords(const Field& field, const std::vector<std::string>& words,
                 const std::string& value);

  Editor* editor_;
  std::vector<std::string> without_;
  SetItem set_;
};

// All rows but those of the parameters in `without`, which the panel draws in a way of their own.
template <typename T>
void DrawFieldRows(Editor* editor, const T& item, std::vector<std::string> without, SetItem set) {
  FieldRows rows(editor, std::move(without), std::move(set));
  edit::ForEachField(item, [&](const Field& field, const auto& value) { rows(field, value); });
}

// The row of one parameter.
template <typename T>
void DrawFieldRow(Editor* editor, const T& item, const std::string& parameter, SetItem set) {
  FieldRows rows(editor, {}, std::move(set));
  edit::ForEachField(item, [&](const Field& field, const auto& value) {
    if (parameter == ParameterOf(field)) rows(field, value);
  });
}

}  // namespace hazumi::ui
