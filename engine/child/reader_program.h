#pragma once

// hazumi-reader, the program that opens what strangers wrote, so that whatever a broken file does
// to a library, this program stays.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/child/child_process.h"

namespace hazumi {

struct ReadLimits {
  double seconds = 10.0;          // on the clock
  size_t memory = 2048ull << 20;  // address space of the reading process [bytes]
  size_t answer = 512ull << 20;   // what it sends back [bytes]
};

struct ReadOptions {
  ReadLimits limits;
  std::function<bool()> is_cancelled;  // asked every 20 ms; may be empty
  std::string character;               // of several in a file, by name; empty: as it comes
  double rate = 0.0;                   // frames a second of its clips; 0: as they come
  bool keys_all_frames = false;        // see ReadChoice
  std::string reader;                  // path of hazumi-reader; empty: ReaderPath()
  std::string trouble;                 // for tests: see reader_main.cpp
};

// Path of the reader: `hazumi-reader` in the folder of this program or, as it is installed, in
// ../libexec/hazumi from there; nowhere else. Empty: none.
std::string ReaderPath();
// Path of the reader for a program that lies elsewhere, as the tests do. To be called at its start.
void SetReaderPath(const std::string& path);

// What the reader can do: a character or the meshes of a thing, from the file named; pictures, from
// the input (see engine/picture/picture_bytes.h).
inline constexpr const char* kReadCharacter = "character";
inline constexpr const char* kReadThing = "thing";
inline constexpr const char* kDecodePictures = "pictures";

struct ReaderTask {
  std::string kind;  // one of these
  std::string file;  // to read; may be empty
  std::string_view input;
};

// Runs the reader to its end. Errors (kFailed): it is missing or cannot be started.
Result<ChildOutcome> RunReader(const ReaderTask& task, const ReadOptions& options);

// Why the reader gave no answer, as "reading it crashed"; none: it did. The code is kInterrupted if
// it was cancelled, kFailed if the reader itself is not sound, and kSyntax, since the file must be
// broken, if it crashed, hung or swelled.
std::optional<Error> WhyNoAnswer(const ChildOutcome& outcome, const ReadLimits& limits);

}  // namespace hazumi
