#pragma once

#include <map>
#include <optional>

#include "engine/exchange/gltf_reader/document.h"
#include "engine/exchange/scene/scene_folder.h"

namespace hazumi {

// The elements of an accessor as real numbers: `width` an element, columns of matrices one after
// the other. Whole numbers c that are normalized [glTF 2.0, 3.11]: c / 255, c / 65535, or, with
// signs, max(c / 127, -1), max(c / 32767, -1).
struct GltfValues {
  size_t count = 0, width = 0;
  bool is_whole = false;  // whole numbers that are not normalized
  std::vector<double> numbers;

  double At(size_t element, size_t k) const { return numbers[element * width + k]; }
};

// Decodes accessors of every type, also sparse ones. Buffers: in the file, or in its folder.
class GltfAccessors {
 public:
  // Both have to outlive this.
  GltfAccessors(const GltfDocument& document, SceneFolder* folder, std::string file)
      : document_(document), folder_(*folder), file_(std::move(file)) {}

  // Error: there is none of this index, it is not as glTF wants it, or its bytes are not there.
  Result<GltfValues> Values(const nlohmann::json& index);
  // Bytes of a view, such as of a picture; decoded where EXT_meshopt_compression keeps them.
  Result<std::string_view> View(const nlohmann::json& index);

 private:
  struct Layout;
  Error Wrong(const std::string& place, const std::string& message) const;
  Result<const std::string*> Buffer(size_t index);
  Result<std::string_view> Part(const nlohmann::json& part, const std::string& place);
  Result<std::string> ReadBuffer(size_t index) const;
  Result<Done> AddElements(const Layout& layout, const nlohmann::json& view, size_t offset,
                           size_t count, bool may_have_stride, std::vector<double>* numbers);
  Result<Done> AddSparse(const Layout& layout, const nlohmann::json& sparse, GltfValues* values);

  const GltfDocument& document_;
  SceneFolder& folder_;
  const std::string file_;
  std::map<size_t, std::string> buffers_, decoded_;  // those that were read, and views decoded
};

}  // namespace hazumi
