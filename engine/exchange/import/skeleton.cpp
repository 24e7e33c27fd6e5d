#include "engine/exchange/import/skeleton.h"

#include <Eigen/SVD>
#include <algorithm>

#include "engine/body/bone_roles.h"

namespace hazumi {

namespace {

template <typename T>
const T& Of(const std::vector<T>& list, int frame, const T& otherwise) {
  return list.empty() ? otherwise : list[frame];
}

std::vector<char> Weighted(const Character& character) {
  std::vector<char> weighted(character.bones.size(), 0);
  for (const SkinMesh& mesh : character.meshes) {
    std::vector<char> used(mesh.binds.size(), 0);
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      for (int k = 0; k < 4; ++k) {
        if (mesh.weights[v][k] > 0.0f) used[mesh.bind_indices[v][k]] = 1;
      }
    }
    for (size_t b = 0; b < used.size(); ++b) {
      if (used[b]) weighted[mesh.binds[b].bone] = 1;
    }
  }
  return weighted;
}

// By bone: whether it or anything below it is one of these.
std::vector<char> CarriersOf(const Character& character, std::vector<char> these) {
  for (int b = static_cast<int>(character.bones.size()) - 1; b > 0; --b) {
    const int parent = character.bones[b].parent;
    if (these[b] && parent >= 0) these[parent] = 1;
  }
  return these;
}

bool AreAlike(const ReadName& a, const ReadName& b) {
  return a.body.part == b.body.part && a.body.side == b.body.side && a.word == b.word;
}

// Without a skin: what moves, but for handles of a rig, such as "ik_foot_l" beside "foot_l", and
// "pole_target" beside bones without such words in their names.
std::vector<char> WantedBare(const Character& character) {
  std::vector<std::string> written;
  for (const Bone& bone : character.bones) written.push_back(bone.name);
  written = WithoutPrefix(std::move(written));
  std::vector<ReadName> names, plain;
  for (size_t b = 0; b < written.size(); ++b) {
    names.push_back(ReadBoneName(written[b]));
    if (character.bones[b].is_joint && !names.back().is_helper) plain.push_back(names.back());
  }
  const auto is_handle = [&](const ReadName& name) {
    if (!name.is_helper || plain.empty()) return false;
    return name.body.part == BodyPart::kOther ||
           std::any_of(plain.begin(), plain.end(),
                       [&](const ReadName& other) { return AreAlike(name, other); });
  };
  std::vector<char> wanted;
  for (size_t b = 0; b < names.size(); ++b)
    wanted.push_back(character.bones[b].is_joint && !is_handle(names[b]));
  return wanted;
}

// Whether a bone only moves the pelvis about, as game engines have it: it lies on the ground.
bool IsMover(const Character& character, int bone, int below, const std::vector<char>& weighted) {
  const auto part = [&](int b) { return ReadBoneName(character.bones[b].name).body.part; };
  return !weighted[bone] && part(bone) == BodyPart::kOther && part(below) == BodyPart::kPelvis;
}

// From the top down as long as one child alone carries anything and the bone itself is none of it,
// or only moves it.
int LowestCommon(const Character& character, const std::vector<char>& wanted,
                 const std::vector<char>& weighted, const std::vector<char>& carriers) {
  const int num = static_cast<int>(character.bones.size());
  const auto child_of = [&](int parent) {
    int only = -1;
    for (int b = 0; b < num; ++b) {
      if (character.bones[b].parent != parent || !carriers[b]) continue;
      if (only >= 0) return -1;
      only = b;
    }
    return only;
  };
  int root = child_of(-1);
  for (int below; root >= 0 && (below = child_of(root)) >= 0; root = below) {
    if (wanted[root] && !IsMover(character, root, below, weighted)) break;
  }
  return root;
}

// Takes the roles that the file itself states, before those of names. Returns whether it states
// any.
bool TakeStated(const Character& character, const std::vector<KeptBone>& kept, BoneRoles* roles) {
  const auto stated = [&](size_t k) {
    return character.bones[static_cast<size_t>(kept[k].bone)].place;
  };
  bool is_stated = false;
  for (size_t k = 0; k < kept.size(); ++k) is_stated |= stated(k).has_value();
  for (size_t k = 0; k < kept.size() && is_stated; ++k) {
    const BodyRole told = roles->places[k].role;
    const bool is_beside = told >= BodyRole::kTail || told == BodyRole::kNone;
    if (stated(k) || !is_beside) roles->places[k] = stated(k).value_or(BodyPlace());
  }
  return is_stated;
}

// Names the end of a limb: on a shin it is a foot, on a forearm a hand.
void NameEnd(BodyPlace limb, KeptBone* end) {
  const bool is_leg = limb.role == BodyRole::kShin;
  if (!is_leg && limb.role != BodyRole::kForearm) return;
  end->place = {is_leg ? BodyRole::kFoot : BodyRole::kHand, limb.side};
  end->body = {PartOf(end->place.role), limb.side};
}

void NameBones(const Character& character, Skeleton* skeleton) {
  std::vector<KeptBone>* kept = &skeleton->bones;
  std::vector<NamedBone> named;
  for (const KeptBone& bone : *kept)
    named.push_back({character.bones[bone.bone].name, bone.parent});
  const std::vector<BodyName> bones = BonesInBody(named);
  BoneRoles roles = RolesByName(named);
  const bool is_stated = TakeStated(character, *kept, &roles);
  skeleton->has_four_legs = roles.has_four_legs && !is_stated;
  const bool is_body =
      (IsBody(bones) || is_stated) && !skeleton->has_four_legs;  // the table is of people
  for (size_t k = 0; k < bones.size(); ++k) {
    KeptBone& bone = (*kept)[k];
    bone.body = bones[k];
    bone.place = roles.places[k];
    if (character.bones[bone.bone].place) bone.body = {PartOf(bone.place.role), bone.place.side};
    if (character.bones[bone.bone].is_limb_end) NameEnd((*kept)[bone.parent].place, &bone);
    if (is_body) bone.segment = SegmentOf(bone.body.part);
    const bool is_part = bone.segment != BodySegment::kNone || !is_body;
    if (is_part) continue;  // what names nothing belongs to what it hangs on
    bone.segment = bone.parent < 0 ? BodySegment::kTrunk : (*kept)[bone.parent].segment;
  }
  BodyPart& root = kept->front().body.part;
  if (root == BodyPart::kOther) root = BodyPart::kPelvis;
}

}  // namespace

bool BonePose::is_even() const {
  const Vec3 axes = stretch.diagonal();
  return stretch.isDiagonal(0.0) &&
         axes.maxCoeff() - axes.minCoeff() <= 1e-9 * axes.cwiseAbs().maxCoeff();
}

// A = R stretch, the stretch symmetric: the polar decomposition of what stretches parts of it make.
BonePose BelowPose(const BonePose& parent, const Mat3& R, const Vec3& p, const Vec3& scale) {
  const Vec3 place = parent.At(p);
  if (parent.is_even()) {
    const double all = parent.stretch(0, 0);
    return {parent.R * R, place, (all * scale).asDiagonal().toDenseMatrix()};
  }
  const Mat3 A = parent.stretch * R * scale.asDiagonal();
  const Eigen::JacobiSVD<Mat3> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3 turn = svd.matrixU() * svd.matrixV().transpose();
  // A scale that mirrors stays in the stretch.
  const Mat3 proper = turn.determinant() < 0.0 ? Mat3(-turn) : turn;
  return {parent.R * proper, place, proper.transpose() * A};
}

std::vector<BonePose> PosesAt(const Character& character, const Clip* clip, int frame) {
  static const BoneTrack kStill;
  std::vector<BonePose> poses(character.bones.size());
  for (size_t b = 0; b < poses.size(); ++b) {
    const Bone& bone = character.bones[b];
    const BoneTrack& track = clip ? clip->tracks[b] : kStill;
    const Mat3 R =
        track.rotations.empty() ? bone.rest.R : track.rotations[frame].toRotationMatrix();
    const BonePose parent = bone.parent < 0 ? BonePose() : poses[bone.parent];
    poses[b] = BelowPose(parent, R, Of(track.translations, frame, bone.rest.p),
                         Of(track.scales, frame, bone.rest_scale));
  }
  return poses;
}

std::vector<char> WantedBones(const Character& character) {
  const std::vector<char> weighted = Weighted(character);
  const bool has_skin = std::find(weighted.begin(), weighted.end(), 1) != weighted.end();
  return has_skin ? weighted : WantedBare(character);
}

Result<Skeleton> SkeletonOf(const Character& character) {
  const size_t num = character.bones.size();
  const std::vector<char> weighted = Weighted(character);
  const std::vector<char> wanted = WantedBones(character);
  const std::vector<char> carriers = CarriersOf(character, wanted);
  const int root = LowestCommon(character, wanted, weighted, carriers);
  if (root < 0) {
    return Error{ErrorCode::kSemantics, "", "",
                 num == 0 ? "there is no skeleton in it"
                          : "its bones have no common root; join them under one bone"};
  }
  Skeleton skeleton;
  skeleton.rest = PosesAt(character, nullptr, 0);
  skeleton.kept.assign(num, -1);
  std::vector<char> above_root(num, 0);
  for (int b = root; b >= 0; b = character.bones[b].parent) above_root[b] = 1;
  for (int b = 0; b < static_cast<int>(num); ++b) {
    const int above = character.bones[b].parent;
    const int parent = above < 0 ? -1 : skeleton.kept[above];
    const bool is_in = b == root || (parent >= 0 && carriers[b]);
    if (!is_in) {
      if (character.bones[b].is_joint && !above_root[b])
        skeleton.left_out.push_back(character.bones[b].name);
      continue;
    }
    skeleton.kept[b] = static_cast<int>(skeleton.bones.size());
    if (parent >= 0) skeleton.bones[parent].children.push_back(skeleton.kept[b]);
    skeleton.bones.push_back({b, b == root ? -1 : parent, {}, {}, BodySegment::kNone, {}});
  }
  NameBones(character, &skeleton);
  return skeleton;
}

}  // namespace hazumi
