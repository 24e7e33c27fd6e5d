#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace hazumi::edit {

using Json = nlohmann::ordered_json;

enum class ParameterKind { kText, kNumber, kInteger, kYesNo, kNames, kNumbers };
// "a text", "a number" and so on.
const char* Describe(ParameterKind kind);

// One parameter of an operator.
struct ParameterInfo {
  const char* name;
  ParameterKind kind;
  bool is_required;
  const char* help;
};

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
