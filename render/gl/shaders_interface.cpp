#include "render/gl/shaders.h"

namespace hazumi::render::shaders {

const char* const kInterfaceVertex = R"(
uniform vec4 size;
in vec2 a_0;
in vec2 a_1;
in vec4 a_2;
out vec2 place;
out vec4 color;
void main() {
  gl_Position = vec4(2.0 * a_0.x / size.x - 1.0, 1.0 - 2.0 * a_0.y / size.y, 0.0, 1.0);
  place = a_1;
  color = a_2;
}
)";

const char* const kInterfaceFragment = R"(
uniform sampler2D picture;
in vec2 place;
in vec4 color;
out vec4 pixel;
void main() { pixel = color * texture(picture, place); }
)";

const char* const kInterfaceSolidFragment = R"(
in vec4 color;
out vec4 pixel;
void main() { pixel = color; }
)";

}  // namespace hazumi::render::shaders
