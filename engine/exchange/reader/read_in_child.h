#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/child/reader_program.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/content.h"

namespace hazumi {

// Reads a file in a process of its own (engine/child). What comes back has been checked. Errors
// name the file: kInterrupted when cancelled; kFailed when the reader is missing; kSyntax when the
// file made it crash, or take too much time or memory.
Result<Character> ReadInChild(ReadUse use, const std::string& path,
                              const ReadOptions& options = {});

}  // namespace hazumi
