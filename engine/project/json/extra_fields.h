#pragma once

#include <string>
#include <vector>

namespace hazumi {

// A field of a file that this Hazumi does not know, kept so that it survives load and save.
struct ExtraField {
  std::string name;
  std::string json;  // its value as JSON text
  bool operator==(const ExtraField&) const = default;
};

// The unknown fields of one JSON object, in the order of the file.
using ExtraFields = std::vector<ExtraField>;

}  // namespace hazumi
