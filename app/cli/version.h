#pragma once

namespace hazumi {

inline constexpr const char* kVersion = HAZUMI_VERSION;

}  // namespace hazumi
