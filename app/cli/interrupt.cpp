#include "app/cli/interrupt.h"

#include <csignal>

namespace hazumi {

std::atomic<bool>& Interrupted() {
  static std::atomic<bool> interrupted = false;
  return interrupted;
}

void CatchInterrupts() {
  Interrupted();  // constructed before any signal
  struct sigaction action = {};
  action.sa_handler = [](int) { Interrupted() = true; };
  action.sa_flags = SA_RESETHAND;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction inherited = {};
    sigaction(signal, nullptr, &inherited);
    if (inherited.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

void LeaveInterruptsAlone() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction caught = {};
    sigaction(signal, nullptr, &caught);
    if (caught.sa_handler != SIG_IGN) std::signal(signal, SIG_DFL);
  }
}

}  // namespace hazumi
