#pragma once

#include <cstring>
#include <vector>

namespace hazumi {

// Whether numbers are the same, NaN and the sign of zero included.
inline bool SameBits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace hazumi
