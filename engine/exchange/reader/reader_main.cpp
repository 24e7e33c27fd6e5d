// hazumi-reader TASK MEMORY_BYTES CPU_SECONDS FILE CHARACTER RATE KEYS [TROUBLE]: under limits,
// reads a character (of several the one of this name, if it is not empty), its clips with so many
// frames a second (0: as many as they have), or the meshes of a thing, from FILE
// (character_bytes.h) or decodes the pictures of standard input (picture_bytes.h); writes them, or
// the error, to descriptor kChildOutput. KEYS: 1 if each frame becomes a key, else 0. Started by
// RunReader.

#include <malloc.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "engine/base/atomic_file.h"
#include "engine/base/memory.h"
#include "engine/child/child_process.h"
#include "engine/child/exit_codes.h"
#include "engine/child/reader_program.h"
#include "engine/exchange/character/character_bytes.h"
#include "engine/exchange/reader/read_here.h"
#include "engine/exchange/reader/whole_file.h"
#include "engine/picture/decode.h"

namespace {

void Limit(int resource, rlim_t soft, rlim_t hard) {
  const rlimit limit = {soft, hard};
  ::setrlimit(resource, &limit);
}

void LimitYourself(rlim_t memory, rlim_t cpu_seconds) {
  Limit(RLIMIT_CORE, 0, 0);
  Limit(RLIMIT_CPU, cpu_seconds, cpu_seconds + 1);
  Limit(RLIMIT_FSIZE, 0, 0);  // it writes to a pipe only
  if (!hazumi::kHasShadowMemory) Limit(RLIMIT_AS, memory, memory);
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

hazumi::Result<hazumi::Character> Read(hazumi::ReadUse use, const char* path,
                                       const hazumi::ReadChoice& choice) {
  try {
    return hazumi::ReadHere(use, path, choice);
  } catch (const std::exception& error) {
    return hazumi::Error{hazumi::ErrorCode::kFailed, path, "",
                         std::string("cannot be read (") + error.what() +
                             "); export it again, or in another format"};
  }
}

bool PassOn(const std::string& answer) { return hazumi::WriteAll(hazumi::kChildOutput, answer); }

bool DecodeStandardInput() {
  const hazumi::Result<std::string> request = hazumi::WholeFile("/dev/stdin", SIZE_MAX - 1);
  return request.ok() && hazumi::DecodeHere(request.value(), PassOn);
}

bool Do(const std::string& task, const char* file, const hazumi::ReadChoice& choice) {
  const auto pass_on = [&](hazumi::ReadUse use) {
    return PassOn(hazumi::CharacterToBytes(Read(use, file, choice)));
  };
  if (task == hazumi::kReadCharacter) return pass_on(hazumi::ReadUse::kCharacter);
  if (task == hazumi::kReadThing) return pass_on(hazumi::ReadUse::kThing);
  return task == hazumi::kDecodePictures && DecodeStandardInput();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 8) return hazumi::kReaderUsage;
  LimitYourself(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
  ::mallopt(M_PERTURB, 0xff);  // zeroes new memory of C libraries, except reused blocks
  if (argc > 8) MakeTrouble(argv[8]);
  const bool done =
      Do(argv[1], argv[4], {argv[5], std::strtod(argv[6], nullptr), argv[7][0] == '1'});
  // Without destructors: a library's may stumble over what a broken file made of its data.
  ::_exit(done ? hazumi::kReaderAnswered : hazumi::kReaderUsage);
}
