#include "engine/exchange/gltf_reader/accessors.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "engine/base/base64.h"
#include "engine/base/utf8.h"
#include "engine/exchange/gltf_reader/compression.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

constexpr size_t kMostNumbers = 100'000'000;  // of an accessor

using ReadNumber = double (*)(const char*);

struct Component {
  size_t type, size;
  double largest;  // what 1 is written as where numbers are normalized; 0: they are real anyway
  ReadNumber read;
};

template <typename T>
double Read(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);  // little-endian, as this machine
  return static_cast<double>(value);
}

constexpr Component kComponents[] = {
    {5120, 1, 127.0, Read<int8_t>},          {5121, 1, 255.0, Read<uint8_t>},
    {5122, 2, 32767.0, Read<int16_t>},       {5123, 2, 65535.0, Read<uint16_t>},
    {5125, 4, 4294967295.0, Read<uint32_t>}, {5126, 4, 0.0, Read<float>}};

const Component* ComponentOf(const Json& accessor) {
  const size_t type = Count(accessor, "componentType", 0);
  for (const Component& component : kComponents)
    if (component.type == type) return &component;
  return nullptr;
}

// Rows and columns of an element; vectors have one column.
struct Shape {
  const char* type;
  size_t rows, columns;
};
constexpr Shape kShapes[] = {{"SCALAR", 1, 1}, {"VEC2", 2, 1}, {"VEC3", 3, 1}, {"VEC4", 4, 1},
                             {"MAT2", 2, 2},   {"MAT3", 3, 3}, {"MAT4", 4, 4}};

const Shape* ShapeOf(const Json& accessor) {
  const std::string type = Text(Member(accessor, "type"));
  for (const Shape& shape : kShapes)
    if (type == shape.type) return &shape;
  return nullptr;
}

std::string Place(const char* list, size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

// "2" or "that" of an index that may be anything.
std::string Named(const Json& index) { return index.is_number() ? index.dump() : "that"; }

}  // namespace

struct GltfAccessors::Layout {
  size_t number_size = 1, rows = 1, columns = 1;
  ReadNumber read = nullptr;
  double one = 1.0;  // what 1 is written as
  std::string place;

  size_t width() const { return rows * columns; }
  // Columns of matrices begin at multiples of four bytes.
  size_t column_size() const {
    const size_t size = rows * number_size;
    return columns == 1 ? size : (size + 3) / 4 * 4;
  }
  size_t size() const { return (columns - 1) * column_size() + rows * number_size; }
  double NumberAt(const char* at) const {
    return one == 1.0 ? read(at) : std::max(read(at) / one, -1.0);
  }
};

Error GltfAccessors::Wrong(const std::string& place, const std::string& message) const {
  return {ErrorCode::kSchema, file_, place, message + "; the file is broken: export it again"};
}

Result<std::string> GltfAccessors::ReadBuffer(size_t index) const {
  const Json& buffer = Element(Member(document_.json, "buffers"), index);
  const std::string place = Place("buffers", index);
  const Json& uri = Member(buffer, "uri");
  if (!buffer.is_object()) return Wrong(place, "is not there");
  if (uri.is_null() && index == 0 && !document_.binary.empty()) return document_.binary;
  if (!uri.is_string()) return Wrong(place, "has no bytes");
  const std::string text = uri.get<std::string>();
  if (!text.starts_with("data:")) {
    std::optional<std::string> bytes = folder_.Contents(text);
    if (bytes) return std::move(*bytes);
    return Error{ErrorCode::kSyntax, file_, place,
                 "its file " + ValidUtf8(text) +
                     " is missing or lies outside the file's folder; put it beside the file, or "
                     "embed it"};
  }
  const size_t comma = text.find(";base64,");
  std::optional<std::string> bytes;
  if (comma != std::string::npos) bytes = FromBase64(std::string_view(text).substr(comma + 8));
  if (!bytes) return Wrong(place, "has bytes that are no base64");
  return std::move(*bytes);
}

Result<const std::string*> GltfAccessors::Buffer(size_t index) {
  const auto known = buffers_.find(index);
  if (known != buffers_.end()) return &known->second;
  Result<std::string> read = ReadBuffer(index);
  if (!read.ok()) return read.error();
  return &buffers_.emplace(index, std::move(read).value()).first->second;
}

// A part of a buffer, as a view or its extension states it.
Result<std::string_view> GltfAccessors::Part(const Json& part, const std::string& place) {
  const Result<const std::string*> buffer = Buffer(Count(part, "buffer", SIZE_MAX));
  if (!buffer.ok()) return buffer.error();
  const std::string_view bytes = *buffer.value();
  const size_t offset = Count(part, "byteOffset", 0);
  const size_t length = Count(part, "byteLength", SIZE_MAX);
  if (offset > bytes.size() || length > bytes.size() - offset)
    return Wrong(place, "reaches beyond the end of its buffer");
  return bytes.substr(offset, length);
}

Result<std::string_view> GltfAccessors::View(const Json& index) {
  const Json& view = Element(Member(document_.json, "bufferViews"), index);
  const std::string place = "bufferViews[" + Named(index) + "]";
  if (!view.is_object()) return Wrong(place, "is not there");
  const Json& compressed = Member(Member(view, "extensions"), "EXT_meshopt_compression");
  if (compressed.is_null()) return Part(view, place);
  const auto known = decoded_.find(index.get<size_t>());
  if (known != decoded_.end()) return std::string_view(known->second);
  const Result<std::string_view> part = Part(compressed, place);
  if (!part.ok()) return part.error();
  Result<std::string> decoded = DecodeMeshopt(compressed, part.value(), place, file_);
  if (!decoded.ok()) return decoded.error();
  return std::string_view(
      decoded_.emplace(index.get<size_t>(), std::move(decoded).value()).first->second);
}

Result<Done> GltfAccessors::AddElements(const Layout& layout, const Json& view, size_t offset,
                                        size_t count, bool may_have_stride,
                                        std::vector<double>* numbers) {
  if (count == 0) return Done{};
  const Result<std::string_view> bytes = View(view);
  if (!bytes.ok()) return bytes.error();
  const Json& views = Member(document_.json, "bufferViews");
  const size_t stated = Count(Element(views, view), "byteStride", 0);
  const size_t stride = may_have_stride && stated > 0 ? stated
                        : layout.columns == 1         ? layout.size()
                                                      : layout.columns * layout.column_size();
  const size_t length = bytes.value().size();
  if (stride < layout.size() || offset > length || layout.size() > length - offset ||
      (count - 1) > (length - offset - layout.size()) / stride)
    return Wrong(layout.place, "reaches beyond the end of its bufferView");
  for (size_t i = 0; i < count; ++i) {
    const char* element = bytes.value().data() + offset + i * stride;
    for (size_t k = 0; k < layout.width(); ++k) {
      numbers->push_back(layout.NumberAt(element + k / layout.rows * layout.column_size() +
                                         k % layout.rows * layout.number_size));
    }
  }
  return Done{};
}

// Elements in place of those that the accessor has anyway.
Result<Done> GltfAccessors::AddSparse(const Layout& layout, const Json& sparse,
                                      GltfValues* values) {
  const size_t count = Count(sparse, "count", 0);
  const Json &indices = Member(sparse, "indices"), &others = Member(sparse, "values");
  const Component* type = ComponentOf(indices);
  if (count > values->count || !type || type->largest == 0.0)
    return Wrong(layout.place, "is sparse in a way that glTF does not know");
  Layout places;
  places.number_size = type->size;
  places.read = type->read;
  places.place = layout.place;
  std::vector<double> at, numbers;
  if (Result<Done> added = AddElements(places, Member(indices, "bufferView"),
                                       Count(indices, "byteOffset", 0), count, false, &at);
      !added.ok())
    return added;
  if (Result<Done> added = AddElements(layout, Member(others, "bufferView"),
                                       Count(others, "byteOffset", 0), count, false, &numbers);
      !added.ok())
    return added;
  for (size_t i = 0; i < count; ++i) {
    if (!(at[i] >= 0.0 && at[i] < static_cast<double>(values->count)))
      return Wrong(layout.place, "sets an element that it does not have");
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(i * layout.width()), layout.width(),
                values->numbers.begin() +
                    static_cast<std::ptrdiff_t>(static_cast<size_t>(at[i]) * layout.width()));
  }
  return Done{};
}

Result<GltfValues> GltfAccessors::Values(const Json& index) {
  const Json& accessor = Element(Member(document_.json, "accessors"), index);
  const std::string place = "accessors[" + Named(index) + "]";
  const Component* component = ComponentOf(accessor);
  const Shape* shape = ShapeOf(accessor);
  if (!accessor.is_object()) return Wrong(place, "is not there");
  if (!component || !shape) return Wrong(place, "is of a type that glTF does not know");
  Layout layout;
  const bool is_normalized = component->largest > 0.0 && Member(accessor, "normalized") == true;
  layout.number_size = component->size;
  layout.read = component->read;
  layout.rows = shape->rows;
  layout.columns = shape->columns;
  layout.one = is_normalized ? component->largest : 1.0;
  layout.place = place;
  GltfValues values;
  values.count = Count(accessor, "count", 0);
  values.width = layout.width();
  values.is_whole = component->largest > 0.0 && !is_normalized;
  if (values.count > kMostNumbers / values.width) return Wrong(place, "has too many elements");
  if (accessor.contains("bufferView")) {
    if (Result<Done> added =
            AddElements(layout, accessor["bufferView"], Count(accessor, "byteOffset", 0),
                        values.count, true, &values.numbers);
        !added.ok())
      return added.error();
  } else {
    values.numbers.assign(values.count * values.width, 0.0);
  }
  if (accessor.contains("sparse")) {
    if (Result<Done> added = AddSparse(layout, accessor["sparse"], &values); !added.ok())
      return added.error();
  }
  return values;
}

}  // namespace hazumi
