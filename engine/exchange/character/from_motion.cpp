#include "engine/exchange/character/from_motion.h"

#include <array>
#include <cmath>
#include <utility>

#include "engine/exchange/character/axes.h"
#include "engine/figure/figure_bone.h"

namespace hazumi {

namespace {

// Bone 0 is the root, bone 1 + g is the joint group g.
int BoneOf(const Figure& figure, JointIndex body) {
  return body.is_valid() ? 1 + figure.joint(body).group.value() : 0;
}

// How the angles of a group's hinges become those of three axes of the file.
struct HingeOrder {
  std::string letters;                         // "ZXY"
  std::array<double, 3> signs = {0., 0., 0.};  // by letter; 0: no hinge turns about it
};

// The number of the coordinate axis that `axis` lies on exactly; none: -1.
int CoordinateAxis(const Vec3& axis) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(axis[k]) == 1.0) return k;
  }
  return -1;
}

// None if the hinges are no Euler angles about three axes of the file.
std::optional<HingeOrder> OrderOf(const Figure& figure, const JointGroup& group,
                                  const FileAxes& axes) {
  HingeOrder order;
  for (int i = 0; i < group.size; ++i) {
    const Joint& hinge = figure.joint(JointIndex(group.first.value() + i));
    const int k = CoordinateAxis(hinge.axis);
    if (k < 0 || !hinge.parallel_frame || hinge.X_PJ.R != Mat3::Identity()) return std::nullopt;
    const char letter = static_cast<char>('X' + axes.Axis(k));
    if (order.letters.find(letter) != std::string::npos) return std::nullopt;
    order.signs[order.letters.size()] = hinge.axis[k];
    order.letters += letter;
  }
  for (const char letter : {'X', 'Y', 'Z'}) {
    if (order.letters.find(letter) == std::string::npos) order.letters += letter;
  }
  return order;
}

// Where the body's capsules reach farthest from its origin, in its frame.
std::optional<Vec3> EndOf(const Figure& figure, JointIndex body) {
  std::optional<Vec3> end;
  for (const Link& link : figure.links()) {
    if (link.joint != body) continue;
    for (const Vec3& p : {link.capsule.a, link.capsule.b}) {
      if (!end || p.norm() > end->norm()) end = p;
    }
  }
  return end;
}

BoneBody BodyOf(const Figure& figure, JointIndex joint) {
  const RigidInertia& moved = joint.is_valid() ? figure.body(joint) : figure.root_body();
  BoneBody body = {moved.mass, moved.com, moved.I_com, {}};
  for (const Link& link : figure.links()) {
    if (link.joint != joint) continue;
    body.capsules.push_back({link.name, link.capsule.a, link.capsule.b, link.capsule.radius});
  }
  return body;
}

class MotionCharacter {
 public:
  MotionCharacter(const Figure& figure, const Motion& motion, const FromMotionOptions& options)
      : figure_(figure),
        motion_(motion),
        options_(options),
        axes_(options.up, options.metres_per_unit) {}

  Character Make() {
    character_.name = options_.name;
    character_.up = options_.up;
    character_.metres_per_unit = options_.metres_per_unit;
    AddBones();
    Clip clip{options_.name,
              motion_.rate.seconds_per_frame(),
              static_cast<int>(motion_.frames.size()),
              {}};
    clip.tracks.push_back(RootTrack());
    for (const JointGroup& group : figure_.groups()) clip.tracks.push_back(TrackOf(group));
    character_.clips.push_back(std::move(clip));
    return std::move(character_);
  }

 private:
  void AddBones() {
    Bone root;
    root.name = figure_.root_name();
    root.rotation_order = options_.up == UpAxis::kY ? "YXZ" : "ZYX";
    character_.bones.push_back(std::move(root));
    for (const JointGroup& group : figure_.groups()) AddBone(group);
    AddEndSites();
    AddBodies();
  }

  void AddBodies() {
    for (size_t i = 0; i < character_.bones.size(); ++i) {
      const JointIndex body = i == 0 ? JointIndex() : figure_.groups()[i - 1].last();
      character_.bones[i].body = BodyOf(figure_, body);
    }
  }

  void AddBone(const JointGroup& group) {
    const Joint& first = figure_.joint(group.first);
    Bone bone;
    bone.name = group.name;
    bone.parent = BoneOf(figure_, first.parent);
    bone.rest = axes_.Turned(first.X_PJ);
    if (const auto order = OrderOf(figure_, group, axes_)) bone.rotation_order = order->letters;
    character_.bones.push_back(std::move(bone));
  }

  void AddEndSites() {
    std::vector<char> has_child(character_.bones.size());
    for (const Bone& bone : character_.bones) {
      if (bone.parent >= 0) has_child[static_cast<size_t>(bone.parent)] = true;
    }
    for (size_t i = 0; i < character_.bones.size(); ++i) {
      if (has_child[i]) continue;
      const JointIndex body = i == 0 ? JointIndex() : figure_.groups()[i - 1].last();
      const auto end = EndOf(figure_, body);
      if (end) character_.bones[i].end_site = axes_.Point(*end);
    }
  }

  BoneTrack RootTrack() const {
    BoneTrack track;
    for (const MotionFrame& frame : motion_.frames) {
      track.rotations.emplace_back(axes_.Turned(frame.X_WR.R));
      track.translations.push_back(axes_.Point(frame.X_WR.p));
    }
    return track;
  }

  BoneTrack TrackOf(const JointGroup& group) const {
    BoneTrack track;
    track.rotations.reserve(motion_.frames.size());
    const Eigen::Quaterniond rest(figure_.joint(group.first).X_PJ.R);
    const auto order = OrderOf(figure_, group, axes_);
    for (const MotionFrame& frame : motion_.frames) {
      track.rotations.push_back(axes_.Turned(RotationOf(group, rest, frame.q)));
      if (order) track.angles.push_back(AnglesOf(group, *order, frame.q));
    }
    return track;
  }

  Eigen::Quaterniond RotationOf(const JointGroup& group, Eigen::Quaterniond turn,
                                const VecX& q) const {
    for (int j = group.first.value(); j <= group.last().value(); ++j) {
      turn = turn * Eigen::AngleAxisd(q[j], figure_.joint(JointIndex(j)).axis);
    }
    return turn.normalized();
  }

  static Vec3 AnglesOf(const JointGroup& group, const HingeOrder& order, const VecX& q) {
    Vec3 angles = Vec3::Zero();
    for (int i = 0; i < group.size; ++i) {
      angles[i] = order.signs[static_cast<size_t>(i)] * q[group.first.value() + i];
    }
    return angles;
  }

  const Figure& figure_;
  const Motion& motion_;
  const FromMotionOptions& options_;
  FileAxes axes_;
  Character character_;
};

// Gives the character a bone that no joint is, beside that of its joint: "r_knee_50" takes half of
// the knee's angles.
int AddSkinBone(const Figure& figure, const Motion& motion, const SkinBone& named,
                const FigureBone& found, const FileAxes& axes, Character* character) {
  const Joint& first = figure.joint(figure.group(figure.joint(found.body).group).first);
  Bone bone;
  bone.name = named.joint;
  if (!found.is_body) bone.name += "_" + std::to_string(std::lround(100.0 * named.share));
  bone.parent = BoneOf(figure, first.parent);
  bone.rest = axes.Turned(first.X_PJ);
  BoneTrack track;
  for (const MotionFrame& frame : motion.frames) {
    track.rotations.emplace_back(axes.Turned(TurnOf(figure, found, frame.q)));
  }
  character->bones.push_back(std::move(bone));
  character->clips[0].tracks.push_back(std::move(track));
  return static_cast<int>(character->bones.size()) - 1;
}

// Whether the body beyond the joint is a bone: it is the last one of its hinges.
bool IsOwnBone(const Figure& figure, const FigureBone& bone) {
  if (!bone.body.is_valid()) return true;
  return bone.is_body && figure.group(figure.joint(bone.body).group).last() == bone.body;
}

Eigen::Matrix4d Turned(const Eigen::Matrix4d& M, const FileAxes& axes) {
  Eigen::Matrix4d turned = M;
  turned.topLeftCorner<3, 3>() = axes.Turned(Mat3(M.topLeftCorner<3, 3>()));
  turned.topRightCorner<3, 1>() = axes.Point(Vec3(M.topRightCorner<3, 1>()));
  return turned;
}

// Gives the character the meshes, materials and textures of a figure's skin, in the axes and the
// unit of the file. `bones`: the character's bone for each of the skin's.
//
// With P the matrix that takes metres and Hazumi's axes to the file's, a vertex in the world is
//   P X_WB M v = (P X_WB P^-1) (P M P^-1) (P v),
// so that bind matrices M become P M P^-1, poses likewise, and points P v.
void PutSkinOn(const Skin& skin, const std::vector<int>& bones, const FileAxes& axes,
               Character* character) {
  character->materials = skin.materials;
  character->textures = skin.textures;
  character->meshes = skin.meshes;
  for (SkinMesh& mesh : character->meshes) {
    for (SkinMesh::Bind& bind : mesh.binds) {
      bind.bone = bones[static_cast<size_t>(bind.bone)];
      bind.inverse_bind = Turned(bind.inverse_bind, axes);
    }
    for (Eigen::Vector3f& position : mesh.positions) position = axes.Point(position);
    for (Eigen::Vector3f& normal : mesh.normals) normal = axes.Direction(normal);
  }
}

}  // namespace

Result<Character> CharacterFromMotion(const Figure& figure, const Motion& motion,
                                      const FromMotionOptions& options) {
  Character character = MotionCharacter(figure, motion, options).Make();
  if (!options.skin) return character;
  std::vector<int> bones;
  const FileAxes axes(options.up, options.metres_per_unit);
  for (const SkinBone& bone : options.skin->bones) {
    const auto found = FindBone(figure, bone);
    if (!found) {
      return Error{ErrorCode::kSemantics, "", "skin.bones[" + std::to_string(bones.size()) + "]",
                   "the figure has no joint \"" + bone.joint + "\""};
    }
    bones.push_back(IsOwnBone(figure, *found)
                        ? BoneOf(figure, found->body)
                        : AddSkinBone(figure, motion, bone, *found, axes, &character));
  }
  PutSkinOn(*options.skin, bones, axes, &character);
  return character;
}

}  // namespace hazumi
