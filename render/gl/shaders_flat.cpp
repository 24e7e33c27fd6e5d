#include "render/gl/shaders.h"

namespace hazumi::render::shaders {

const char* const kSkyVertex = R"(
in vec2 a_0;
in vec3 a_1;
out vec3 color;
void main() {
  gl_Position = vec4(a_0, 1.0, 1.0);
  color = a_1;
}
)";

const char* const kSkyFragment = R"(
in vec3 color;
out vec4 picture;
void main() { picture = vec4(color, 1.0); }
)";

const char* const kFlatVertex = R"(
uniform float depth_shift;
in vec3 a_0;
in vec2 a_1;
in vec4 a_2;
out vec2 side;
flat out vec4 color;
void main() {
  gl_Position = vec4(a_0.xy, a_0.z + depth_shift, 1.0);
  side = a_1;
  color = a_2;
}
)";

const char* const kFlatFragment = R"(
in vec2 side;
flat in vec4 color;
out vec4 picture;
void main() {
  float cover = clamp(side.y + 0.5 - abs(side.x), 0.0, 1.0) * min(2.0 * side.y, 1.0);
  picture = vec4(color.rgb, color.a * cover);
}
)";

const char* const kPictureVertex = R"(
in vec4 a_0;
in vec2 a_1;
out vec2 place;
void main() {
  gl_Position = a_0;
  place = a_1;
}
)";

const char* const kPictureFragment = R"(
uniform sampler2D picture_map;
uniform float opacity;
in vec2 place;
out vec4 picture;
void main() { picture = vec4(texture(picture_map, place).rgb, opacity); }
)";

}  // namespace hazumi::render::shaders
