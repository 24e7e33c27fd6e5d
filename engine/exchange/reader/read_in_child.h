#pragma once

#include <functional>
#include <string>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"

namespace hazumi {

struct ReadLimits {
  double seconds = 10.0;          // on the clock
  size_t memory = 2048ull << 20;  // address space of the reading process [bytes]
  size_t answer = 512ull << 20;   // what it sends back [bytes]
};

struct ReadOptions {
  ReadLimits limits;
  std::function<bool()> is_cancelled;  // asked every 20 ms; may be empty
  std::string reader;                  // path of hazumi-reader; empty: ReaderPath()
  std::string trouble;                 // for tests: see reader_main.cpp
};

// Where the program is that reads files: $HAZUMI_READER if that is set, else `hazumi-reader` in the
// folder of this program or, as in a build tree, in one of the four folders above it. Empty: none.
std::string ReaderPath();

// Reads a file in a process of its own, so that whatever a broken file does to the reader, this
// program stays. What comes back has been checked. Errors name the file: kInterrupted when
// cancelled; kFailed when the reader is missing, crashed, or took too much time or memory.
Result<Character> ReadInChild(const std::string& path, const ReadOptions& options = {});

}  // namespace hazumi
