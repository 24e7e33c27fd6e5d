#pragma once

namespace hazumi {

// What `hazumi --help` prints; at most 80 columns wide.
extern const char* const kHelpText;

}  // namespace hazumi
