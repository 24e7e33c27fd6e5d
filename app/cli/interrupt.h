#pragma once

#include <atomic>

namespace hazumi {

// Set when the user presses Ctrl+C or the program is asked to end. A second time ends it at once.
std::atomic<bool>& Interrupted();
void CatchInterrupts();

}  // namespace hazumi
