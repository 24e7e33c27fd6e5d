#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace hazumi {

// Something odd that stops nothing but that the animator should know. `place` is a path such as
// `regions[1].joints[3]`, as in Error.
struct Warning {
  // A field of a region that would put it right.
  enum class Remedy { kNone, kBlend, kLimitTangents };

  std::string place;
  std::string message;
  std::optional<int> frame = {};  // where it is seen, if at one frame
  Remedy remedy = Remedy::kNone;
};

// Index in a place such as "regions[1].joints[0]", if the place is of this list.
inline std::optional<size_t> IndexIn(std::string_view list, std::string_view place) {
  if (!place.starts_with(list) || !place.substr(list.size()).starts_with('[')) return std::nullopt;
  size_t index = 0;
  const auto read =
      std::from_chars(place.data() + list.size() + 1, place.data() + place.size(), index);
  return read.ec == std::errc() ? std::optional(index) : std::nullopt;
}

}  // namespace hazumi
