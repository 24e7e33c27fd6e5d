#pragma once

#include <optional>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"

namespace hazumi {

// More than this is a broken file, not a character.
struct CharacterLimits {
  size_t bones = 10'000;
  size_t clips = 10'000;
  size_t frames = 2'000'000;    // of a clip
  size_t samples = 40'000'000;  // entries of all tracks
  size_t meshes = 20'000, vertices = 10'000'000, triangles = 20'000'000;
  double longest = 1e9;  // any length, in the file's unit
};

// Whether a character keeps what character.h promises: indices in range, parents first, names
// unique, numbers finite, rotations and weights normalized, lists as long as they must be.
// Error (kSemantics): names the bone, clip or mesh.
Result<Done> CheckCharacter(const Character& character, const std::string& file,
                            const CharacterLimits& limits = {});

// Error (kSemantics) if a key on each of `frames` frames in `seconds`, for each of `curves` curves,
// is far more than a project holds. All three may be estimates.
std::optional<Error> WhyTooManyKeys(double curves, double frames, double seconds);

}  // namespace hazumi
