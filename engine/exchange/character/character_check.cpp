#include "engine/exchange/character/character_check.h"

#include <cmath>
#include <unordered_set>

namespace hazumi {
namespace {

class Checker {
 public:
  Checker(const Character& character, const CharacterLimits& limits)
      : c_(character), limits_(limits) {}

  // Place and message of the first thing that is wrong; empty message: none.
  Warning Run() {
    Counts();
    Names();
    for (size_t i = 0; ok() && i < c_.bones.size(); ++i) CheckBone(static_cast<int>(i));
    for (size_t i = 0; ok() && i < c_.clips.size(); ++i) CheckClip(c_.clips[i], i);
    for (size_t i = 0; ok() && i < c_.meshes.size(); ++i) CheckMesh(c_.meshes[i], i);
    for (const Material& material : c_.materials)
      if (ok()) CheckMaterial(material);
    if (ok() && c_.metres_per_unit && !(*c_.metres_per_unit > 0.0 && *c_.metres_per_unit < 1e6))
      Say("unit", "the unit of length is not a positive number of metres");
    return wrong_;
  }

 private:
  bool ok() const { return wrong_.message.empty(); }
  void Say(const std::string& place, const std::string& message) {
    if (ok()) wrong_ = {place, message};
  }
  void AtMost(const char* what, size_t count, size_t most) {
    if (count > most) {
      Say(what, "there are " + std::to_string(count) + ", more than the " + std::to_string(most) +
                    " that are read");
    }
  }
  template <typename Vector>
  bool IsLength(const Vector& v) const {
    return v.allFinite() && v.cwiseAbs().maxCoeff() <= limits_.longest;
  }

  void Counts() {
    AtMost("bones", c_.bones.size(), limits_.bones);
    AtMost("clips", c_.clips.size(), limits_.clips);
    AtMost("meshes", c_.meshes.size(), limits_.meshes);
    size_t samples = 0, vertices = 0, triangles = 0;
    for (const Clip& clip : c_.clips) {
      for (const BoneTrack& t : clip.tracks)
        samples += t.rotations.size() + t.angles.size() + t.translations.size() + t.scales.size();
    }
    for (const SkinMesh& mesh : c_.meshes) {
      vertices += mesh.positions.size();
      triangles += mesh.triangles.size();
    }
    AtMost("clips: samples", samples, limits_.samples);
    AtMost("meshes: vertices", vertices, limits_.vertices);
    AtMost("meshes: triangles", triangles, limits_.triangles);
    if (c_.bones.empty()) Say("bones", "there are none, so that there is nothing to move");
  }

  void Names() {
    std::unordered_set<std::string> names;
    for (const Bone& bone : c_.bones) {
      if (bone.name.empty()) Say("bones", "a bone has no name");
      if (!names.insert(bone.name).second) Say(bone.name, "two bones have this name");
    }
  }

  void CheckBone(int i) {
    const Bone& bone = c_.bones[static_cast<size_t>(i)];
    const std::string place = "bone " + bone.name;
    if (bone.parent < -1 || bone.parent >= i) Say(place, "its parent does not come before it");
    if (!IsLength(bone.rest.p)) Say(place, "its position is not a number of sensible size");
    const Mat3 unit = bone.rest.R * bone.rest.R.transpose();
    if (!bone.rest.R.allFinite() || !unit.isIdentity(1e-6) || bone.rest.R.determinant() < 0.0)
      Say(place, "its rest orientation is not a rotation");
    if (!IsLength(bone.rest_scale)) Say(place, "its scale is not a number of sensible size");
    if (bone.end_site && !IsLength(*bone.end_site))
      Say(place, "its end is not a number of sensible size");
    if (bone.body) CheckBody(*bone.body, place);
    if (!bone.source.above.allFinite()) Say(place, "a node above it has no place");
  }

  void CheckBody(const BoneBody& body, const std::string& place) {
    bool is_sound = body.mass > 0.0 && IsLength(body.com) && body.inertia.allFinite();
    for (const BoneBody::Capsule& capsule : body.capsules) {
      is_sound = is_sound && IsLength(capsule.from) && IsLength(capsule.to) &&
                 capsule.radius > 0.0 && capsule.radius <= limits_.longest;
    }
    if (!is_sound) Say(place, "its body is not of sensible size and mass");
  }

  void CheckClip(const Clip& clip, size_t index) {
    const std::string place = "clip " + (clip.name.empty() ? std::to_string(index) : clip.name);
    if (!(clip.seconds_per_frame > 1e-6 && clip.seconds_per_frame < 1e4))
      Say(place, "its frame time is not a positive number of seconds");
    if (clip.num_frames < 1) Say(place, "it has no frames");
    AtMost((place + ": frames").c_str(), static_cast<size_t>(std::max(0, clip.num_frames)),
           limits_.frames);
    if (clip.tracks.size() != c_.bones.size()) Say(place, "it has not one track a bone");
    for (size_t i = 0; ok() && i < clip.tracks.size(); ++i) {
      CheckTrack(clip.tracks[i], static_cast<size_t>(clip.num_frames),
                 place + ", bone " + c_.bones[i].name);
    }
  }

  void CheckTrack(const BoneTrack& track, size_t frames, const std::string& place) {
    const auto fits = [&](size_t size) { return size == 0 || size == frames; };
    if (!fits(track.rotations.size()) || !fits(track.angles.size()) ||
        !fits(track.translations.size()) || !fits(track.scales.size()) || !fits(track.above.size()))
      Say(place, "its track has not one entry a frame");
    for (const Eigen::Quaterniond& q : track.rotations)
      if (!(std::abs(q.norm() - 1.0) < 1e-6)) Say(place, "a rotation is not a unit quaternion");
    for (const Eigen::Matrix4d& above : track.above)
      if (!above.allFinite()) Say(place, "a node above it has no place");
    for (const auto* lengths : {&track.angles, &track.translations, &track.scales}) {
      for (const Vec3& v : *lengths)
        if (!IsLength(v)) Say(place, "a value is not a number of sensible size");
    }
  }

  void CheckMesh(const SkinMesh& mesh, size_t index) {
    const std::string place = "mesh " + (mesh.name.empty() ? std::to_string(index) : mesh.name);
    const size_t n = mesh.positions.size();
    if (mesh.normals.size() != n || mesh.bind_indices.size() != n || mesh.weights.size() != n ||
        (!mesh.texture_coordinates.empty() && mesh.texture_coordinates.size() != n) ||
        (!mesh.colors.empty() && mesh.colors.size() != n))
      return Say(place, "its vertices' lists differ in length");
    for (const SkinMesh::Bind& bind : mesh.binds) {
      if (bind.bone < 0 || static_cast<size_t>(bind.bone) >= c_.bones.size() ||
          !bind.inverse_bind.allFinite())
        Say(place, "a bind is not that of a bone");
    }
    if (mesh.material < -1 || mesh.material >= static_cast<int>(c_.materials.size()))
      Say(place, "its material is not there");
    for (const auto& triangle : mesh.triangles) {
      for (const uint32_t v : triangle)
        if (v >= n) Say(place, "a triangle's vertex is not there");
    }
    for (size_t v = 0; ok() && v < n; ++v) CheckVertex(mesh, v, place);
  }

  void CheckVertex(const SkinMesh& mesh, size_t v, const std::string& place) {
    if (!IsLength(mesh.positions[v].cast<double>()) || !mesh.normals[v].allFinite() ||
        (!mesh.texture_coordinates.empty() && !mesh.texture_coordinates[v].allFinite()) ||
        (!mesh.colors.empty() && !mesh.colors[v].allFinite()))
      Say(place, "a vertex is not a number of sensible size");
    float sum = 0.0f;
    for (size_t k = 0; k < 4; ++k) {
      sum += mesh.weights[v][k];
      if (!(mesh.weights[v][k] >= 0.0f) || mesh.bind_indices[v][k] >= mesh.binds.size())
        Say(place, "a vertex has a wrong weight");
    }
    if (!(std::abs(sum - 1.0f) < 1e-3f)) Say(place, "a vertex's weights do not add up to 1");
  }

  void CheckMaterial(const Material& material) {
    for (const float part : material.base_color)
      if (!std::isfinite(part)) Say("material " + material.name, "its colour is not a number");
    for (const float part : material.emission)
      if (!std::isfinite(part)) Say("material " + material.name, "its emission is not a number");
    const auto is_there = [&](int texture) {
      return texture >= -1 && texture < static_cast<int>(c_.textures.size());
    };
    if (!is_there(material.texture) || !is_there(material.emission_texture))
      Say("material " + material.name, "its texture is not there");
  }

  const Character& c_;
  const CharacterLimits& limits_;
  Warning wrong_;
};

}  // namespace

Result<Done> CheckCharacter(const Character& character, const std::string& file,
                            const CharacterLimits& limits) {
  Warning wrong = Checker(character, limits).Run();
  if (wrong.message.empty()) return Done{};
  return Error{ErrorCode::kSemantics, file, wrong.place,
               wrong.message + "; the file is broken or holds no character: export it again"};
}

}  // namespace hazumi
