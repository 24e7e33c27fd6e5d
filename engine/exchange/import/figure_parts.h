#pragma once

// Internal. Parts of a figure that is made from bones: its skin, its links, their masses, and the
// ground under it.

#include <optional>
#include <string>
#include <vector>

#include "engine/exchange/import/joint_plan.h"
#include "engine/exchange/import/skeleton.h"
#include "engine/exchange/import/world_frame.h"
#include "engine/figure/figure_spec.h"
#include "engine/figure/skin.h"

namespace hazumi {

// The character's meshes, bound to the bodies of the figure that was planned: `bones` are its
// joints. Vertices stay as they are; the binds take them to metres.
Skin SkinFor(const Character& character, const Skeleton& skeleton, const FigurePlan& plan,
             const WorldFrame& world);

// Capsules from each joint to those beyond it, by kept bone, in the bodies' frames [m], without
// masses. Thick as the skin is there; without one as such a part of a body is, or a stick. Those of
// feet reach as far down as their skin does at rest.
std::vector<std::vector<LinkSpec>> LinksOf(const Character& character, const Skeleton& skeleton,
                                           const FigurePlan& plan, const Skin& skin,
                                           const WorldFrame& world);

// Links of a figure that Hazumi has written itself, by kept bone, with their masses; none unless
// the file says what hangs on each bone. In another unit than the file's they are as dense as they
// were. `mass`: of all together [kg], if it is asked for.
std::optional<std::vector<std::vector<LinkSpec>>> KnownLinks(const Character& character,
                                                             const Skeleton& skeleton,
                                                             const WorldFrame& world,
                                                             std::optional<double> mass);

// Volume of the mesh that each kept bone moves [m^3], at rest: what its part of the skin encloses,
// cut off at the joints. The volumes add up to that of the mesh; a part may be negative where
// surfaces cross. Nothing if the mesh encloses nothing: its holes are as large as itself, or there
// is no mesh.
std::vector<double> MeshVolumes(const Skin& skin, const FigurePlan& plan);

// Gives the links, by kept bone, masses [kg] that are `mass` together. Where the bones are those of
// a body (body_names.h) each segment of the table weighs what the table says, whatever bones it
// consists of, and its links share that by volume; segments that no bone stands for are left out,
// and all others are heavier by the same factor; a head that has far more of the mesh's volume than
// people's have weighs what that says. Else a bone weighs by the volume of the mesh that
// it moves, or without one by that of its links. Says which, in words that follow the mass.
std::string Weigh(const Skeleton& skeleton, const FigurePlan& plan, const Skin& skin, double mass,
                  std::vector<std::vector<LinkSpec>>* links);

// Returns the height of the ground under a figure that stands on it [m]: the lowest place in the
// clip, except in one frame of twenty, of the skin of its feet or, without a skin, of their
// capsules (`links`, by kept bone); where no bone is a foot, of all. 0 if that is within a few
// centimetres of 0.
double GroundUnder(const Skeleton& skeleton, const FigurePlan& plan, const Skin& skin,
                   const std::vector<std::vector<LinkSpec>>& links);

}  // namespace hazumi
