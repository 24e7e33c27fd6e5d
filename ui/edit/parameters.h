#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/project/fields/field.h"

namespace hazumi::edit {

using Json = nlohmann::ordered_json;

enum class ParameterKind { kText, kNumber, kInteger, kYesNo, kNames, kNumbers };
// "a text", "a number" and so on.
const char* Describe(ParameterKind kind);

// What forms offer for a value: one of some words, or what the project has of a thing.
struct Offer {
  constexpr Offer() = default;
  constexpr Offer(const char* with_words) : words(with_words) {}
  constexpr Offer(Thing named) : thing(named) {}
  const char* words = "";  // with spaces between them
  Thing thing = Thing::kAny;
  bool is_on = false;  // of a yes or no: yes unless no is given
};
inline constexpr Offer kOnUnlessGiven = [] {
  Offer offer;
  offer.is_on = true;
  return offer;
}();
std::vector<std::string> WordsOf(const Offer& offer);

// One parameter of an operator.
struct ParameterInfo {
  const char* name;
  ParameterKind kind;
  bool is_required;
  const char* help;
  Offer offer = {};
  const char* label = "";  // where the name with a capital would not say it
  const char* unit = "";   // "m", "s", "°"
  NumberRange range = {};  // of numbers
};
// "from 0 to 1", "at least 0"; empty: any number.
std::string Describe(const NumberRange& range);

// What an operator was called with, checked against what it takes.
class Parameters {
 public:
  // Errors: kSchema, the place being the parameter.
  static Result<Parameters> Check(const std::vector<ParameterInfo>& infos, Json values);

  bool has(const char* name) const { return values_.contains(name); }
  std::string text(const char* name, const std::string& otherwise = "") const {
    return has(name) ? values_.at(name).get<std::string>() : otherwise;
  }
  double number(const char* name, double otherwise = 0.0) const {
    return has(name) ? values_.at(name).get<double>() : otherwise;
  }
  int integer(const char* name, int otherwise = 0) const {
    return has(name) ? values_.at(name).get<int>() : otherwise;
  }
  bool yes(const char* name, bool otherwise = false) const {
    return has(name) ? values_.at(name).get<bool>() : otherwise;
  }
  std::vector<std::string> names(const char* name) const {
    return has(name) ? values_.at(name).get<std::vector<std::string>>()
                     : std::vector<std::string>();
  }
  std::vector<double> numbers(const char* name) const {
    return has(name) ? values_.at(name).get<std::vector<double>>() : std::vector<double>();
  }
  std::optional<double> maybe_number(const char* name) const {
    return has(name) ? std::optional(number(name)) : std::nullopt;
  }
  const Json& values() const { return values_; }

 private:
  explicit Parameters(Json values) : values_(std::move(values)) {}
  Json values_;
};

}  // namespace hazumi::edit
