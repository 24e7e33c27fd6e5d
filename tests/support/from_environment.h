#pragma once

#include <cstdlib>

namespace hazumi::test {

// How much a random test is to do: HAZUMI_CASES, and HAZUMI_FIRST_CASE, the first seed.
inline int FromEnvironment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

}  // namespace hazumi::test
