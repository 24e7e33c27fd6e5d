#pragma once

// Internal. Finds the field that an address names by going through the descriptions of the fields
// (fields/project_fields.h), step by step from the outside in.

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "engine/base/text.h"
#include "engine/project/address/field_address.h"
#include "engine/project/fields/project_fields.h"
#include "engine/project/json/did_you_mean.h"

namespace hazumi {

// What one number, word, vector or list of joints is: the fields that an address can end in.
template <typename T>
inline constexpr bool kIsOneValue =
    std::is_arithmetic_v<T> || FileEnum<T> || std::is_same_v<T, std::string> ||
    std::is_same_v<T, Vec3> || std::is_same_v<T, std::vector<JointRef>>;
template <typename T>
inline constexpr bool kIsOneValue<std::optional<T>> = kIsOneValue<T>;

// A number that stands by itself in a text.
template <typename T>
std::optional<T> WholeNumber(const std::string& text) {
  T value{};
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// What stands in brackets for each item of a list: its name, of a key its frame, else its number.
// A name that cannot stand there or that an item before it has gives way to the number.
template <typename Values>
std::vector<std::string> ItemNames(const Values& values) {
  using Value = typename Values::value_type;
  std::vector<std::string> names;
  for (size_t i = 0; i < values.size(); ++i) {
    if constexpr (requires(Value value) { value.name; }) {
      const std::string& name = values[i].name;
      const bool is_taken = std::find(names.begin(), names.end(), name) != names.end();
      const bool stands = !name.empty() && name.find(']') == name.npos && !is_taken;
      names.push_back(stands ? name : std::to_string(i));
    } else if constexpr (std::is_same_v<Value, ProjectKey>) {
      names.push_back(FormatNumber(values[i].frame));
    } else {
      names.push_back(std::to_string(i));
    }
  }
  return names;
}

// `visit(field, value)` is called with the one field that is found and returns what is wrong with
// it, if anything is.
template <typename Visit, bool kIsConst>
class AddressedField {
 public:
  template <typename T>
  using RefTo = std::conditional_t<kIsConst, const T&, T&>;

  AddressedField(const FieldAddress& address, const Visit* visit, size_t step = 0)
      : address_(address), visit_(visit), step_(step) {}

  // In an item with a Describe: what is wrong, if anything is. The place is left empty.
  template <typename T>
  std::optional<Error> FindIn(T& item) {
    return FindBy([&] { Describe(*this, item); });
  }

  template <typename T>
  void Required(const Field& field, T& value) {
    if (IsNext(field.name)) error_ = Enter(field, value);
  }
  template <typename T>
  void Stated(const Field& field, T& value) {
    Required(field, value);
  }
  template <typename T>
  void Optional(const Field& field, T& value, const std::remove_const_t<T>& = {}) {
    Required(field, value);
  }
  template <typename T>
  void Literal(const char*, const T&) {}
  void Version(int) {}
  template <typename Variant, size_t N>
  void OneOf(const char* const (&names)[N], Variant& value) {
    std::visit([&](auto& item) { Required({names[value.index()]}, item); }, value);
  }
  template <typename T, typename Fields>
  void Nested(const Field& field, T& value, Fields fields) {
    if (IsNext(field.name)) error_ = EnterBy(step_ + 1, value, fields);
  }
  template <typename Values, typename Fields>
  void List(const Field& field, Values& values, Fields fields) {
    if (IsNext(field.name)) error_ = EnterItem(field, values, fields);
  }
  template <typename Values, typename Fields>
  void OptionalList(const Field& field, Values& values, Fields fields) {
    List(field, values, fields);
  }
  template <typename Values, typename Fields>
  void Map(const Field& field, Values& values, Fields fields) {
    if (!IsNext(field.name)) return;
    error_ = EnterItem(field, values, [&](auto& walk, auto& item) { fields(walk, item.value); });
  }

 private:
  using Wrong = std::optional<Error>;

  static Error MakeWrong(const std::string& message) {
    return {ErrorCode::kSchema, "", "", message};
  }

  template <typename Action>
  Wrong FindBy(Action describe) {
    if (step_ >= address_.steps.size()) {
      return MakeWrong("is several fields: name one of them, behind a dot");
    }
    if (address_.steps[step_].is_item) {
      return MakeWrong("is no list: nothing in brackets goes here");
    }
    describe();
    if (is_found_) return error_;
    const std::string& name = address_.steps[step_].name;
    return MakeWrong("there is no field \"" + name + "\" here; " + Suggestion(name, names_));
  }

  bool IsNext(const char* name) {
    names_.push_back(name);
    const bool is_next = !is_found_ && address_.steps[step_].name == name;
    is_found_ = is_found_ || is_next;
    return is_next;
  }

  template <typename T, typename Fields>
  Wrong EnterBy(size_t step, T& value, Fields fields) {
    AddressedField inner(address_, visit_, step);
    return inner.FindBy([&] { fields(inner, value); });
  }

  // The step behind the field's name, in brackets; null: there is none.
  const std::string* Item() const {
    if (step_ + 1 >= address_.steps.size() || !address_.steps[step_ + 1].is_item) return nullptr;
    return &address_.steps[step_ + 1].name;
  }
  bool IsLast(size_t step) const { return step + 1 == address_.steps.size(); }

  template <typename T>
  Wrong Enter(const Field& field, T& value) {
    using Plain = std::remove_const_t<T>;
    if constexpr (std::is_same_v<Plain, Vec3>) {
      if (Item()) return EnterAxis(field, value);
    }
    if constexpr (kIsOneValue<Plain>) {
      if (IsLast(step_)) return (*visit_)(field, value);
      return MakeWrong("\"" + std::string(field.name) + "\" is one value: nothing comes behind it");
    } else if constexpr (std::is_same_v<Plain, std::vector<Named<double>>>) {
      return EnterNumber(field, value);
    } else if constexpr (requires { value.has_value(); }) {
      return EnterOptional(field, value);
    } else if constexpr (requires { value.begin(); }) {
      return EnterItem(field, value, [](auto& walk, auto& item) { Describe(walk, item); });
    } else if constexpr (requires(AddressedField walk) { Describe(walk, value); }) {
      return EnterBy(step_ + 1, value, [](auto& walk, auto& item) { Describe(walk, item); });
    } else {
      return MakeWrong("is read from a file as a whole: no address leads into it");
    }
  }

  template <typename V>
  Wrong EnterAxis(const Field& field, V& value) {
    if (!IsLast(step_ + 1)) return MakeWrong("an axis is one number: nothing comes behind it");
    for (int axis = 0; axis < 3; ++axis) {
      if (*Item() == std::string(1, field.axes[axis]) || *Item() == std::to_string(axis)) {
        return (*visit_)(field, value[axis]);
      }
    }
    return MakeWrong("there is no axis \"" + *Item() + "\"; use one of \"x\", \"y\", \"z\"");
  }

  // Of numbers by name, one that is not there yet comes to be.
  template <typename Values>
  Wrong EnterNumber(const Field& field, Values& values) {
    if (!Item()) return MakeWrong("is a list: name an item of it, in brackets");
    if (!IsLast(step_ + 1)) return MakeWrong("a number is one value: nothing comes behind it");
    for (auto& item : values) {
      if (item.name == *Item()) return (*visit_)(field, item.value);
    }
    if constexpr (kIsConst) {
      return (*visit_)(field, std::optional<double>());
    } else {
      return (*visit_)(field, values.emplace_back(Named<double>{*Item(), 0.0}).value);
    }
  }

  template <typename T>
  Wrong EnterOptional(const Field& field, T& value) {
    if constexpr (!kIsConst) {
      if (!value) value.emplace();
    }
    if (!value) return MakeWrong("\"" + std::string(field.name) + "\" is left out here");
    return Enter(field, *value);
  }

  template <typename Values, typename Fields>
  Wrong EnterItem(const Field& field, Values& values, Fields fields) {
    if (!Item()) {
      return MakeWrong("\"" + std::string(field.name) +
                       "\" is a list: name an item of it, in brackets");
    }
    const std::optional<size_t> found = IndexOf(values, *Item());
    if (found) return EnterBy(step_ + 2, values[*found], fields);
    const std::vector<std::string> names = ItemNames(values);
    return MakeWrong("there is no \"" + *Item() + "\" among \"" + field.name + "\"" +
                     (names.empty() ? ", which is empty" : "; " + Suggestion(*Item(), names)));
  }

  // By name, of keys by frame, else by number.
  template <typename Values>
  static std::optional<size_t> IndexOf(const Values& values, const std::string& item) {
    using Value = typename Values::value_type;
    for (size_t i = 0; i < values.size(); ++i) {
      if constexpr (requires(Value value) { value.name; }) {
        if (values[i].name == item) return i;
      } else if constexpr (std::is_same_v<Value, ProjectKey>) {
        if (WholeNumber<double>(item) == values[i].frame) return i;
      }
    }
    if constexpr (std::is_same_v<Value, ProjectKey>) return std::nullopt;
    const auto number = WholeNumber<size_t>(item);
    return number && *number < values.size() ? number : std::nullopt;
  }

  const FieldAddress& address_;
  const Visit* visit_;
  size_t step_;
  bool is_found_ = false;
  std::vector<std::string> names_;  // of the fields that there are at this step
  Wrong error_;
};

}  // namespace hazumi
