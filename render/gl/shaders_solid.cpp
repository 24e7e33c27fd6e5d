// Light on solids, in linear colour c:
//   c * (key * lit * wrap(n.l) + mix(below, above, n.z) + fill * max(n.f, 0))
//     + lit * gloss * Blinn-Phong + rim * (1 - n.v)^3 + emission
// key light with a wrap that softens the terminator, ambient light from sky and floor, a weak fill
// from the viewer's side, and a rim of sky light that parts the figure from the background.

#include "render/gl/shaders.h"

namespace hazumi::render::shaders {

const char* const kSolidVertex = R"(
uniform mat4 clip_from_world;
uniform mat4 shadow_from_world;
uniform float shadow_offset_m;
in vec3 a_0;
in vec3 a_1;
in vec4 a_2;
out vec3 normal;
out vec3 world;
#ifdef SKIN
out vec4 tint;
#ifdef TEXTURED
in vec2 a_3;
out vec2 texture_at;
#endif
#ifdef COLORED
in vec3 a_4;
out vec3 vertex_linear;
#endif
#else
flat out vec4 color;
#endif
#ifndef TWO_SIDED
out vec3 shadow;
#endif
invariant gl_Position;
void main() {
  gl_Position = clip_from_world * vec4(a_0, 1.0);
  normal = a_1;
  world = a_0;
#ifdef SKIN
  tint = a_2;
#ifdef TEXTURED
  texture_at = a_3;
#endif
#ifdef COLORED
  vertex_linear = a_4;
#endif
#else
  color = a_2;
#endif
#ifndef TWO_SIDED
  shadow = (shadow_from_world * vec4(a_0 + shadow_offset_m * a_1, 1.0)).xyz;
#endif
}
)";

const char* const kSolidFragment = R"(
uniform sampler2DShadow shadow_map;
uniform vec4 eye;
uniform vec4 to_light;
uniform vec4 to_fill;
uniform vec4 key_linear;
uniform vec4 above_linear;
uniform vec4 below_linear;
uniform vec4 fill_linear;
uniform vec4 rim_linear;
uniform float ground_height;
uniform float ghost;        // 1: see-through in the middle, denser at the rim
in vec3 normal;
in vec3 world;
#ifdef SKIN
uniform vec4 base_linear;   // factor on the texture
uniform float alpha;
in vec4 tint;
#ifdef TEXTURED
uniform sampler2D base_texture;
in vec2 texture_at;
#endif
#ifdef COLORED
in vec3 vertex_linear;
#endif
#ifdef EMISSIVE
uniform vec4 emission_linear;
#ifdef TEXTURED
uniform sampler2D emission_texture;
#endif
#endif
#else
flat in vec4 color;
#endif
out vec4 picture;

#ifndef TWO_SIDED
in vec3 shadow;
#else
uniform mat4 shadow_from_world;
uniform float shadow_offset_m;

// The normal on the seen side of the triangle, whichever way its vertices go around; of a surface
// without normals, the triangle's own.
vec3 SeenNormal(vec3 v) {
  vec3 facet = cross(dFdx(world), dFdy(world));
  facet *= dot(facet, v) < 0.0 ? -1.0 : 1.0;
  if (dot(normal, normal) < 1e-4) return normalize(facet);
  return normalize(normal) * (dot(normal, facet) < 0.0 ? -1.0 : 1.0);
}
#endif

// Linear to sRGB by a fit in roots, within 0.1 % of the exact curve.
vec3 Encode(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 s1 = sqrt(c), s2 = sqrt(s1), s3 = sqrt(s2);
  return 0.662002687 * s1 + 0.684122060 * s2 - 0.323583601 * s3 - 0.0225411470 * c;
}

void main() {
  vec3 v = normalize(eye.xyz - world);
#ifdef SKIN
#ifdef TEXTURED
  vec4 texel = texture(base_texture, texture_at);
#else
  vec4 texel = vec4(1.0);
#endif
#ifdef CUTOUT
  if (texel.a < 0.5) discard;
#endif
#ifdef COLORED
  texel.rgb *= max(vertex_linear, 0.0);
#endif
  // Mixed about as seen: roots are near to displayed colours.
  vec3 root = sqrt(texel.rgb * base_linear.rgb) * (1.0 - tint.a) + tint.rgb;
  vec4 color = vec4(root * root, alpha);
#endif
#ifdef TWO_SIDED
  vec3 n = SeenNormal(v);
  vec3 shadow = (shadow_from_world * vec4(world + shadow_offset_m * n, 1.0)).xyz;
#else
  vec3 n = normalize(normal);
#endif
  float facing = dot(n, to_light.xyz);
  float lit = texture(shadow_map, shadow) * smoothstep(-0.05, 0.25, facing);
  float wrap = clamp(0.86 * facing + 0.14, 0.0, 1.0);
  float near_floor = clamp((world.z - ground_height) * 2.2, 0.0, 1.0);
  vec3 ambient = mix(below_linear.rgb, above_linear.rgb, 0.5 + 0.5 * n.z);
  ambient *= mix(0.62, 1.0, near_floor);
  float grazing = 1.0 - clamp(dot(n, v), 0.0, 1.0);
  float rim = grazing * grazing * grazing;
  float gloss = clamp(dot(n, normalize(v + to_light.xyz)), 0.0, 1.0);
  gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss; gloss *= gloss;
  vec3 light = key_linear.rgb * (lit * wrap) + ambient +
               fill_linear.rgb * max(dot(n, to_fill.xyz), 0.0);
  vec3 c = color.rgb * light + key_linear.rgb * (0.085 * lit * gloss) +
           rim_linear.rgb * (rim * (0.6 + 0.4 * n.z));
#ifdef EMISSIVE
  vec3 emission = emission_linear.rgb;
#ifdef TEXTURED
  emission *= texture(emission_texture, texture_at).rgb;
#endif
  c += emission * (1.0 - tint.a);
#endif
  picture = vec4(Encode(c), mix(1.0, color.a * mix(0.55, 1.0, grazing), ghost));
}
)";

const char* const kDepthVertex = R"(
uniform mat4 clip_from_world;
in vec3 a_0;
#ifdef CUTOUT
in vec2 a_3;
out vec2 texture_at;
#endif
invariant gl_Position;
void main() {
  gl_Position = clip_from_world * vec4(a_0, 1.0);
#ifdef CUTOUT
  texture_at = a_3;
#endif
}
)";

const char* const kDepthFragment = R"(
#ifdef CUTOUT
uniform sampler2D base_texture;
in vec2 texture_at;
#endif
void main() {
#ifdef CUTOUT
  if (texture(base_texture, texture_at).a < 0.5) discard;
#endif
}
)";

}  // namespace hazumi::render::shaders
