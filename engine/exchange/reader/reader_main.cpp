// hazumi-reader FILE MEMORY_BYTES CPU_SECONDS [TROUBLE]: reads a character under limits and writes
// it, or the error, to descriptor kChildOutput (see character_bytes.h). Started by ReadInChild.

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "engine/base/atomic_file.h"
#include "engine/exchange/character/character_bytes.h"
#include "engine/exchange/reader/child_process.h"
#include "engine/exchange/reader/exit_codes.h"
#include "engine/exchange/reader/read_here.h"

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kHasShadowMemory = true;  // needs terabytes of addresses
#else
constexpr bool kHasShadowMemory = false;
#endif

void Limit(int resource, rlim_t soft, rlim_t hard) {
  const rlimit limit = {soft, hard};
  ::setrlimit(resource, &limit);
}

void LimitYourself(rlim_t memory, rlim_t cpu_seconds) {
  Limit(RLIMIT_CORE, 0, 0);
  Limit(RLIMIT_CPU, cpu_seconds, cpu_seconds + 1);
  Limit(RLIMIT_FSIZE, 0, 0);  // it writes to a pipe only
  if (!kHasShadowMemory) Limit(RLIMIT_AS, memory, memory);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // ends with the program that asked
  // Before any library turns it into something less clear.
  std::set_new_handler([] { ::_exit(hazumi::kReaderOutOfMemory); });
}

// What a broken file might do to a library, on demand of the tests.
void MakeTrouble(const char* kind) {
  if (std::strcmp(kind, "crash") == 0) ::raise(SIGSEGV);
  while (std::strcmp(kind, "hang") == 0) ::pause();
  volatile unsigned turns = 0;
  while (std::strcmp(kind, "spin") == 0) turns = turns + 1;
  while (std::strcmp(kind, "flood") == 0)
    hazumi::WriteAll(hazumi::kChildOutput, std::string(1u << 20, 'x'));
  if (std::strcmp(kind, "allocate") == 0)
    for (int i = 0; i < 64; ++i) std::memset(::operator new(64u << 20), 1, 64u << 20);  // 4 GB
  if (std::strcmp(kind, "garbage") == 0) {
    hazumi::WriteAll(hazumi::kChildOutput, "not a character");
    ::_exit(hazumi::kReaderAnswered);
  }
}

hazumi::Result<hazumi::Character> Read(const char* path) {
  try {
    return hazumi::ReadHere(path);
  } catch (const std::exception& error) {
    return hazumi::Error{hazumi::ErrorCode::kFailed, path, "",
                         std::string("cannot be read (") + error.what() +
                             "); export it again, or in another format"};
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return hazumi::kReaderUsage;
  LimitYourself(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
  if (argc > 4) MakeTrouble(argv[4]);
  const bool written =
      hazumi::WriteAll(hazumi::kChildOutput, hazumi::CharacterToBytes(Read(argv[1])));
  // Without destructors: a library's may stumble over what a broken file made of its data.
  ::_exit(written ? hazumi::kReaderAnswered : hazumi::kReaderUsage);
}
