#pragma once

// Counts the heap allocations of the program it is linked into (glibc, not under a sanitizer).

namespace hazumi::test {

bool CanCountAllocations();
long AllocationCount();  // by this program since it started

}  // namespace hazumi::test
