// Roles of bones whose names say nothing: those that their names would have told.

#include <gtest/gtest.h>

#include "tests/unit/exchange/made_characters.h"
#include "tests/unit/exchange/made_people.h"

namespace hazumi::test {
namespace {

std::vector<std::optional<BodyPlace>> RolesOf(const Character& character) {
  std::vector<std::optional<BodyPlace>> places;
  for (const JointSpec& joint : ImportWell(character).project.figure.spec.joints) {
    places.push_back(joint.body);
  }
  return places;
}

Character Nameless(Character character) {
  for (size_t b = 0; b < character.bones.size(); ++b) {
    character.bones[b].name = "bone" + std::to_string(b);
  }
  return character;
}

TEST(ShapeRoles, AreThoseThatNamesTell) {
  for (const bool collars : {true, false}) {
    for (const bool toes : {true, false}) {
      for (const int spine : {1, 2, 4}) {
        PersonBones bones;
        bones.collars = collars;
        bones.toes = toes;
        bones.spine = spine;
        const Character person = Person(bones);
        const auto named = RolesOf(person), nameless = RolesOf(Nameless(person));
        ASSERT_EQ(named.size(), nameless.size());
        for (size_t k = 0; k < named.size(); ++k) {
          ASSERT_TRUE(named[k] && nameless[k]);
          EXPECT_STREQ(NameOf(nameless[k]->role), NameOf(named[k]->role))
              << person.bones[k + 1].name << " " << collars << toes << spine;
          EXPECT_STREQ(NameOf(nameless[k]->side), NameOf(named[k]->side))
              << person.bones[k + 1].name << " " << collars << toes << spine;
        }
      }
    }
  }
}

TEST(ShapeRoles, OfWhatHangsTogetherOtherwiseAreNone) {
  for (const auto& place : RolesOf(Nameless(Hand()))) {
    EXPECT_FALSE(place && place->role != BodyRole::kNone);
  }
}

}  // namespace
}  // namespace hazumi::test
