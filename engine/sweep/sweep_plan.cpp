// Values of an axis from a to b, n of them: a + (b - a) i / (n - 1), or with spacing log
// a (b / a)^(i / (n - 1)). Random: u in [0, 1) in place of i / (n - 1), from seed, cell and axis by
// the mixing function of SplitMix64 (Steele, Lea, Flood 2014), so that any cell can be drawn alone.

#include "engine/sweep/sweep_plan.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "engine/base/text.h"
#include "engine/project/json/described_file.h"
#include "engine/project/json/field_writer.h"
#include "engine/project/json/text_file.h"
#include "engine/sweep/sweep_fields.h"
#include "engine/sweep/wrong_at.h"

namespace hazumi {

void ReadValue(const Json& json, const Site&, JsonValue& value) { value.text = CompactJson(json); }
Json ToJson(const JsonValue& value) { return FromText(value.text); }

namespace {

std::string PlaceOf(size_t axis) { return "vary[" + std::to_string(axis) + "]"; }

int SizeOf(const SweepAxis& axis) {
  return axis.values.empty() ? axis.count.value_or(0) : static_cast<int>(axis.values.size());
}

// As a person would write it: 0.3, not 0.30000000000000004.
std::string Decimal(double value, SweepSpacing spacing) {
  if (spacing == SweepSpacing::kWhole) value = std::round(value);
  constexpr int kDigits = 12;
  char text[32];
  const auto end =
      std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, kDigits)
          .ptr;
  std::from_chars(text, end, value);
  return FormatNumber(value);
}

// At a share of the way from `from` to `to`.
std::string NumberAt(const SweepAxis& axis, double share) {
  const double from = *axis.from, to = *axis.to;
  const double value = axis.spacing == SweepSpacing::kLog ? from * std::pow(to / from, share)
                                                          : from + (to - from) * share;
  return Decimal(value, axis.spacing);
}

std::uint64_t Mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::uint64_t Drawn(const SweepPlan& plan, long cell, size_t axis) {
  const auto seed = static_cast<std::uint64_t>(plan.seed);
  return Mixed(Mixed(Mixed(seed) ^ static_cast<std::uint64_t>(cell)) ^ axis);
}

std::string RandomValue(const SweepPlan& plan, long cell, size_t number) {
  const SweepAxis& axis = plan.vary[number];
  const std::uint64_t bits = Drawn(plan, cell, number);
  if (!axis.values.empty()) return axis.values[bits % axis.values.size()].text;
  return NumberAt(axis, static_cast<double>(bits >> 11) * 0x1p-53);
}

std::string ValueAt(const SweepAxis& axis, int number) {
  if (!axis.values.empty()) return axis.values[static_cast<size_t>(number)].text;
  const int last = *axis.count - 1;
  return NumberAt(axis, last > 0 ? static_cast<double>(number) / last : 0.0);
}

std::optional<Error> CheckAxis(const SweepAxis& axis, SweepCombine combine,
                               const std::string& place) {
  const bool is_range = axis.from && axis.to;
  if (axis.values.empty() && !is_range) {
    return WrongAt(place, "has no values: give \"values\", or \"from\" and \"to\"");
  }
  if (!axis.values.empty() && (axis.from || axis.to || axis.count)) {
    return WrongAt(place, "give either \"values\" or \"from\", \"to\" and \"count\"");
  }
  if (is_range && !axis.count && combine != SweepCombine::kRandom) {
    return WrongAt(place,
                   "\"count\" is missing: how many values there are from \"from\" to \"to\"");
  }
  if (axis.count && combine == SweepCombine::kRandom) {
    return WrongAt(place + ".count",
                   "belongs to the sweep as a whole where values are drawn at random");
  }
  if (is_range && axis.spacing == SweepSpacing::kLog && !(*axis.from > 0.0 && *axis.to > 0.0)) {
    return WrongAt(place, "with spacing \"log\" both ends must be greater than 0");
  }
  for (const std::string* field : FieldsOf(axis)) {
    const Result<FieldAddress> address = ParseAddress(*field);
    if (!address.ok()) return WrongAt(place, "\"" + *field + "\" " + address.error().message);
  }
  return std::nullopt;
}

std::optional<Error> CheckList(const SweepPlan& plan) {
  for (size_t i = 1; i < plan.vary.size(); ++i) {
    if (SizeOf(plan.vary[i]) == SizeOf(plan.vary[0])) continue;
    return WrongAt(PlaceOf(i), "has " + std::to_string(SizeOf(plan.vary[i])) +
                                   " values, vary[0] has " + std::to_string(SizeOf(plan.vary[0])) +
                                   ": in a list all have as many");
  }
  return std::nullopt;
}

double Cells(const SweepPlan& plan) {
  if (plan.combine == SweepCombine::kRandom) return plan.count.value_or(0);
  if (plan.combine == SweepCombine::kList) return SizeOf(plan.vary[0]);
  double cells = 1.0;
  for (const SweepAxis& axis : plan.vary) cells *= SizeOf(axis);
  return cells;
}

std::optional<Error> CheckPlan(const SweepPlan& plan) {
  if (plan.vary.empty()) return WrongAt("vary", "is empty: name a field and its values");
  for (size_t i = 0; i < plan.vary.size(); ++i) {
    if (auto error = CheckAxis(plan.vary[i], plan.combine, PlaceOf(i))) return error;
  }
  const bool is_random = plan.combine == SweepCombine::kRandom;
  if (is_random && !plan.count) return WrongAt("count", "is missing: how many cells are drawn");
  if (!is_random && plan.count) {
    return WrongAt("count", "goes with \"combine\": \"random\" alone; each axis has its own");
  }
  if (plan.combine == SweepCombine::kList) {
    if (auto error = CheckList(plan)) return error;
  }
  const double cells = Cells(plan);
  if (cells > kMostCells) {
    return WrongAt("vary", FormatShort(cells) + " cells; " + FormatShort(kMostCells) +
                               " are the most: give fewer values, or split the sweep");
  }
  if (plan.picture && plan.picture->frames.empty() && !plan.picture->video) {
    return WrongAt("picture", "say \"frames\": [16], or \"video\": true");
  }
  if (plan.picture && !plan.picture->frames.empty() && plan.picture->video) {
    return WrongAt("picture", "either \"frames\" or \"video\"");
  }
  return std::nullopt;
}

std::optional<Error> SetAll(const SweepAxis& axis, const std::string& value, Project* project) {
  for (const std::string* field : FieldsOf(axis)) {
    const Result<FieldAddress> address = ParseAddress(*field);
    if (!address.ok()) return address.error();
    const Result<Done> set = SetField(address.value(), value, project);
    if (!set.ok()) return set.error();
  }
  return std::nullopt;
}

// The values that are tried, each with its place behind the axis.
std::vector<std::pair<std::string, std::string>> TriedValues(const SweepAxis& axis) {
  std::vector<std::pair<std::string, std::string>> tried;
  for (size_t i = 0; i < axis.values.size(); ++i) {
    tried.emplace_back(".values[" + std::to_string(i) + "]", axis.values[i].text);
  }
  if (!axis.values.empty()) return tried;
  tried.emplace_back(".from", NumberAt(axis, 0.0));
  tried.emplace_back(".to", NumberAt(axis, 1.0));
  for (int i = 1; axis.count && i + 1 < *axis.count; ++i) {
    tried.emplace_back(".count", ValueAt(axis, i));
  }
  return tried;
}

}  // namespace

std::vector<const std::string*> FieldsOf(const SweepAxis& axis) {
  std::vector<const std::string*> fields = {&axis.field};
  for (const std::string& field : axis.also) fields.push_back(&field);
  return fields;
}

Result<SweepPlan> LoadSweep(const std::string& path) {
  const Result<std::string> text = ReadTextFile(path);
  if (!text.ok()) return text.error();
  KeepInput(path, InputKind::kSweep);
  return ParseSweep(text.value(), path);
}

Result<SweepPlan> ParseSweep(std::string_view text, const std::string& file_name) {
  return ParseDescribedFile<SweepPlan>(text, file_name, kSweepFormat, Check::kNotASweep,
                                       [](const SweepPlan& plan, FirstError* errors) {
                                         if (!errors->ok()) return;
                                         if (auto error = CheckPlan(plan)) errors->Report(*error);
                                       });
}

std::string WriteSweep(const SweepPlan& plan) { return FormatJson(ToJson(plan)); }

long CellCount(const SweepPlan& plan) { return static_cast<long>(Cells(plan)); }

std::vector<int> AxisSizes(const SweepPlan& plan) {
  std::vector<int> sizes;
  for (const SweepAxis& axis : plan.vary) {
    sizes.push_back(plan.combine == SweepCombine::kGrid ? SizeOf(axis)
                                                        : static_cast<int>(CellCount(plan)));
  }
  return sizes;
}

std::vector<int> AxisNumbers(const SweepPlan& plan, long cell) {
  std::vector<int> numbers = AxisSizes(plan);
  for (size_t i = numbers.size(); i-- > 0;) {
    const long size = numbers[i];
    numbers[i] = static_cast<int>(cell % size);
    if (plan.combine == SweepCombine::kGrid) cell /= size;
  }
  return numbers;
}

std::vector<std::string> ValuesOf(const SweepPlan& plan, long cell) {
  const std::vector<int> numbers = AxisNumbers(plan, cell);
  std::vector<std::string> values;
  for (size_t i = 0; i < plan.vary.size(); ++i) {
    values.push_back(plan.combine == SweepCombine::kRandom ? RandomValue(plan, cell, i)
                                                           : ValueAt(plan.vary[i], numbers[i]));
  }
  return values;
}

Result<Done> CheckFields(const SweepPlan& plan, const Project& project) {
  for (size_t i = 0; i < plan.vary.size(); ++i) {
    Project tried = project;
    for (const auto& [place, value] : TriedValues(plan.vary[i])) {
      auto error = SetAll(plan.vary[i], value, &tried);
      if (!error) continue;
      return WrongAt(PlaceOf(i) + place, error->place + " = " + value + ": " + error->message);
    }
  }
  return Done();
}

Result<Done> ApplyCell(const SweepPlan& plan, long cell, Project* project) {
  const std::vector<std::string> values = ValuesOf(plan, cell);
  for (size_t i = 0; i < values.size(); ++i) {
    if (auto error = SetAll(plan.vary[i], values[i], project)) return *error;
  }
  return Done();
}

}  // namespace hazumi
