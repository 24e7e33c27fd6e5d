#pragma once

#include <new>

#include "engine/base/result.h"

namespace hazumi {

inline Error OutOfMemory() {
  return {ErrorCode::kFailed, "", "", "there is not enough memory for it"};
}

// What work() returns, or an Error where the memory does not suffice: for threads, which would
// otherwise end the program, and for whoever can go on without.
template <typename Work>
auto WithinMemory(Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return OutOfMemory();
  }
}

}  // namespace hazumi
