#include "app/cli/interrupt.h"

#include <csignal>

namespace hazumi {

std::atomic<bool>& Interrupted() {
  static std::atomic<bool> interrupted = false;
  return interrupted;
}

void CatchInterrupts() {
  Interrupted();  // constructed before any signal
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int number) {
      Interrupted() = true;
      std::signal(number, SIG_DFL);
    });
  }
}

}  // namespace hazumi
