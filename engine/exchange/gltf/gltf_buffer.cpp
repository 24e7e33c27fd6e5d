#include "engine/exchange/gltf/gltf_buffer.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hazumi {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian");

namespace {

constexpr int kByte = 5121, kShort = 5123, kLong = 5125, kFloat = 5126;

const char* TypeName(int components) {
  switch (components) {
    case 2:
      return "VEC2";
    case 3:
      return "VEC3";
    case 4:
      return "VEC4";
    case 16:
      return "MAT4";
    default:
      return "SCALAR";
  }
}

}  // namespace

int GltfBuffer::AddView(std::string_view bytes, GltfUse use) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  GltfJson view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
  if (use != GltfUse::kPlain) view["target"] = static_cast<int>(use);
  bytes_ += bytes;
  views_.push_back(std::move(view));
  return static_cast<int>(views_.size()) - 1;
}

template <typename T>
int GltfBuffer::Add(std::span<const T> values, int component_type, int components, GltfUse use) {
  const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  accessors_.push_back({{"bufferView", AddView(bytes, use)},
                        {"componentType", component_type},
                        {"count", values.size() / static_cast<size_t>(components)},
                        {"type", TypeName(components)}});
  return static_cast<int>(accessors_.size()) - 1;
}

int GltfBuffer::AddFloats(std::span<const float> values, int components, GltfUse use,
                          bool with_bounds) {
  is_finite_ = is_finite_ &&
               std::all_of(values.begin(), values.end(), [](float x) { return std::isfinite(x); });
  const int number = Add(values, kFloat, components, use);
  if (!with_bounds || values.empty()) return number;
  const auto width = static_cast<size_t>(components);
  std::vector<float> least(values.begin(), values.begin() + components), most = least;
  for (size_t i = width; i < values.size(); ++i) {
    least[i % width] = std::min(least[i % width], values[i]);
    most[i % width] = std::max(most[i % width], values[i]);
  }
  accessors_.back()["min"] = least;
  accessors_.back()["max"] = most;
  return number;
}

int GltfBuffer::AddShorts(std::span<const uint16_t> values, int components, GltfUse use) {
  return Add(values, kShort, components, use);
}

int GltfBuffer::AddBytes(std::span<const uint8_t> values, int components, GltfUse use) {
  return Add(values, kByte, components, use);
}

int GltfBuffer::AddLongs(std::span<const uint32_t> values, int components, GltfUse use) {
  return Add(values, kLong, components, use);
}

}  // namespace hazumi
