#include <draco/compression/decode.h>

#include <memory>

#include "engine/exchange/gltf_reader/compression.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

GltfValues ValuesOf(const draco::PointAttribute& attribute, uint32_t num_points) {
  GltfValues values;
  values.count = num_points;
  values.width = attribute.num_components();
  values.is_whole = attribute.data_type() != draco::DT_FLOAT32 && !attribute.normalized();
  std::vector<float> numbers(values.width);
  for (uint32_t point = 0; point < num_points; ++point) {
    attribute.ConvertValue<float>(attribute.mapped_index(draco::PointIndex(point)),
                                  attribute.num_components(), numbers.data());
    values.numbers.insert(values.numbers.end(), numbers.begin(), numbers.end());
  }
  return values;
}

}  // namespace

Result<DracoPrimitive> DecodeDraco(const Json& extension, std::string_view bytes,
                                   const std::string& place, const std::string& file) {
  const auto wrong = [&](const std::string& message) {
    return Error{ErrorCode::kSchema, file, place,
                 message + "; the file is broken: export it again, or without compression"};
  };
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok())
    return wrong("cannot be decoded by Draco (" + decoded.status().error_msg_string() + ")");
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  DracoPrimitive primitive;
  const Json& attributes = Member(extension, "attributes");
  for (auto it = attributes.begin(); attributes.is_object() && it != attributes.end(); ++it) {
    const draco::PointAttribute* attribute =
        it->is_number_unsigned() ? mesh->GetAttributeByUniqueId(it->get<uint32_t>()) : nullptr;
    if (!attribute) return wrong("Draco has none of its " + it.key());
    primitive.attributes[it.key()] = ValuesOf(*attribute, mesh->num_points());
  }
  for (draco::FaceIndex face(0); face < mesh->num_faces(); ++face) {
    for (const draco::PointIndex& point : mesh->face(face))
      primitive.indices.push_back(point.value());
  }
  return primitive;
}

}  // namespace hazumi
