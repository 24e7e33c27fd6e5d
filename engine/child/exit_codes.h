#pragma once

namespace hazumi {

// How hazumi-reader ends. An error of the file is part of a good answer.
enum ReaderExit { kReaderAnswered = 0, kReaderUsage = 2, kReaderOutOfMemory = 3 };

}  // namespace hazumi
