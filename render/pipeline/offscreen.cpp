#include "render/pipeline/offscreen.h"

#include <utility>

namespace hazumi::render {
namespace {

bool MakeCurrent(OsmesaContext& context, Image& image) {
  return context.MakeCurrent(image.rgba.data(), image.width, image.height);
}

Error Refused(const Image& image) {
  return {ErrorCode::kFailed, "", "OSMesa",
          "Mesa refuses a picture of " + std::to_string(image.width) + " x " +
              std::to_string(image.height) + " pixels; choose another size"};
}

}  // namespace

Result<OffscreenRenderer> OffscreenRenderer::Create(const RendererOptions& options) {
  Result<OsmesaContext> context = OsmesaContext::Create();
  if (!context.ok()) return context.error();
  auto buffer = std::make_unique<Image>(16, 16);
  if (!MakeCurrent(context.value(), *buffer)) return Refused(*buffer);
  Result<Renderer> renderer = Renderer::Create(context.value().loader(), options);
  if (!renderer.ok()) return renderer.error();
  return OffscreenRenderer(std::move(buffer), std::move(context).value(),
                           std::move(renderer).value());
}

OffscreenRenderer::OffscreenRenderer(std::unique_ptr<Image> first_buffer, OsmesaContext context,
                                     Renderer renderer)
    : first_buffer_(std::move(first_buffer)),
      context_(std::make_unique<OsmesaContext>(std::move(context))),
      renderer_(std::make_unique<Renderer>(std::move(renderer))) {}

// GL objects are deleted in their own context, with a buffer that still exists.
OffscreenRenderer::~OffscreenRenderer() {
  if (context_ != nullptr) MakeCurrent(*context_, *first_buffer_);
}

Result<Done> OffscreenRenderer::Draw(const Scene& scene, Image& image) {
  if (image.width < 1 || image.height < 1 || !MakeCurrent(*context_, image)) return Refused(image);
  Result<Done> drawn = renderer_->Draw(scene, {image.width, image.height});
  if (drawn.ok()) renderer_->Finish();
  return drawn;
}

}  // namespace hazumi::render
