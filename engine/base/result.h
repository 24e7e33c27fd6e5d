#pragma once

// A value, or an Error about the user's input. The engine throws nothing.

#include <string>
#include <utility>
#include <variant>

#include "engine/base/assert.h"

namespace hazumi {

enum class ErrorCode {
  kSyntax,       // not JSON
  kSchema,       // JSON of the wrong shape: type, range, unknown name
  kSemantics,    // well formed, but it cannot be animated: overlap, out of reach, closed loop
  kNoInput,      // the file is not there or cannot be read
  kCannotWrite,  // the output cannot be written
  kFailed,       // something the program needs is missing or gives up: a library, a driver
  kInterrupted,  // the user asked to stop
};

// `place` is a path such as `regions[1].joints[3]` inside `file`; either may be empty.
// `message` is a sentence that says what is wrong and what to do about it.
struct Error {
  ErrorCode code = ErrorCode::kSchema;
  std::string file;
  std::string place;
  std::string message;

  // "file: place: message", leaving out what is empty.
  std::string ToString() const {
    std::string text;
    if (!file.empty()) text += file + ": ";
    if (!place.empty()) text += place + ": ";
    return text + message;
  }
};

template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : storage_(std::move(value)) {}      // NOLINT: implicit on purpose
  Result(Error error) : storage_(std::move(error)) {}  // NOLINT: implicit on purpose

  bool ok() const { return std::holds_alternative<T>(storage_); }
  const T& value() const& {
    HAZUMI_DEMAND(ok());
    return std::get<T>(storage_);
  }
  T& value() & {
    HAZUMI_DEMAND(ok());
    return std::get<T>(storage_);
  }
  T&& value() && {
    HAZUMI_DEMAND(ok());
    return std::get<T>(std::move(storage_));
  }
  const Error& error() const {
    HAZUMI_DEMAND(!ok());
    return std::get<Error>(storage_);
  }

 private:
  std::variant<T, Error> storage_;
};

// For calls that only succeed or fail: Result<Done>.
struct Done {};

}  // namespace hazumi
