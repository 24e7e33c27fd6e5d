#pragma once

// The fields of an item of the document as parameters of the operators that make and change it.
// They follow from its description (engine/project/fields): one that is added there can be set at
// once.

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "engine/project/fields/project_fields.h"
#include "ui/edit/parameters.h"

namespace hazumi::edit {

using ParameterInfos = std::vector<ParameterInfo>;

// One list after the other.
ParameterInfos Joined(std::initializer_list<ParameterInfos> lists);
// The same parameters, these of which must be given.
ParameterInfos Requiring(std::initializer_list<const char*> names, ParameterInfos infos);
// Of them these alone.
ParameterInfos Only(std::initializer_list<const char*> names, ParameterInfos infos);

// Errors: kSchema with this message if one of `all` is given that is none of `own`: of another
// shape.
Result<Done> ExpectOwn(const ParameterInfos& own, const ParameterInfos& all,
                       const Parameters& given, const char* message);

// "size_?" and 'x': "size_x", which lives as long as the program.
const char* NameOfAxis(const char* parameter, char axis);

// "r_shoulder+" is that joint and all beyond it.
std::string NameOf(const JointRef& ref);

// The words of an enumeration, with spaces between them.
template <FileEnum Enum>
const char* WordsOf() {
  static const std::string words = [] {
    std::string list;
    for (const auto& entry : EnumNames<Enum>::kNames) {
      list += (list.empty() ? "" : " ") + std::string(entry.name);
    }
    return list;
  }();
  return words.c_str();
}

// Lists of items; joints are one value.
template <typename T>
inline constexpr bool kIsList = false;
template <typename T>
inline constexpr bool kIsList<std::vector<T>> = !std::is_same_v<T, JointRef>;
// Read from a file, by an operator of its own.
template <typename T>
inline constexpr bool kIsMesh = std::is_same_v<T, ProjectMesh>;

// Visits what one item says itself: `visit(field, value)` of each field that has a label. Lists of
// items, which have operators of their own, are left out.
template <typename Visit, bool kIsConst>
class ItemFields {
 public:
  template <typename T>
  using RefTo = std::conditional_t<kIsConst, const T&, T&>;

  explicit ItemFields(Visit* visit) : visit_(visit) {}

  template <typename T>
  void Required(const Field& field, T& value) {
    if constexpr (requires { Describe(*this, value); }) {
      Describe(*this, value);
    } else if constexpr (!kIsList<std::remove_const_t<T>> && !kIsMesh<std::remove_const_t<T>>) {
      if (field.label[0] != '\0') (*visit_)(field, value);
    }
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
  template <typename... T>
  void OneOf(const std::array<const char*, sizeof...(T)>&, const std::variant<T...>& value) {
    std::visit([&](const auto& item) { Describe(*this, item); }, value);
  }
  template <typename... T>
  void OneOf(const std::array<const char*, sizeof...(T)>&, std::variant<T...>& value) {
    std::visit([&](auto& item) { Describe(*this, item); }, value);
  }
  template <typename T, typename Fields>
  void Nested(const Field&, T& value, Fields fields) {
    fields(*this, value);
  }
  template <typename T, typename Fields>
  void List(const Field&, T&, Fields) {}
  template <typename T, typename Fields>
  void OptionalList(const Field&, T&, Fields) {}
  template <typename T, typename Fields>
  void Map(const Field&, T&, Fields) {}

 private:
  Visit* visit_;
};

template <typename T, typename Visit>
void ForEachField(const T& item, Visit visit) {
  ItemFields<Visit, true> fields(&visit);
  Describe(fields, item);
}
template <typename T, typename Visit>
void ForEachField(T* item, Visit visit) {
  ItemFields<Visit, false> fields(&visit);
  Describe(fields, *item);
}

// Parameters for one field: of a vector three.
class ParameterList {
 public:
  void operator()(const Field& field, double) { Add(field, ParameterKind::kNumber); }
  void operator()(const Field& field, int) { Add(field, ParameterKind::kInteger); }
  void operator()(const Field& field, bool) { Add(field, ParameterKind::kYesNo); }
  void operator()(const Field& field, const std::string&) { Add(field, ParameterKind::kText); }
  void operator()(const Field& field, const Vec3&);
  void operator()(const Field& field, const std::vector<JointRef>&) {
    Add(field, ParameterKind::kNames);
  }
  template <FileEnum Enum>
  void operator()(const Field& field, Enum) {
    Add(field, ParameterKind::kText, WordsOf<Enum>());
  }
  template <typename T>
  void operator()(const Field& field, const std::optional<T>&) {
    (*this)(field, T());
  }

  ParameterInfos infos;

 private:
  void Add(const Field& field, ParameterKind kind, const char* words = "");
  void Put(ParameterInfo info);  // unless there is one of its name
};

// Of all kinds of items, none required.
template <typename T>
ParameterInfos FieldsOf() {
  ParameterList list;
  ForEachKind<T>([&](const T& item, const char*) {
    ForEachField(item, [&](const Field& field, const auto& value) { list(field, value); });
  });
  return std::move(list.infos);
}
// Of this item: of its shape and kind.
template <typename T>
ParameterInfos FieldsOf(const T& item) {
  ParameterList list;
  ForEachField(item, [&](const Field& field, const auto& value) { list(field, value); });
  return std::move(list.infos);
}

// Sets a field to what is given for it, if it is given.
class FieldSetter {
 public:
  explicit FieldSetter(const Parameters& given) : p_(given) {}

  void operator()(const Field& field, double& value) { value = p_.number(Name(field), value); }
  void operator()(const Field& field, int& value) { value = p_.integer(Name(field), value); }
  void operator()(const Field& field, bool& value) { value = p_.yes(Name(field), value); }
  void operator()(const Field& field, std::string& value) { value = p_.text(Name(field), value); }
  void operator()(const Field& field, Vec3& value);
  void operator()(const Field& field, std::vector<JointRef>& value);
  template <FileEnum Enum>
  void operator()(const Field& field, Enum& value) {
    if (!p_.has(Name(field))) return;
    const std::string word = p_.text(Name(field));
    for (const auto& entry : EnumNames<Enum>::kNames) {
      if (word == entry.name) return void(value = entry.value);
    }
    Refuse(field, word, WordsOf<Enum>());
  }
  template <typename T>
  void operator()(const Field& field, std::optional<T>& value) {
    if (p_.has(Name(field))) (*this)(field, value.emplace());
  }

  const std::optional<Error>& error() const { return error_; }

 private:
  static const char* Name(const Field& field) { return ParameterOf(field); }
  void Refuse(const Field& field, const std::string& word, const char* words);

  const Parameters& p_;
  std::optional<Error> error_;
};

// What is not given stays. Errors: kSchema if a word is none of its enumeration.
template <typename T>
Result<Done> SetFields(const Parameters& given, T* item) {
  FieldSetter set(given);
  ForEachField(item, [&](const Field& field, auto& value) { set(field, value); });
  if (set.error()) return *set.error();
  return Done();
}

// What a field says, as its parameter takes it; null: nothing.
Json JsonOf(double value);
Json JsonOf(int value);
Json JsonOf(bool value);
Json JsonOf(const std::string& value);
Json JsonOf(const std::vector<JointRef>& value);
template <FileEnum Enum>
Json JsonOf(Enum value) {
  return hazumi::NameOf(value);
}
template <typename T>
Json JsonOf(const std::optional<T>& value) {
  return value ? JsonOf(*value) : Json();
}

// And back; a word of an enumeration is one of its own.
template <typename T>
T FromJson(const Json& value) {
  if constexpr (FileEnum<T>) {
    for (const auto& entry : EnumNames<T>::kNames) {
      if (value == entry.name) return entry.value;
    }
    return T();
  } else {
    return value.get<T>();
  }
}

// By the name of the parameter; null: the item says nothing of it.
template <typename T>
Json FieldValue(const T& item, const std::string& parameter) {
  Json found;
  ForEachField(item, [&](const Field& field, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Vec3>) {
      for (int i = 0; i < 3; ++i) {
        if (parameter == NameOfAxis(ParameterOf(field), field.axes[i])) found = value[i];
      }
    } else if (parameter == ParameterOf(field)) {
      found = JsonOf(value);
    }
  });
  return found;
}

}  // namespace hazumi::edit
