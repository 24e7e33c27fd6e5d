#pragma once

// Internal. JSON to C++ values, one overload a type. A wrong type or range is reported at the site
// and leaves the value as it was.

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/project/enum_names.h"
#include "engine/project/json/did_you_mean.h"
#include "engine/project/json/field_reader.h"
#include "engine/spatial/types.h"

namespace hazumi {

void ReadValue(const Json& json, const Site& site, double& value);
void ReadValue(const Json& json, const Site& site, int& value);
void ReadValue(const Json& json, const Site& site, bool& value);
void ReadValue(const Json& json, const Site& site, std::string& value);
void ReadValue(const Json& json, const Site& site, Vec3& value);
void ReadValue(const Json& json, const Site& site, JointRef& value);
// A reference to a figure file, or the figure itself.
void ReadValue(const Json& json, const Site& site, ProjectFigure& figure);
// Lists of numbers are base64 of their little-endian bytes.
void ReadValue(const Json& json, const Site& site, ProjectSkin& skin);
void ReadValue(const Json& json, const Site& site, ProjectMesh& mesh);
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
  ExtraFields unknown = in.Unknown();
  in.WarnAboutSlips(unknown);
  in.ListUnknown(unknown);
  if constexpr (requires { value.extra; }) value.extra = std::move(unknown);
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
