#include "engine/base/text.h"
#include "engine/exchange/character/character_check.h"
#include "engine/project/json/text_file.h"

namespace hazumi {

namespace {

// Keys that a project file holds, with 250 bytes of its JSON tree each, and the factor beyond which
// keys are refused by an estimate.
constexpr double kMostKeys = kMaxTreeBytes / 250.0, kFarTooMany = 1.15;

}  // namespace

std::optional<Error> WhyTooManyKeys(double curves, double frames, double seconds) {
  const double keys = curves * frames;
  if (keys <= kFarTooMany * kMostKeys) return std::nullopt;
  return Error{ErrorCode::kSemantics, "", "clip",
               "a key on each of its " + FormatShort(frames) + " frames (" +
                   FormatShort(seconds / 60.0) + " minutes) makes about " +
                   FormatShort(1e-6 * keys) + " million keys, of which a project holds " +
                   FormatShort(1e-6 * kMostKeys) +
                   " million; take keys only where they are needed (--reduce 1), fewer frames a "
                   "second (--fps), or a stretch of it"};
}

}  // namespace hazumi
