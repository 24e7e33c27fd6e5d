#include "tests/unit/exchange/made_people.h"

#include <gtest/gtest.h>

namespace hazumi::test {
namespace {

constexpr double kHipHeight = 0.5308, kNeckHeight = 0.8653,
                 kShoulderHeight = 0.82;                    // of the stature
constexpr double kHipWidth = 0.047, kShoulderWidth = 0.11;  // of one side

int Find(const std::string& name, const Character& character) {
  for (size_t b = 0; b < character.bones.size(); ++b) {
    if (character.bones[b].name == name) return static_cast<int>(b);
  }
  ADD_FAILURE() << name;
  return 0;
}

// Where a bone begins, all at rest without turns.
Vec3 PlaceOf(int bone, const Character& character) {
  Vec3 p = Vec3::Zero();
  for (; bone >= 0; bone = character.bones[bone].parent) p += character.bones[bone].rest.p;
  return p;
}

class Maker {
 public:
  explicit Maker(const PersonBones& bones) : bones_(bones) {
    character_.name = "person";
    character_.up = UpAxis::kZ;
    character_.metres_per_unit = 1.0;
    Bone hips;
    hips.name = "Hips";
    hips.rest.p = kPersonHeight * Vec3(0, 0, kHipHeight + 0.02);
    character_.bones.push_back(hips);
  }

  Character Make() {
    for (const double side : {1.0, -1.0}) Leg(side);
    const std::string chest = Spine();
    for (const double side : {1.0, -1.0}) Arm(side, chest);
    Head(chest);
    return std::move(character_);
  }

 private:
  // At a place in the world, as a share of the stature.
  void Add(const std::string& name, const std::string& parent, const Vec3& at) {
    Bone bone;
    bone.name = name;
    bone.parent = Find(parent, character_);
    bone.rest.p = kPersonHeight * at - PlaceOf(bone.parent, character_);
    character_.bones.push_back(bone);
  }
  void End(const std::string& name, const Vec3& at) {
    const int bone = Find(name, character_);
    character_.bones[bone].end_site = kPersonHeight * at - PlaceOf(bone, character_);
  }
  Vec3 At(const std::string& name) const {
    return PlaceOf(Find(name, character_), character_) / kPersonHeight;
  }

  void Leg(double side) {
    const std::string name = side > 0.0 ? "Left" : "Right", letter = side > 0.0 ? "L" : "R";
    const double y = side * kHipWidth;
    std::string above = "Hips";
    if (bones_.hip_joints) {
      Add(letter + "HipJoint", above,
          bones_.stacked ? At("Hips") : Vec3(0, 0.5 * y, kHipHeight + 0.01));
      above = letter + "HipJoint";
    }
    Add(name + "UpLeg", above, Vec3(0, y, kHipHeight));
    if (bones_.twists) Add(name + "UpLegRoll", name + "UpLeg", Vec3(0, y, 0.41));
    Add(name + "Leg", name + "UpLeg", Vec3(0, y, 0.2883));
    Add(name + "Foot", name + "Leg", Vec3(0, y, 0.039));
    if (bones_.toes) Add(name + "ToeBase", name + "Foot", Vec3(0.08, y, 0.01));
    End(bones_.toes ? name + "ToeBase" : name + "Foot", Vec3(0.11, y, 0.01));
  }

  // Gives the last of its bones.
  std::string Spine() {
    std::string above = "Hips";
    const double low = kHipHeight + 0.02;
    for (int i = 0; i < bones_.spine; ++i) {
      const std::string name = "Spine" + (i == 0 ? std::string() : std::to_string(i));
      const double part = (i + (bones_.stacked ? 0.0 : 0.5)) / bones_.spine;
      Add(name, above, Vec3(0, 0, low + part * (kNeckHeight - low)));
      above = name;
    }
    return above;
  }

  void Arm(double side, const std::string& chest) {
    const std::string name = side > 0.0 ? "Left" : "Right";
    const double y = side * kShoulderWidth;
    std::string above = chest;
    if (bones_.collars) {
      Add(name + "Shoulder", above, bones_.stacked ? At(chest) : Vec3(0, 0.2 * y, kShoulderHeight));
      above = name + "Shoulder";
    }
    Add(name + "Arm", above, Vec3(0, y, kShoulderHeight));
    if (bones_.twists) Add(name + "ArmRoll", name + "Arm", Vec3(0, y, 0.74));
    Add(name + "ForeArm", name + "Arm", Vec3(0, y, 0.6582));
    if (bones_.twists) Add(name + "ForeArmRoll", name + "ForeArm", Vec3(0, y, 0.58));
    if (!bones_.hands) return End(name + "ForeArm", Vec3(0, y, 0.5038));
    Add(name + "Hand", name + "ForeArm", Vec3(0, y, 0.5038));
    if (!bones_.fingers) return End(name + "Hand", Vec3(0, y, 0.40));
    for (const char* finger : {"Thumb", "Index", "Middle", "Ring", "Pinky"})
      Finger(name, finger, y);
  }

  void Finger(const std::string& side, const std::string& finger, double y) {
    std::string above = side + "Hand";
    const double x = 0.01 * static_cast<double>(finger[0] % 5);
    for (int i = 1; i <= 3; ++i) {
      const std::string name = side + "Hand" + finger + std::to_string(i);
      Add(name, above, Vec3(x, y, 0.47 - 0.02 * i));
      above = name;
    }
    End(above, Vec3(x, y, 0.40));
  }

  void Head(const std::string& chest) {
    std::string above = chest;
    for (int i = 0; i < bones_.necks; ++i) {
      const std::string name = "Neck" + (i == 0 ? std::string() : std::to_string(i));
      const Vec3 at(0, 0, kNeckHeight + 0.02 * i);
      Add(name, above, bones_.stacked && i == 0 ? At(chest) : at);
      above = name;
    }
    if (!bones_.head) return End(above, Vec3(0, 0, 1.0));
    Add("Head", above, Vec3(0, 0, kNeckHeight + 0.04));
    End("Head", Vec3(0, 0, 1.0));
  }

  PersonBones bones_;
  Character character_;
};

}  // namespace

Character Person(const PersonBones& bones) { return Maker(bones).Make(); }

Character Renamed(Character character,
                  const std::vector<std::pair<std::string, std::string>>& names) {
  for (const auto& [from, to] : names) character.bones[Find(from, character)].name = to;
  return character;
}

void Hang(const std::string& name, const std::string& on, const Vec3& offset,
          Character* character) {
  Bone bone;
  bone.name = name;
  bone.parent = Find(on, *character);
  bone.rest.p = offset;
  character->bones.push_back(bone);
}

}  // namespace hazumi::test
