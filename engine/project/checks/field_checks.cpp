#include "engine/project/checks/field_checks.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace hazumi {

namespace {

bool IsColor(const std::string& color) {
  return color.size() == 7 && color[0] == '#' &&
         std::all_of(color.begin() + 1, color.end(),
                     [](unsigned char c) { return std::isxdigit(c) != 0; });
}

// Four decimals are enough for a hint.
std::string RoundedText(double value) { return NumberText(std::round(value * 1e4) / 1e4); }

std::string RoundedText(const Vec3& v) {
  return "[" + RoundedText(v.x()) + ", " + RoundedText(v.y()) + ", " + RoundedText(v.z()) + "]";
}

}  // namespace

void CheckPositive(double value, const Site& site) {
  if (!(value > 0.0)) site.Report(Check::kNotPositive, {NumberText(value)});
}

void CheckPositive(const Vec3& value, const Site& site) {
  for (int i = 0; i < 3; ++i) CheckPositive(value[i], site.Item(static_cast<size_t>(i)));
}

void CheckNotNegative(double value, const Site& site) {
  if (!(value >= 0.0)) site.Report(Check::kNegative, {NumberText(value)});
}

bool IsWithin(double value, const NumberRange& range) {
  const bool is_low_enough = value <= range.upper;  // false for NaN
  return is_low_enough && (range.is_above ? value > range.lower : value >= range.lower);
}

void CheckRange(double value, const Field& field, const Site& site) {
  const NumberRange& range = field.range;
  if (IsWithin(value, range)) return;
  if (!std::isfinite(value)) return site.Report(Check::kNotFinite);
  if (std::abs(value) > kLargestNumber) {
    return site.Report(Check::kNumberTooLarge, {NumberText(value)});
  }
  if (range == kNotNegative) return CheckNotNegative(value, site);
  if (range == kPositive) return CheckPositive(value, site);
  const std::string help = field.help[0] == '\0' ? "" : std::string(" (") + field.help + ")";
  site.Report(Check::kRange, {NumberText(range.lower), NumberText(range.upper) + Suffix(field),
                              NumberText(value) + help});
}

void CheckUnitVector(const Vec3& value, const Site& site) {
  constexpr double kTolerance = 1e-3;
  const double length = value.norm();
  if (!(length > 1e-9)) return site.Report(Check::kZeroVector);
  if (std::abs(length - 1.0) <= kTolerance) return;
  site.Report(Check::kNotUnit, {RoundedText(length), RoundedText(value / length)});
}

void CheckColor(const std::string& color, const Site& site) {
  if (!IsColor(color)) site.Report(Check::kBadColor, {Quoted(color)});
}

void CheckNotEmpty(const std::string& name, const Site& site) {
  if (name.empty()) site.Report(Check::kEmptyName);
}

}  // namespace hazumi
