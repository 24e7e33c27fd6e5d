#pragma once

namespace hazumi::render::shaders {

// GLSL 3.30 sources without the version line. Uniforms are explained where they are used. Colours
// named *_srgb are written as they are; the picture is stored sRGB-encoded and is never encoded by
// the framebuffer, which keeps the cost to once a fragment.

// Solids, lit. a_0 position, a_1 normal (world), a_2 linear colour. With SKIN: a_2 tint (root of
// linear colour times share, share), a_3 place in the texture; with TWO_SIDED too, both sides are
// seen; with CUTOUT too, the texture's alpha cuts holes.
extern const char* const kSolidVertex;
extern const char* const kSolidFragment;

// Solids, depth only. With SKIN and CUTOUT as above.
extern const char* const kDepthVertex;
extern const char* const kDepthFragment;

// The ground. a_0 world x, y. Defines: CHECKER or not, SHADED (with shadow map, occlusion) or not.
extern const char* const kGroundVertex;
extern const char* const kGroundFragment;

// Colours between vertices: the sky. a_0 position (device), a_1 srgb colour.
extern const char* const kSkyVertex;
extern const char* const kSkyFragment;

// Marks and text. a_0 position (device), a_1 (side_px, half_width_px), a_2 srgb colour.
extern const char* const kFlatVertex;
extern const char* const kFlatFragment;

// Interfaces. a_0 pixels from the upper left corner, a_1 place in the texture, a_2 srgb colour.
extern const char* const kInterfaceVertex;
extern const char* const kInterfaceFragment;
extern const char* const kInterfaceSolidFragment;
extern const char* const kPictureVertex;
extern const char* const kPictureFragment;

}  // namespace hazumi::render::shaders
