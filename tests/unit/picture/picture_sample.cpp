#include "tests/unit/picture/picture_sample.h"

#include <cstdlib>

#include "render/image/png.h"

namespace hazumi::test {

Image TwoColors(int size) {
  Image image(size, size);
  for (int i = 0; i < size * size; ++i) {
    const bool above = i < size * size / 2;
    image.rgba[4 * i + (above ? 0 : 2)] = 255;
    image.rgba[4 * i + 3] = 255;
  }
  return image;
}

Bytes PngOf(const Image& image) { return render::EncodePng(image, {}).value(); }

Bytes JpegOf(const Image& image, Scans scans, J_COLOR_SPACE space) {
  jpeg_compress_struct cinfo{};
  jpeg_error_mgr errors{};
  cinfo.err = jpeg_std_error(&errors);
  jpeg_create_compress(&cinfo);
  unsigned char* data = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&cinfo, &data, &size);
  cinfo.image_width = image.width;
  cinfo.image_height = image.height;
  cinfo.input_components = 4;
  cinfo.in_color_space = space;
  jpeg_set_defaults(&cinfo);
  jpeg_set_quality(&cinfo, 95, TRUE);
  if (scans == Scans::kProgressive) jpeg_simple_progression(&cinfo);
  jpeg_start_compress(&cinfo, TRUE);
  while (cinfo.next_scanline < cinfo.image_height) {
    auto* row = const_cast<JSAMPROW>(image.rgba.data() + cinfo.next_scanline * image.width * 4);
    jpeg_write_scanlines(&cinfo, &row, 1);
  }
  jpeg_finish_compress(&cinfo);
  const Bytes bytes(data, data + size);
  jpeg_destroy_compress(&cinfo);
  std::free(data);
  return bytes;
}

}  // namespace hazumi::test
