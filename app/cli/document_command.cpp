#include <cstdio>

#include "app/cli/commands.h"
#include "app/cli/completion.h"
#include "app/cli/exit_codes.h"
#include "app/cli/man_page.h"

namespace hazumi {

int RunManual() {
  std::fputs(ManPage().c_str(), stdout);
  return kExitOk;
}

int RunCompletion(const Options& options) {
  std::fputs(CompletionFor(options.shell).c_str(), stdout);
  return kExitOk;
}

}  // namespace hazumi
