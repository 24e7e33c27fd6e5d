#pragma once

// Internal. Reads JSON objects field by field into structs. The first thing wrong goes to a
// FirstError with its place; reading goes on, with the value left as it was.
// A struct is read by a function `Describe(Archive&, Ref<Archive, Struct>)` that describes its
// fields (fields/project_fields.h); fields it does not name are kept in `value.extra`. Single
// values are read by the overloads of ReadValue in read_value.h.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/project/fields/field.h"
#include "engine/project/json/json.h"
#include "engine/project/json/site.h"
#include "engine/project/project.h"

namespace hazumi {

bool ExpectObject(const Json& json, const Site& site);
bool ExpectArray(const Json& json, const Site& site);
bool ExpectCount(const Json& json, size_t count, const Site& site);  // of an array

class FieldReader {
 public:
  template <typename T>
  using RefTo = T&;

  // What is no object is reported and reads as an empty one.
  FieldReader(const Json& json, Site site);

  const Json* Find(const std::string& name);
  const Json* FindRequired(const std::string& name);
  Site At(const std::string& name) const { return site_.Field(name); }
  const Site& site() const { return site_; }
  ExtraFields Unknown() const;  // the fields not asked for so far
  // Warns of those among them that are probably misspelled.
  void WarnAboutSlips(const ExtraFields& unknown) const;
  // Lists all unknown fields, each with the nearest known name (Site::unknown).
  void ListUnknown(const ExtraFields& unknown) const;

  template <typename T>
  void Required(const Field& field, T& value) {
    if (const Json* json = FindRequired(field.name)) ReadValue(*json, At(field.name), value);
  }
  template <typename T>
  void Stated(const Field& field, T& value) {
    if (const Json* json = Find(field.name)) ReadValue(*json, At(field.name), value);
  }
  template <typename T>
  void Optional(const Field& field, T& value, const T& = T()) {
    Stated(field, value);
  }
  template <typename T>
  void Literal(const char* name, const T&) {
    Find(name);  // checked before
  }
  void Version(int) { Find("version"); }

  // Exactly one of the names, each for one alternative.
  template <typename... T>
  void OneOf(const std::array<const char*, sizeof...(T)>& names, std::variant<T...>& value) {
    if (!ExpectOneOf({names.begin(), names.end()})) return;
    size_t i = 0;
    (ReadAlternative<T>(names[i++], value), ...);
  }

  // An object or a list of objects whose fields are given by fields(archive, value).
  template <typename T, typename Fields>
  void Nested(const Field& field, T& value, Fields fields) {
    if (const Json* json = Find(field.name)) ReadObject(*json, At(field.name), value, fields);
  }
  template <typename T, typename Fields>
  void List(const Field& field, std::vector<T>& values, Fields fields) {
    if (const Json* json = FindRequired(field.name))
      ReadList(*json, At(field.name), values, fields);
  }
  template <typename T, typename Fields>
  void OptionalList(const Field& field, std::vector<T>& values, Fields fields) {
    if (const Json* json = Find(field.name)) ReadList(*json, At(field.name), values, fields);
  }
  // An object whose field names are names of the document.
  template <typename T, typename Fields>
  void Map(const Field& field, std::vector<Named<T>>& values, Fields fields) {
    const Json* json = Find(field.name);
    const Site site = At(field.name);
    if (!json || !ExpectObject(*json, site)) return;
    for (const auto& item : json->items()) {
      T& value = values.emplace_back(Named<T>{item.key(), {}}).value;
      ReadObject(item.value(), site.Field(item.key()), value, fields);
    }
  }

 private:
  bool ExpectOneOf(const std::vector<std::string>& names);

  template <typename T, typename Variant>
  void ReadAlternative(const char* name, Variant& value) {
    if (Find(name)) Required({name}, value.template emplace<T>());
  }

  const Json* object_;
  std::vector<std::string> known_;
  Site site_;
};

}  // namespace hazumi
