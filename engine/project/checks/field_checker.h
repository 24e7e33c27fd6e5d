#pragma once

// Internal. Checks every described field of the document by what its description says: numbers
// against their range, texts that must not be empty, colours. The first thing wrong is reported
// with its place. What several fields say together is checked in checks/document_checks.h.

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/project/checks/field_checks.h"
#include "engine/project/fields/project_fields.h"

namespace hazumi {

class FieldChecker {
 public:
  template <typename T>
  using RefTo = const T&;

  explicit FieldChecker(FirstError* errors) : errors_(errors) {}

  template <typename T>
  void Required(const Field& field, const T& value) {
    const Inside inside(&place_, field.name);
    CheckValue(field, value);
  }
  template <typename T>
  void Stated(const Field& field, const T& value) {
    Required(field, value);
  }
  template <typename T>
  void Optional(const Field& field, const T& value, const T& = T()) {
    Required(field, value);
  }
  template <typename T>
  void Literal(const char*, const T&) {}
  void Version(int) {}
  template <typename... T>
  void OneOf(const std::array<const char*, sizeof...(T)>& names, const std::variant<T...>& value) {
    std::visit([&](const auto& item) { Required({names[value.index()]}, item); }, value);
  }
  template <typename T, typename Fields>
  void Nested(const Field& field, const T& value, Fields fields) {
    const Inside inside(&place_, field.name);
    fields(*this, value);
  }
  template <typename T, typename Fields>
  void List(const Field& field, const std::vector<T>& values, Fields fields) {
    const Inside inside(&place_, field.name);
    ForEach(values, [&](const T& value) { fields(*this, value); });
  }
  template <typename T, typename Fields>
  void OptionalList(const Field& field, const std::vector<T>& values, Fields fields) {
    List(field, values, fields);
  }
  template <typename T, typename Fields>
  void Map(const Field& field, const std::vector<Named<T>>& values, Fields fields) {
    const Inside inside(&place_, field.name);
    for (const Named<T>& item : values) Nested({item.name.c_str()}, item.value, fields);
  }

 private:
  struct Step {
    const char* name;  // null: an item of a list
    size_t index;
  };
  // While it lives the place is one step further in.
  class Inside {
   public:
    Inside(std::vector<Step>* place, const char* name, size_t index = 0) : place_(place) {
      place_->push_back({name, index});
    }
    ~Inside() { place_->pop_back(); }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

   private:
    std::vector<Step>* place_;
  };

  // The text of a place is made for what is wrong alone: there are millions of fields.
  Site Here() const {
    Site site{"", errors_};
    for (const Step& step : place_) {
      site = step.name ? site.Field(step.name) : site.Item(step.index);
    }
    return site;
  }

  void CheckValue(const Field& field, double value) {
    if (!IsWithin(value, field.range)) CheckRange(value, field, Here());
  }
  void CheckValue(const Field& field, int value) { CheckValue(field, static_cast<double>(value)); }
  void CheckValue(const Field&, bool) {}
  template <FileEnum Enum>
  void CheckValue(const Field&, Enum) {}
  void CheckValue(const Field& field, const std::string& value) {
    if (field.is_filled) CheckNotEmpty(value, Here());
    if (field.thing == Thing::kColor) CheckColor(value, Here());
  }
  void CheckValue(const Field& field, const Vec3& value) {
    for (int i = 0; i < 3; ++i) {
      const Inside inside(&place_, nullptr, static_cast<size_t>(i));
      CheckValue(field, value[i]);
    }
  }
  void CheckValue(const Field&, const std::vector<JointRef>&) {}
  void CheckValue(const Field&, const ProjectFigure&) {}
  void CheckValue(const Field&, const ProjectSkin&) {}
  void CheckValue(const Field&, const ProjectMesh&) {}
  void CheckValue(const Field& field, const std::vector<Named<double>>& values) {
    for (const Named<double>& item : values) {
      const Inside inside(&place_, item.name.c_str());
      CheckValue(field, item.value);
    }
  }
  template <typename T>
  void CheckValue(const Field& field, const std::optional<T>& value) {
    if (value) CheckValue(field, *value);
  }
  template <typename T>
  void CheckValue(const Field& field, const std::vector<T>& values) {
    ForEach(values, [&](const T& value) { CheckValue(field, value); });
  }
  template <typename T>
  requires std::is_class_v<T>
  void CheckValue(const Field&, const T& value) { Describe(*this, value); }

  template <typename T, typename Check>
  void ForEach(const std::vector<T>& values, Check check) {
    for (size_t i = 0; i < values.size() && errors_->ok(); ++i) {
      const Inside inside(&place_, nullptr, i);
      check(values[i]);
    }
  }

  FirstError* errors_;
  std::vector<Step> place_;
};

}  // namespace hazumi
