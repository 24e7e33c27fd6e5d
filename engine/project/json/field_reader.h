#pragma once

// Internal. Reads JSON objects field by field into structs. The first thing wrong goes to a
// FirstError with its place; reading goes on, with the value left as it was.
// A struct is read by a function `Describe(Archive&, Ref<Archive, Struct>)` that names its fields
// once for FieldReader and FieldWriter alike; fields it does not name are kept in `value.extra`.
// Single values are read by the overloads of ReadValue in read_value.h.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/project/json/json.h"
#include "engine/project/json/site.h"
#include "engine/project/project.h"

namespace hazumi {

template <typename Archive, typename T>
using Ref = typename Archive::template RefTo<T>;

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

  template <typename T>
  void Required(const char* name, T& value) {
    if (const Json* json = FindRequired(name)) ReadValue(*json, At(name), value);
  }
  template <typename T>
  void Stated(const char* name, T& value) {
    if (const Json* json = Find(name)) ReadValue(*json, At(name), value);
  }
  template <typename T>
  void Optional(const char* name, T& value, const T& = T()) {
    Stated(name, value);
  }
  template <typename T>
  void Literal(const char* name, const T&) {
    Find(name);  // checked before
  }

  // Exactly one of the names, each for one alternative.
  template <typename... T>
  void OneOf(const std::array<const char*, sizeof...(T)>& names, std::variant<T...>& value) {
    if (!ExpectOneOf({names.begin(), names.end()})) return;
    size_t i = 0;
    (ReadAlternative<T>(names[i++], value), ...);
  }

  // An object or a list of objects whose fields are given by fields(archive, value).
  template <typename T, typename Fields>
  void Nested(const char* name, T& value, Fields fields) {
    if (const Json* json = Find(name)) ReadObject(*json, At(name), value, fields);
  }
  template <typename T, typename Fields>
  void List(const char* name, std::vector<T>& values, Fields fields) {
    if (const Json* json = FindRequired(name)) ReadList(*json, At(name), values, fields);
  }
  // An object whose field names are names of the document.
  template <typename T, typename Fields>
  void Map(const char* name, std::vector<Named<T>>& values, Fields fields) {
    const Json* json = Find(name);
    if (!json || !ExpectObject(*json, At(name))) return;
    for (const auto& item : json->items()) {
      T& value = values.emplace_back(Named<T>{item.key(), {}}).value;
      ReadObject(item.value(), At(name).Field(item.key()), value, fields);
    }
  }

 private:
  bool ExpectOneOf(const std::vector<std::string>& names);

  template <typename T, typename Variant>
  void ReadAlternative(const char* name, Variant& value) {
    if (Find(name)) Required(name, value.template emplace<T>());
  }

  const Json* object_;
  std::vector<std::string> known_;
  Site site_;
};

}  // namespace hazumi
