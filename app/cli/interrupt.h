#pragma once

#include <atomic>

namespace hazumi {

// Set when the user presses Ctrl+C, closes the terminal, or asks the program to end. A second time
// ends it at once. A signal that the parent ignores (nohup, a job in the background) stays ignored.
std::atomic<bool>& Interrupted();
void CatchInterrupts();
// From here on a signal ends the program at once.
void LeaveInterruptsAlone();

}  // namespace hazumi
