#pragma once

#include "engine/base/result.h"

namespace hazumi {

// As sysexits.h where it has a fitting one.
enum ExitCode {
  kExitOk = 0,
  kExitFailed = 1,
  kExitUsage = 2,
  kExitBadData = 65,
  kExitNoInput = 66,
  kExitCannotWrite = 73,
  kExitInterrupted = 130,
};

inline ExitCode ExitCodeOf(const Error& error) {
  switch (error.code) {
    case ErrorCode::kNoInput:
      return kExitNoInput;
    case ErrorCode::kFailed:
      return kExitFailed;
    case ErrorCode::kInterrupted:
      return kExitInterrupted;
    case ErrorCode::kCannotWrite:
      return kExitCannotWrite;
    case ErrorCode::kSyntax:
    case ErrorCode::kSchema:
    case ErrorCode::kSemantics:
      return kExitBadData;
  }
  return kExitFailed;
}

}  // namespace hazumi
