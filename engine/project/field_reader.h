#pragma once

// Internal. Reads JSON objects field by field into structs. The first thing wrong goes to a
// FirstError with its place; reading goes on, with the value left as it was.
// A struct is read by a function `Describe(Archive&, Ref<Archive, Struct>)` that names its fields
// once for FieldReader and FieldWriter alike; fields it does not name are kept in `value.extra`.

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/project/checks.h"
#include "engine/project/did_you_mean.h"
#include "engine/project/enum_names.h"
#include "engine/project/json.h"
#include "engine/project/project.h"
#include "engine/spatial/types.h"

namespace hazumi {

template <typename Archive, typename T>
using Ref = typename Archive::template RefTo<T>;

// Where a value stands and whom to tell.
struct Site {
  std::string place;
  FirstError* errors;

  void Report(Check check, std::initializer_list<std::string_view> arguments = {}) const {
    errors->Report(check, place, arguments);
  }
  Site Field(const std::string& name) const {
    return {place.empty() ? name : place + "." + name, errors};
  }
  Site Item(size_t index) const { return {place + "[" + std::to_string(index) + "]", errors}; }
};

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

void ReadValue(const Json& json, const Site& site, double& value);
void ReadValue(const Json& json, const Site& site, int& value);
void ReadValue(const Json& json, const Site& site, bool& value);
void ReadValue(const Json& json, const Site& site, std::string& value);
void ReadValue(const Json& json, const Site& site, Vec3& value);
void ReadValue(const Json& json, const Site& site, JointRef& value);
// An object of numbers by name, as in friction.
void ReadValue(const Json& json, const Site& site, std::vector<Named<double>>& values);

template <FileEnum Enum>
void ReadValue(const Json& json, const Site& site, Enum& value) {
  std::string word;
  ReadValue(json, site, word);
  if (!json.is_string()) return;
  std::vector<std::string> words;
  for (const auto& entry : EnumNames<Enum>::kNames) {
    if (entry.name == word) value = entry.value;
    words.push_back(entry.name);
  }
  if (NameOf(value) == word) return;
  const std::string what = EnumNames<Enum>::kWhat + (" " + Quoted(word));
  site.Report(Check::kUnknownChoice, {what, Suggestion(word, words)});
}

template <size_t N>
void ReadValue(const Json& json, const Site& site, std::array<double, N>& values) {
  if (!ExpectArray(json, site) || !ExpectCount(json, N, site)) return;
  for (size_t i = 0; i < N; ++i) ReadValue(json[i], site.Item(i), values[i]);
}

template <typename T, typename Fields>
void ReadObject(const Json& json, const Site& site, T& value, Fields fields) {
  FieldReader in(json, site);
  fields(in, value);
  if constexpr (requires { value.extra; }) value.extra = in.Unknown();
}

template <typename T, typename Fields>
void ReadList(const Json& json, const Site& site, std::vector<T>& values, Fields fields) {
  if (!ExpectArray(json, site)) return;
  values.resize(json.size());
  for (size_t i = 0; i < values.size(); ++i) {
    ReadObject(json[i], site.Item(i), values[i], fields);
  }
}

template <typename T>
void ReadValue(const Json& json, const Site& site, std::optional<T>& value) {
  ReadValue(json, site, value.emplace());
}

template <typename T>
void ReadValue(const Json& json, const Site& site, std::vector<T>& values) {
  if (!ExpectArray(json, site)) return;
  values.resize(json.size());
  for (size_t i = 0; i < values.size(); ++i) ReadValue(json[i], site.Item(i), values[i]);
}

// Any struct that has a Describe.
template <typename T>
  requires std::is_class_v<T>
void ReadValue(const Json& json, const Site& site, T& value) {
  ReadObject(json, site, value, [](FieldReader& in, T& item) { Describe(in, item); });
}

}  // namespace hazumi
