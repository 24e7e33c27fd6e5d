#include <meshoptimizer.h>

#include "engine/exchange/gltf_reader/compression.h"
#include "engine/exchange/gltf_reader/document.h"

namespace hazumi {
namespace {

constexpr size_t kLongest = size_t{512} << 20;  // [bytes]

// What a filter demands of the length of an element, by the code that undoes it.
bool Unfilter(const std::string& filter, size_t count, size_t stride, std::string* bytes) {
  if (filter.empty() || filter == "NONE") return true;
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) {
    meshopt_decodeFilterOct(bytes->data(), count, stride);
  } else if (filter == "QUATERNION" && stride == 8) {
    meshopt_decodeFilterQuat(bytes->data(), count, stride);
  } else if (filter == "EXPONENTIAL" && stride % 4 == 0) {
    meshopt_decodeFilterExp(bytes->data(), count, stride);
  } else {
    return false;
  }
  return true;
}

}  // namespace

Result<std::string> DecodeMeshopt(const nlohmann::json& extension, std::string_view bytes,
                                  const std::string& place, const std::string& file) {
  const size_t count = Count(extension, "count", 0), stride = Count(extension, "byteStride", 0);
  const std::string mode = Text(Member(extension, "mode"));
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const bool is_index = stride == 2 || stride == 4;
  std::string decoded;
  bool is_done = stride > 0 && count <= kLongest / stride;
  if (is_done) decoded.resize(count * stride);
  if (is_done && mode == "ATTRIBUTES" && stride % 4 == 0 && stride <= 256) {
    is_done = meshopt_decodeVertexBuffer(decoded.data(), count, stride, data, bytes.size()) == 0 &&
              Unfilter(Text(Member(extension, "filter")), count, stride, &decoded);
  } else if (is_done && mode == "TRIANGLES" && is_index && count % 3 == 0) {
    is_done = meshopt_decodeIndexBuffer(decoded.data(), count, stride, data, bytes.size()) == 0;
  } else if (is_done && mode == "INDICES" && is_index) {
    is_done = meshopt_decodeIndexSequence(decoded.data(), count, stride, data, bytes.size()) == 0;
  } else {
    is_done = false;
  }
  if (is_done) return decoded;
  return Error{ErrorCode::kSchema, file, place,
               "cannot be decoded by meshopt; the file is broken: export it again, or without "
               "compression"};
}

}  // namespace hazumi
