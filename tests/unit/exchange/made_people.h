#pragma once

// People made in memory: bones with names and places, as rigs have them.

#include "engine/exchange/character/character.h"

namespace hazumi::test {

struct PersonBones {
  int spine = 3;  // joints between the pelvis and the neck or, without one, the head
  int necks = 1;
  bool collars = true, hip_joints = false, twists = false, fingers = false, toes = true;
  bool hands = true, head = true;
  bool stacked = false;  // the first bones of spine, neck, collars, hips lie where they hang
};

// A man 1.7 m tall with de Leva's lengths, arms hanging, z up, in metres; Mixamo's names.
Character Person(const PersonBones& bones);
constexpr double kPersonHeight = 1.7;

// The same bones as another rig calls them: pairs of names, the first Mixamo's. Bones not among
// them are left as they are.
Character Renamed(Character character,
                  const std::vector<std::pair<std::string, std::string>>& names);

// Adds a bone that hangs on another, as far away.
void Hang(const std::string& name, const std::string& on, const Vec3& offset, Character* character);

}  // namespace hazumi::test
