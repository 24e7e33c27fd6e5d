#include "engine/project/json/field_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/project/json/read_value.h"
#include "engine/project/project.h"

namespace hazumi {

namespace {

// Against hostile files: looked at in one object, and kept of a file.
constexpr size_t kMostUnknownFields = 100;
constexpr size_t kMostWarnings = 100;

// Fields that people and programs add on purpose.
bool IsRemark(std::string_view name) {
  return name.starts_with("x_") || name.starts_with("notes") || name.starts_with("comment");
}

const char* KindOf(const Json& json) {
  if (json.is_object()) return "an object";
  if (json.is_array()) return "an array";
  if (json.is_string()) return "a string";
  if (json.is_number()) return "a number";
  return json.is_null() ? "null" : "true or false";
}

bool Expect(bool good, const char* kind, const Json& json, const Site& site) {
  if (!good) site.Report(Check::kWrongType, {kind, KindOf(json)});
  return good;
}

}  // namespace

bool ExpectObject(const Json& json, const Site& site) {
  return Expect(json.is_object(), "an object", json, site);
}

bool ExpectArray(const Json& json, const Site& site) {
  return Expect(json.is_array(), "an array", json, site);
}

bool ExpectCount(const Json& json, size_t count, const Site& site) {
  if (json.size() == count) return true;
  site.Report(Check::kWrongCount, {std::to_string(count), std::to_string(json.size())});
  return false;
}

FieldReader::FieldReader(const Json& json, Site site)
    : object_(json.is_object() ? &json : nullptr), site_(std::move(site)) {
  ExpectObject(json, site_);
}

const Json* FieldReader::Find(const std::string& name) {
  known_.push_back(name);
  if (!object_) return nullptr;
  const auto it = object_->find(name);
  return it == object_->end() ? nullptr : &*it;
}

const Json* FieldReader::FindRequired(const std::string& name) {
  const Json* json = Find(name);
  if (json || !object_) return json;
  std::vector<std::string> others;
  for (const ExtraField& field : Unknown()) others.push_back(field.name);
  if (const auto slip = Nearest(name, others)) {
    site_.Report(Check::kMisspelledField, {Quoted(name), Quoted(*slip)});
  } else {
    site_.Report(Check::kMissingField, {Quoted(name)});
  }
  return nullptr;
}

ExtraFields FieldReader::Unknown() const {
  ExtraFields unknown;
  if (!object_) return unknown;
  for (const auto& item : object_->items()) {
    if (std::find(known_.begin(), known_.end(), item.key()) != known_.end()) continue;
    unknown.push_back({item.key(), CompactJson(item.value())});
  }
  return unknown;
}

void FieldReader::WarnAboutSlips(const ExtraFields& unknown) const {
  const size_t count = std::min(unknown.size(), kMostUnknownFields);
  for (size_t i = 0; i < count; ++i) {
    if (!site_.warnings || site_.warnings->size() >= kMostWarnings) return;
    if (IsRemark(unknown[i].name)) continue;
    const auto meant = NearestField(unknown[i].name, known_);
    if (!meant) continue;
    // The whole file has no place: there the field itself is named.
    const Site& site = site_.place.empty() ? site_.Field(unknown[i].name) : site_;
    site.Warn(Check::kUnknownField, {Quoted(unknown[i].name), Quoted(*meant)});
  }
}

void FieldReader::ListUnknown(const ExtraFields& unknown) const {
  for (const ExtraField& field : unknown) {
    if (!site_.unknown || site_.unknown->size() >= kMostWarnings) return;
    if (IsRemark(field.name)) continue;
    const std::string nearest = NearestOf(field.name, known_);
    site_.unknown->push_back(
        {site_.Field(field.name).place,
         "unknown field" +
             (nearest.empty() ? "" : "; the nearest known one is " + Quoted(nearest)) +
             "; correct it, or begin its name with x_"});
  }
}

bool FieldReader::ExpectOneOf(const std::vector<std::string>& names) {
  std::string list;
  int present = 0;
  for (const std::string& name : names) {
    list += (list.empty() ? "" : " and ") + Quoted(name);
    if (Find(name)) ++present;
  }
  if (present != 1) site_.Report(Check::kNotOneOf, {list});
  return present == 1;
}

void ReadValue(const Json& json, const Site& site, double& value) {
  if (!Expect(json.is_number(), "a number", json, site)) return;
  const double number = json.get<double>();
  if (std::abs(number) <= kLargestNumber) {
    value = number;
  } else {
    site.Report(Check::kNumberTooLarge, {NumberText(number)});
  }
}

void ReadValue(const Json& json, const Site& site, int& value) {
  double number = value;
  ReadValue(json, site, number);
  static_assert(kLargestNumber < std::numeric_limits<int>::max());
  if (number == std::floor(number)) {
    value = static_cast<int>(number);
  } else {
    site.Report(Check::kNotWhole, {NumberText(number)});
  }
}

void ReadValue(const Json& json, const Site& site, bool& value) {
  if (Expect(json.is_boolean(), "true or false", json, site)) value = json.get<bool>();
}

void ReadValue(const Json& json, const Site& site, std::string& value) {
  if (Expect(json.is_string(), "a string", json, site)) value = json.get_ref<const std::string&>();
}

void ReadValue(const Json& json, const Site& site, Vec3& value) {
  std::array<double, 3> numbers{value.x(), value.y(), value.z()};
  ReadValue(json, site, numbers);
  value = Vec3(numbers[0], numbers[1], numbers[2]);
}

void ReadValue(const Json& json, const Site& site, JointRef& value) {
  if (!json.is_object()) {
    ReadValue(json, site, value.name);
    return;
  }
  value.beyond = true;
  ReadObject(json, site, value,
             [](FieldReader& in, JointRef& ref) { in.Required({"beyond"}, ref.name); });
}

void ReadValue(const Json& json, const Site& site, std::vector<Named<double>>& values) {
  if (!ExpectObject(json, site)) return;
  for (const auto& item : json.items()) {
    double& value = values.emplace_back(Named<double>{item.key(), 0.0}).value;
    ReadValue(item.value(), site.Field(item.key()), value);
  }
}

}  // namespace hazumi
