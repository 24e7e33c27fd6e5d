#include "engine/exchange/character/character_bytes.h"

#include "engine/base/byte_stream.h"
#include "engine/exchange/character/character_check.h"

namespace hazumi {
namespace {

constexpr uint32_t kMagic = 0x43'4d'5a'48;  // "HZMC"
constexpr uint32_t kVersion = 4;
enum : uint8_t { kIsError = 0, kIsCharacter = 1 };

class CharacterWriter : public ByteWriter {
 public:
  template <typename T>
  void List(std::vector<T>& list) {
    Size(list.size());
    for (T& element : list) Visit(*this, element);
  }
};

class CharacterReader : public ByteReader {
 public:
  using ByteReader::ByteReader;
  template <typename T>
  void List(std::vector<T>& list) {
    // Every kind of element takes 8 bytes at least; growing by steps keeps a false count cheap.
    const size_t count = Size(8);
    for (size_t i = 0; ok() && i < count; ++i) Visit(*this, list.emplace_back());
  }
};

template <typename Archive, typename T>
void Maybe(Archive& a, std::optional<T>& value) {
  bool is_there = value.has_value();
  a.Flag(is_there);
  if (!is_there) return;
  if (!value) value.emplace();
  a.Value(*value);
}

template <typename Archive>
void Visit(Archive& a, BoneBody::Capsule& capsule) {
  a.Text(capsule.name);
  a.Value(capsule.from);
  a.Value(capsule.to);
  a.Value(capsule.radius);
}

template <typename Archive>
void Visit(Archive& a, std::optional<BoneBody>& body) {
  bool is_there = body.has_value();
  a.Flag(is_there);
  if (!is_there) return;
  if (!body) body.emplace();
  a.Value(body->mass);
  a.Value(body->com);
  a.Value(body->inertia);
  a.List(body->capsules);
}

template <typename Archive>
void Visit(Archive& a, Bone& bone) {
  a.Text(bone.name);
  a.Value(bone.parent);
  a.Value(bone.rest.R);
  a.Value(bone.rest.p);
  a.Value(bone.rest_scale);
  a.Text(bone.rotation_order);
  Maybe(a, bone.end_site);
  a.Flag(bone.is_joint);
  Visit(a, bone.body);
  Maybe(a, bone.place);
  a.Value(bone.source.node);
  a.Value(bone.source.above);
}

template <typename Archive>
void Visit(Archive& a, BoneTrack& track) {
  a.Flat(track.rotations);
  a.Flat(track.angles);
  a.Flat(track.translations);
  a.Flat(track.scales);
  a.Flat(track.above);
}

template <typename Archive>
void Visit(Archive& a, Clip& clip) {
  a.Text(clip.name);
  a.Value(clip.seconds_per_frame);
  a.Value(clip.num_frames);
  a.Value(clip.index);
  a.Value(clip.start_s);
  a.List(clip.tracks);
}

template <typename Archive>
void Visit(Archive& a, Texture& texture) {
  a.Text(texture.name);
  a.Flat(texture.encoded);
}

template <typename Archive>
void Visit(Archive& a, Material& material) {
  a.Text(material.name);
  a.Value(material.base_color);
  a.Value(material.texture);
  a.Value(material.emission);
  a.Value(material.emission_texture);
}

template <typename Archive>
void Visit(Archive& a, SkinMesh::Bind& bind) {
  a.Value(bind.bone);
  a.Value(bind.inverse_bind);
}

template <typename Archive>
void Visit(Archive& a, SkinMesh& mesh) {
  a.Text(mesh.name);
  a.List(mesh.binds);
  a.Flat(mesh.positions);
  a.Flat(mesh.normals);
  a.Flat(mesh.texture_coordinates);
  a.Flat(mesh.colors);
  a.Flat(mesh.bind_indices);
  a.Flat(mesh.weights);
  a.Flat(mesh.triangles);
  a.Value(mesh.material);
}

template <typename Archive>
void Visit(Archive& a, Warning& warning) {
  a.Text(warning.place);
  a.Text(warning.message);
}

template <typename Archive>
void Visit(Archive& a, std::string& text) {
  a.Text(text);
}

template <typename Archive>
void Visit(Archive& a, Character& c) {
  bool knows_up = c.up.has_value(), is_z = c.up == UpAxis::kZ;
  a.Text(c.name);
  a.Text(c.chosen);
  a.List(c.others);
  a.Text(c.above);
  a.List(c.bones);
  a.List(c.clips);
  a.List(c.meshes);
  a.List(c.materials);
  a.List(c.textures);
  a.Flag(knows_up);
  a.Flag(is_z);
  Maybe(a, c.metres_per_unit);
  a.List(c.warnings);
  if constexpr (Archive::kReads) {
    a.Expect(knows_up || !is_z);
    if (knows_up) c.up = is_z ? UpAxis::kZ : UpAxis::kY;
  }
}

template <typename Archive>
void Visit(Archive& a, Error& error) {
  uint8_t code = static_cast<uint8_t>(error.code);
  a.Value(code);
  if constexpr (Archive::kReads) {
    error.code = code <= static_cast<uint8_t>(ErrorCode::kInterrupted)
                     ? static_cast<ErrorCode>(code)
                     : ErrorCode::kFailed;
  }
  a.Text(error.file);
  a.Text(error.place);
  a.Text(error.message);
}

Error Garbled(const std::string& file) {
  return {ErrorCode::kSyntax, file, "",
          "reading it gave no usable answer, so the file is probably broken; export it again, or "
          "in another format"};
}

Error OfAnotherVersion(const std::string& file) {
  return {ErrorCode::kFailed, file, "",
          "cannot be read, because hazumi-reader is of another version than hazumi; install Hazumi "
          "again"};
}

}  // namespace

std::string CharacterToBytes(const Result<Character>& result) {
  CharacterWriter writer;
  uint32_t magic = kMagic, version = kVersion;
  uint8_t kind = result.ok() ? kIsCharacter : kIsError;
  writer.Value(magic);
  writer.Value(version);
  writer.Value(kind);
  // Visiting to write changes nothing.
  if (result.ok()) {
    Visit(writer, const_cast<Character&>(result.value()));
  } else {
    Visit(writer, const_cast<Error&>(result.error()));
  }
  return writer.Take();
}

Result<Character> CharacterFromBytes(std::string_view bytes, const std::string& file) {
  CharacterReader reader(bytes);
  uint32_t magic = 0, version = 0;
  uint8_t kind = 0xff;
  reader.Value(magic);
  reader.Value(version);
  reader.Value(kind);
  if (magic != kMagic || kind > kIsCharacter) return Garbled(file);
  if (version != kVersion) return OfAnotherVersion(file);
  if (kind == kIsError) {
    Error error;
    Visit(reader, error);
    return reader.at_end() && !error.message.empty() ? error : Garbled(file);
  }
  Character character;
  Visit(reader, character);
  if (!reader.at_end()) return Garbled(file);
  if (Result<Done> checked = CheckCharacter(character, file); !checked.ok()) return checked.error();
  return character;
}

}  // namespace hazumi
