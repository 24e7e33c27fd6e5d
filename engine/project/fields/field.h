#pragma once

#include <array>
#include <cstddef>
#include <string>

// What is said once of a field of the document. From it follow the reader, the writer, the checks,
// the schema, the operators' parameters, and the rows of forms and properties: see Describe in
// project_fields.h.

namespace hazumi {

// Numbers lie between this and its negative.
inline constexpr double kLargestNumber = 1e9;

struct NumberRange {
  double lower = -kLargestNumber, upper = kLargestNumber;
  bool is_above = false;  // greater than `lower`, not equal to it
  bool operator==(const NumberRange&) const = default;
};
inline constexpr NumberRange kNotNegative = {0.0, kLargestNumber};
inline constexpr NumberRange kPositive = {0.0, kLargestNumber, true};
inline constexpr NumberRange kShare = {0.0, 1.0};

// What a text or a number names.
enum class Thing {
  kAny,
  kJoint,
  kHinge,
  kJointOrHinge,
  kJointOrRoot,
  kCurve,
  kRegion,
  kObject,
  kHeldObject,
  kLink,
  kMarker,     // by its number, as are the next two
  kPlacement,  // a span of it
  kHold,
  kSelectionSet,
  kForce,
  kSceneOrHeldObject,
  kConstraint,
  kFill,
  kGoal,
  kHolder,  // of an object; no parameter names it
  kColor,   // "#rrggbb"
};
// "names a joint" and so on.
constexpr const char* Describe(Thing thing) {
  constexpr const char* kThings[] = {"",
                                     "names a joint",
                                     "names a hinge",
                                     "names a joint or hinge",
                                     "names a joint or the root",
                                     "names a curve",
                                     "names a region",
                                     "names an object",
                                     "names a held object",
                                     "names a link",
                                     "number of a marker",
                                     "number of a span of placement",
                                     "number of a hold",
                                     "names a selection set",
                                     "names a force",
                                     "names an object, of the scene or held",
                                     "names a constraint",
                                     "names a fill",
                                     "names a goal",
                                     "",
                                     "a colour"};
  static_assert(sizeof kThings / sizeof *kThings == static_cast<size_t>(Thing::kColor) + 1);
  return kThings[static_cast<size_t>(thing)];
}

struct Field {
  const char* name;            // in the file
  const char* parameter = "";  // of operators, where it differs; of vectors with ? for the axis
  const char* label = "";      // as the window shows it; empty: no operator sets it by itself
  const char* help = "";       // a clause: what the number or the text says
  const char* details = "";    // sentences, for the schema
  const char* unit = "";       // "s", "m", "°", as it is shown
  NumberRange range = {};      // of numbers, also in lists and vectors
  double step = 0.01;          // that a hand means when it drags the number a little
  const char* axes = "xyz";    // of vectors, in the file's order
  Thing thing = Thing::kAny;   // of texts
  bool is_filled = false;      // of texts and lists: never empty
  bool may_be_none = false;    // of texts that name a thing: empty says something, too
};

constexpr const char* ParameterOf(const Field& field) {
  return field.parameter[0] == '\0' ? field.name : field.parameter;
}

// The unit as it stands behind a number: " m", but "°"; empty if there is none.
inline std::string Suffix(const Field& field) {
  const std::string unit = field.unit;
  return unit.empty() || unit.starts_with("°") ? unit : " " + unit;
}

// What the schema says of a struct: a name for its definition and sentences about it.
struct StructInfo {
  const char* name;
  const char* text;
};
template <typename T>
inline constexpr StructInfo kStructInfo = {"", ""};

// Labels of what adds an item, one for each kind; none for items without kinds, whose operator has
// a label.
template <typename Item>
inline constexpr std::array<const char*, 0> kAddLabels = {};

template <typename Archive, typename T>
using Ref = typename Archive::template RefTo<T>;

}  // namespace hazumi
