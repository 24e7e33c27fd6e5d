#include "ui/edit/parameters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

#include "engine/base/text.h"

namespace hazumi::edit {

const char* Describe(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::kText:
      return "a text";
    case ParameterKind::kNumber:
      return "a number";
    case ParameterKind::kInteger:
      return "a whole number";
    case ParameterKind::kYesNo:
      return "true or false";
    case ParameterKind::kNames:
      return "a list of names";
    case ParameterKind::kNumbers:
      return "a list of numbers";
  }
  return "";
}

std::vector<std::string> WordsOf(const Offer& offer) {
  std::istringstream stream(offer.words);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string Describe(const NumberRange& range) {
  const std::string lower = FormatShort(range.lower), upper = FormatShort(range.upper);
  if (range == NumberRange()) return "";
  if (range.upper < kLargestNumber) return "from " + lower + " to " + upper;
  return (range.is_above ? "greater than " : "at least ") + lower;
}

namespace {

bool IsWhole(const Json& value) {
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  return number == std::floor(number) && std::abs(number) <= std::numeric_limits<int>::max();
}

// As large as a project file may hold.
bool IsFinite(const Json& value) {
  return value.is_number() && std::abs(value.get<double>()) <= kLargestNumber;
}

bool IsOf(ParameterKind kind, const Json& value) {
  switch (kind) {
    case ParameterKind::kText:
      return value.is_string();
    case ParameterKind::kNumber:
      return IsFinite(value);
    case ParameterKind::kInteger:
      return IsWhole(value);
    case ParameterKind::kYesNo:
      return value.is_boolean();
    case ParameterKind::kNames:
      return value.is_array() && std::all_of(value.begin(), value.end(),
                                             [](const Json& name) { return name.is_string(); });
    case ParameterKind::kNumbers:
      return value.is_array() && std::all_of(value.begin(), value.end(), IsFinite);
  }
  return false;
}

Error Wrong(const std::string& place, const std::string& message) {
  return {ErrorCode::kSchema, "", place, message};
}

}  // namespace

Result<Parameters> Parameters::Check(const std::vector<ParameterInfo>& infos, Json values) {
  if (!values.is_object()) return Wrong("", "parameters must be an object of names and values");
  for (const auto& item : values.items()) {
    const std::string& name = item.key();
    const Json& value = item.value();
    const auto info = std::find_if(infos.begin(), infos.end(),
                                   [&](const ParameterInfo& i) { return name == i.name; });
    if (info == infos.end()) {
      std::string known;
      for (const ParameterInfo& i : infos)
        known += (known.empty() ? "" : ", ") + std::string(i.name);
      return Wrong(name, "there is no such parameter; " +
                             (known.empty() ? "the operator takes none" : "there are " + known));
    }
    if (!IsOf(info->kind, value)) {
      return Wrong(name, std::string("must be ") + Describe(info->kind));
    }
  }
  for (const ParameterInfo& info : infos) {
    if (info.is_required && !values.contains(info.name)) {
      return Wrong(info.name, std::string("is missing: ") + info.help);
    }
  }
  return Parameters(std::move(values));
}

}  // namespace hazumi::edit
