#pragma once

// Our own bugs. A bad file is never an assertion: see result.h.
//   HAZUMI_DEMAND(cond)        checked in every build
//   HAZUMI_ASSERT(cond)        checked in debug builds only
//   HAZUMI_DEMAND_EQ(a, b)     prints both values

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace hazumi::internal {

[[noreturn]] inline void Die(const char* file, int line, const char* text) {
  std::fprintf(stderr, "hazumi: %s:%d: demand failed: %s\n", file, line, text);
  std::abort();
}

template <typename A, typename B>
void DemandEqual(const A& a, const B& b, const char* text, const char* file, int line) {
  if (a == b) return;
  std::ostringstream message;
  message << text << " (" << a << " vs " << b << ")";
  Die(file, line, message.str().c_str());
}

}  // namespace hazumi::internal

#define HAZUMI_DEMAND(cond) \
  ((cond) ? static_cast<void>(0) : ::hazumi::internal::Die(__FILE__, __LINE__, #cond))
#define HAZUMI_DEMAND_EQ(a, b) \
  ::hazumi::internal::DemandEqual((a), (b), #a " == " #b, __FILE__, __LINE__)

#ifdef NDEBUG
#define HAZUMI_ASSERT(cond) static_cast<void>(0)
#else
#define HAZUMI_ASSERT(cond) HAZUMI_DEMAND(cond)
#endif
