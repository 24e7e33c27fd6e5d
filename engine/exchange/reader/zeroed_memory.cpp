// Allocation of C++ memory in hazumi-reader, in all forms but over-aligned ones. New memory is
// zero, so that a file has one result even if a library reads memory that it has not set. This file
// is compiled by itself: g++ takes inlined calls of these functions for mismatched ones.

#include <unistd.h>

#include <cstdlib>
#include <new>

#include "engine/child/exit_codes.h"

namespace {
void* Zeroed(size_t size) { return std::calloc(1, size > 0 ? size : 1); }
}  // namespace

void* operator new(size_t size) {
  void* memory = Zeroed(size);
  if (!memory) ::_exit(hazumi::kReaderOutOfMemory);
  return memory;
}
void* operator new[](size_t size) { return operator new(size); }
void* operator new(size_t size, const std::nothrow_t&) noexcept { return Zeroed(size); }
void* operator new[](size_t size, const std::nothrow_t&) noexcept { return Zeroed(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
