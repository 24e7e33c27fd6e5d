#pragma once

// Internal. The counterpart of FieldReader: the same Describe functions turn structs into JSON.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/project/enum_names.h"
#include "engine/project/fields/field.h"
#include "engine/project/json/json.h"
#include "engine/project/project.h"

namespace hazumi {

Json ToJson(double value);
Json ToJson(int value);
Json ToJson(bool value);
Json ToJson(const std::string& value);
Json ToJson(const char* value);
Json ToJson(const Vec3& value);
Json ToJson(const JointRef& value);
Json ToJson(const ProjectFigure& figure);
Json ToJson(const ProjectSkin& skin);
Json ToJson(const ProjectMesh& mesh);
Json ToJson(const std::vector<Named<double>>& values);
template <typename T>
Json ToJson(const std::vector<T>& values);
Json FromText(const std::string& json_text);

class FieldWriter {
 public:
  template <typename T>
  using RefTo = const T&;

  template <typename T>
  void Required(const Field& field, const T& value) {
    Put(field.name, ToJson(value));
  }
  template <typename T>
  void Stated(const Field& field, const T& value) {
    Put(field.name, ToJson(value));
  }
  template <typename T>
  void Optional(const Field& field, const T& value, const T& otherwise = T()) {
    if constexpr (requires { value.has_value(); }) {
      if (value) Put(field.name, ToJson(*value));
    } else if (!(value == otherwise)) {
      Put(field.name, ToJson(value));
    }
  }
  template <typename T>
  void Literal(const char* name, const T& value) {
    Put(name, ToJson(value));
  }
  void Version(int version) { Put("version", version); }
  template <typename... T>
  void OneOf(const std::array<const char*, sizeof...(T)>& names, const std::variant<T...>& value) {
    std::visit([&](const auto& item) { Put(names[value.index()], ToJson(item)); }, value);
  }
  template <typename T, typename Fields>
  void Nested(const Field& field, const T& value, Fields fields);
  template <typename T, typename Fields>
  void List(const Field& field, const std::vector<T>& values, Fields fields);
  template <typename T, typename Fields>
  void OptionalList(const Field& field, const std::vector<T>& values, Fields fields) {
    if (!values.empty()) List(field, values, fields);
  }
  template <typename T, typename Fields>
  void Map(const Field& field, const std::vector<Named<T>>& values, Fields fields);

  void PutExtra(const ExtraFields& extra) {
    for (const ExtraField& field : extra) {
      if (!object_.contains(field.name)) Put(field.name, FromText(field.json));
    }
  }
  Json TakeObject() { return std::move(object_); }

 private:
  void Put(const std::string& name, Json json) { object_[name] = std::move(json); }

  Json object_ = Json::object();
};

template <FileEnum Enum>
Json ToJson(Enum value) {
  return NameOf(value);
}

template <typename T, typename Fields>
Json ObjectToJson(const T& value, Fields fields) {
  FieldWriter out;
  fields(out, value);
  out.PutExtra(value.extra);
  return out.TakeObject();
}

template <typename T>
requires requires(const T& value) { value.extra; }
Json ToJson(const T& value) {
  return ObjectToJson(value, [](FieldWriter& out, const T& item) { Describe(out, item); });
}

template <typename T>
Json ToJson(const std::vector<T>& values) {
  Json array = Json::array();
  for (const T& value : values) array.push_back(ToJson(value));
  return array;
}

// Left out if it is as a fresh one.
template <typename T, typename Fields>
void FieldWriter::Nested(const Field& field, const T& value, Fields fields) {
  if (!(value == T())) Put(field.name, ObjectToJson(value, fields));
}

template <typename T, typename Fields>
void FieldWriter::List(const Field& field, const std::vector<T>& values, Fields fields) {
  Json array = Json::array();
  for (const T& value : values) array.push_back(ObjectToJson(value, fields));
  Put(field.name, std::move(array));
}

// Left out if empty.
template <typename T, typename Fields>
void FieldWriter::Map(const Field& field, const std::vector<Named<T>>& values, Fields fields) {
  if (values.empty()) return;
  Json object = Json::object();
  for (const Named<T>& item : values) object[item.name] = ObjectToJson(item.value, fields);
  Put(field.name, std::move(object));
}

}  // namespace hazumi
