#pragma once

// Internal. The one buffer of a glTF file, with its views and accessors.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace hazumi {

using GltfJson = nlohmann::ordered_json;

enum class GltfUse { kPlain = 0, kVertices = 34962, kIndices = 34963 };

class GltfBuffer {
 public:
  // Each returns the number of the accessor. `components` is 1, 2, 3, 4 or 16; `with_bounds` states
  // min and max, which times and positions must have.
  int AddFloats(std::span<const float> values, int components, GltfUse use,
                bool with_bounds = false);
  int AddShorts(std::span<const uint16_t> values, int components, GltfUse use);
  int AddBytes(std::span<const uint8_t> values, int components, GltfUse use);
  int AddLongs(std::span<const uint32_t> values, int components, GltfUse use);
  // The number of the view.
  int AddView(std::string_view bytes, GltfUse use);

  const std::string& bytes() const { return bytes_; }
  const GltfJson& views() const { return views_; }
  const GltfJson& accessors() const { return accessors_; }
  bool is_finite() const { return is_finite_; }  // all floats so far

 private:
  template <typename T>
  int Add(std::span<const T> values, int component_type, int components, GltfUse use);

  std::string bytes_;
  GltfJson views_ = GltfJson::array();
  GltfJson accessors_ = GltfJson::array();
  bool is_finite_ = true;
};

}  // namespace hazumi
