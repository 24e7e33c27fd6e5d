#pragma once

// Records of an FBX file, binary or text, as far as they say how nodes move: what assimp drops.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hazumi {

// A property of a record: one of these.
struct FbxValue {
  std::optional<int64_t> whole;
  std::optional<double> real;
  std::optional<std::string> text;
  std::vector<double> numbers;  // of an array
  std::vector<int64_t> wholes;  // of an array of whole numbers

  double number() const { return real ? *real : whole ? static_cast<double>(*whole) : 0.0; }
};

struct FbxRecord {
  std::string name;
  std::vector<FbxValue> values;
  std::vector<FbxRecord> children;

  const FbxRecord* Find(std::string_view child) const;  // the first; null: none
  // Empty or 0 where there is none.
  std::string Text(size_t value) const;
  int64_t Whole(size_t value) const;
};

// The version, such as 7400; 0: the bytes do not say it.
int FbxVersion(std::string_view bytes);

// The records Objects and Connections, of Objects only models and what moves them. None: the bytes
// are not as FBX has them, or hold more than a file of that length can.
std::optional<FbxRecord> ReadFbxRecords(std::string_view bytes);

}  // namespace hazumi
