#pragma once

// A field of the document, by names from the outside in:
//   scene.gravity_m_s2
//   regions[arms].friction.default
//   regions[arms].friction.joints[r_wrist]
//   joints[r_elbow_flexion].keys[5].rate_deg_s
//   held_objects[ball].offset_m[z]
// A name is a field of the file; in brackets stands an item: of what has names its name, of keys
// their frame, of vectors the axis, else its number from 0. Names may hold spaces and dots.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/project/project.h"

namespace hazumi {

struct AddressStep {
  std::string name;
  bool is_item = false;  // in brackets
  bool operator==(const AddressStep&) const = default;
};

struct FieldAddress {
  std::vector<AddressStep> steps;
  bool operator==(const FieldAddress&) const = default;
};

// Errors: kSchema, with the address as the place.
Result<FieldAddress> ParseAddress(std::string_view text);
std::string TextOf(const FieldAddress& address);

// Sets one field; a field that may be left out comes to be. `json` is the value as it stands in a
// file: 0.8, "exact", [1, 0, 0]. Its type and range are checked, what spans several fields is not
// (CompileAnimation checks that). On failure the project may be changed in part.
// Errors: kSchema, with the address as the place: no such field or item, with the nearest one; a
// value of another type or out of range; kSyntax if it is not JSON.
Result<Done> SetField(const FieldAddress& address, std::string_view json, Project* project);

// The value as it stands in a file; "null" for a field that is left out and has no default.
// Errors: kSchema, as of SetField.
Result<std::string> GetField(const FieldAddress& address, const Project& project);

}  // namespace hazumi
