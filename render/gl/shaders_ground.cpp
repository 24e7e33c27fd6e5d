// The ground is mixed in displayed colours: floor and pattern, darkened by shadow and occlusion,
// fading to the horizon with the squared distance from the centre of interest. No light is
// computed, since floor and light are both even.
// Pattern, smoothed analytically over the pixel's footprint w: grid lines cover
// 0.5 + (half - g) / w of it at distance g from the nearest line, at least 0 and at most 2 half / w
// or 1; for checkers it is the box filter of the square wave.

#include "render/gl/shaders.h"

namespace hazumi::render::shaders {

const char* const kGroundVertex = R"(
uniform mat4 clip_from_world;
uniform mat4 shadow_from_world;
uniform vec4 center;        // centre of interest x, y; height; 1 / radius
uniform vec4 shaded_rect;   // min x, y; 1 / size x, y
in vec2 a_0;
out vec2 plane;
out vec2 from_center;
#ifdef SHADED
out vec3 shadow;
out vec2 shade_at;
#endif
void main() {
  vec4 world = vec4(a_0, center.z, 1.0);
  gl_Position = clip_from_world * world;
  plane = a_0;
  from_center = (a_0 - center.xy) * center.w;
#ifdef SHADED
  shadow = (shadow_from_world * world).xyz;
  shade_at = (a_0 - shaded_rect.xy) * shaded_rect.zw;
#endif
}
)";

const char* const kGroundFragment = R"(
uniform vec4 floor_srgb;
uniform vec4 pattern_srgb;
uniform vec4 horizon_srgb;
uniform vec4 shadow_tint;   // factor on displayed colour where no key light comes
uniform vec4 occlusion_tint;
uniform vec4 shadow_step;
uniform sampler2DShadow shadow_map;
uniform sampler2D openness;
in vec2 plane;
in vec2 from_center;
#ifdef SHADED
in vec3 shadow;
in vec2 shade_at;
#endif
out vec4 picture;

float Pattern(vec2 w) {
#ifdef CHECKER
  vec2 i = (abs(fract((plane - 0.5 * w) * 0.5) - 0.5) - abs(fract((plane + 0.5 * w) * 0.5) - 0.5));
  i *= 2.0 / w;
  return 0.5 - 0.5 * i.x * i.y;
#else
  vec2 major = abs(fract(plane - 0.5) - 0.5);
  vec2 minor = abs(fract(plane * 4.0 - 0.5) - 0.5) * 0.25;
  vec2 per_w = 1.0 / w;
  vec2 a = min(max(0.5 + (0.009 - major) * per_w, 0.0), min(0.018 * per_w, 1.0));
  vec2 b = min(max(0.5 + (0.003 - minor) * per_w, 0.0), min(0.006 * per_w, 1.0));
  return max(max(a.x, a.y), 0.55 * max(b.x, b.y));
#endif
}

void main() {
  vec2 w = max(abs(dFdx(plane)) + abs(dFdy(plane)), vec2(1e-5));
  float far = clamp(dot(from_center, from_center), 0.0, 1.0);
  float keep = (1.0 - far) * (1.0 - far);
  vec3 c = mix(floor_srgb.rgb, pattern_srgb.rgb, Pattern(w) * keep);
#ifdef SHADED
  vec2 d = shadow_step.xy;
  float lit = 0.25 * (texture(shadow_map, shadow + vec3(-0.6 * d.x, -1.6 * d.y, 0.0)) +
                      texture(shadow_map, shadow + vec3(1.6 * d.x, -0.6 * d.y, 0.0)) +
                      texture(shadow_map, shadow + vec3(-1.6 * d.x, 0.6 * d.y, 0.0)) +
                      texture(shadow_map, shadow + vec3(0.6 * d.x, 1.6 * d.y, 0.0)));
  float open = texture(openness, shade_at).r;
  c *= mix(shadow_tint.rgb, vec3(1.0), lit) * mix(occlusion_tint.rgb, vec3(1.0), open);
#endif
  picture = vec4(mix(horizon_srgb.rgb, c, keep), 1.0);
}
)";

}  // namespace hazumi::render::shaders
