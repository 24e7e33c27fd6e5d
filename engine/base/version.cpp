#include "engine/base/version.h"

namespace hazumi {

const char* const kVersion = HAZUMI_VERSION;

}  // namespace hazumi
