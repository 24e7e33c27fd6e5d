#include "engine/body/bone_roles.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace hazumi {

namespace {

struct RoleWords {
  BodyRole role;
  std::vector<std::string> words;  // that the name has as words
};

// Words that name no part of a body. The first row with a word of the name counts.
const std::vector<RoleWords>& RoleWordList() {
  static const std::vector<RoleWords> words = {
      {BodyRole::kCloth,
       {"hair", "cape", "cloak", "skirt", "cloth", "scarf", "coat", "belt", "strap", "ribbon",
        "braid", "ponytail", "tassel", "sleeve", "dress", "beard"}},
      {BodyRole::kWeapon,
       {"sword", "shield", "weapon", "gun", "bow", "slot", "handslot", "prop", "axe", "staff",
        "spear", "knife", "socket", "attach"}},
      {BodyRole::kTail, {"tail"}},
      {BodyRole::kWing, {"wing", "feather"}},
      {BodyRole::kEar, {"ear", "ears"}}};
  return words;
}

BodyRole RoleByWord(const std::string& name) {
  const std::vector<std::string> words = WordsOfName(name);
  for (const RoleWords& row : RoleWordList()) {
    for (const std::string& word : row.words) {
      if (std::find(words.begin(), words.end(), word) != words.end()) return row.role;
    }
  }
  return BodyRole::kNone;
}

bool HasWord(const std::string& name, std::initializer_list<const char*> wanted) {
  const std::vector<std::string> words = WordsOfName(name);
  return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
    return std::any_of(wanted.begin(), wanted.end(),
                       [&](const char* other) { return word.starts_with(other); });
  });
}

class Roles {
 public:
  explicit Roles(const std::vector<NamedBone>& bones)
      : bones_(bones), told_(BonesInBody(bones)), places_(bones.size()) {
    std::vector<std::string> names;
    names.reserve(bones.size());
    for (const NamedBone& bone : bones) names.push_back(bone.name);
    names_ = WithoutPrefix(std::move(names));
    for (const std::string& name : names_) read_.push_back(ReadBoneName(name));
  }

  BoneRoles Tell() {
    if (!IsBody(told_)) return {std::move(places_), false};
    const bool has_four_legs = HasFourLegs();
    for (size_t b = 0; b < bones_.size(); ++b) places_[b] = Place(b, has_four_legs);
    SetHips();
    SetSpine();
    return {std::move(places_), has_four_legs};
  }

 private:
  int parent(size_t b) const { return bones_[b].parent; }
  BodyRole above(size_t b) const {
    return parent(b) < 0 ? BodyRole::kNone : places_[static_cast<size_t>(parent(b))].role;
  }

  bool IsFront(size_t b) const { return HasWord(names_[b], {"front", "fore"}); }

  // Legs in front: a thigh that is called so and another one on its side that is not.
  bool HasFourLegs() const {
    std::array<bool, 3> front = {}, back = {};
    for (size_t b = 0; b < bones_.size(); ++b) {
      if (told_[b].part != BodyPart::kThigh) continue;
      const auto side = static_cast<size_t>(told_[b].side);
      (IsFront(b) ? front : back)[side] = true;
    }
    const auto left = static_cast<size_t>(BodySide::kLeft);
    return front[left] && back[left];
  }

  // A role that one bone of a side has: the first one; others are parts of it.
  BodyRole First(BodyRole role, BodySide side) {
    bool& is_taken = taken_[static_cast<size_t>(side)][static_cast<size_t>(role)];
    if (is_taken) return BodyRole::kTwist;
    is_taken = true;
    return role;
  }

  BodyRole Limb(size_t b, BodyRole role) {
    if (told_[b].side == BodySide::kMiddle) return BodyRole::kNone;
    return read_[b].is_twist ? BodyRole::kTwist : First(role, told_[b].side);
  }

  BodyPlace Place(size_t b, bool has_four_legs) {
    const BodyName& body = told_[b];
    const auto is_own = read_[b].body.part != BodyPart::kOther;
    BodyRole role = RoleByWord(names_[b]);
    if (role == BodyRole::kNone && read_[b].is_helper) role = BodyRole::kHelper;
    if (role == BodyRole::kNone) role = RoleOfPart(b, is_own, has_four_legs);
    return {role, body.side};
  }

  BodyRole RoleOfPart(size_t b, bool is_own, bool has_four_legs) {
    const bool is_front = has_four_legs && IsFrontLeg(b);
    switch (told_[b].part) {
      case BodyPart::kTrunk:
        return told_[b].side != BodySide::kMiddle && Carries(b, BodyPart::kUpperArm)
                   ? First(BodyRole::kClavicle, told_[b].side)
                   : BodyRole::kNone;
      case BodyPart::kNeck:
        return BodyRole::kNeck;
      case BodyPart::kHead:
        return told_[b].side == BodySide::kMiddle && above(b) != BodyRole::kHead && is_own
                   ? First(BodyRole::kHead, BodySide::kMiddle)
                   : BodyRole::kNone;
      case BodyPart::kUpperArm:
        return Limb(b, BodyRole::kUpperArm);
      case BodyPart::kForearm:
        return Limb(b, BodyRole::kForearm);
      case BodyPart::kHand:
        return Hand(b);
      case BodyPart::kThigh:
        return Limb(b, is_front ? BodyRole::kUpperArm : BodyRole::kThigh);
      case BodyPart::kShank:
        return Limb(b, is_front ? BodyRole::kForearm : BodyRole::kShin);
      case BodyPart::kFoot:
        return Foot(b, is_front);
      case BodyPart::kPelvis:
      case BodyPart::kOther:
        break;
    }
    return BodyRole::kNone;
  }

  bool IsFrontLeg(size_t b) const {
    for (int at = static_cast<int>(b); at >= 0; at = parent(static_cast<size_t>(at))) {
      if (IsFront(static_cast<size_t>(at))) return true;
    }
    return false;
  }

  // The first bone of a hand is the hand; a second one that is called so, below a wrist, is not.
  BodyRole Hand(size_t b) {
    if (told_[b].side == BodySide::kMiddle) return BodyRole::kNone;
    const bool is_finger =
        HasWord(names_[b], {"finger", "thumb", "index", "mid", "ring", "pink", "little"});
    if (!is_finger) {
      const BodyRole role = First(BodyRole::kHand, told_[b].side);
      return role == BodyRole::kHand ? role : BodyRole::kNone;
    }
    return BodyRole::kFinger;
  }

  BodyRole Foot(size_t b, bool is_front) {
    if (told_[b].side == BodySide::kMiddle) return BodyRole::kNone;
    const BodyRole first = First(is_front ? BodyRole::kHand : BodyRole::kFoot, told_[b].side);
    if (first != BodyRole::kTwist || is_front) return first;
    const BodyRole second = First(BodyRole::kToe, told_[b].side);
    return second == BodyRole::kToe ? second : BodyRole::kNone;
  }

  bool Carries(size_t b, BodyPart part) const {
    for (size_t other = b + 1; other < bones_.size(); ++other) {
      if (told_[other].part == part && IsBelow(other, b)) return true;
    }
    return false;
  }
  bool IsBelow(size_t b, size_t top) const {
    int at = static_cast<int>(b);
    while (at > static_cast<int>(top)) at = parent(static_cast<size_t>(at));
    return at == static_cast<int>(top);
  }

  void SetHips() {
    size_t hips = 0;
    for (size_t b = bones_.size(); b-- > 0;) {
      const bool is_pelvis =
          told_[b].part == BodyPart::kPelvis && told_[b].side == BodySide::kMiddle;
      if (is_pelvis) hips = b;
    }
    places_[hips] = {BodyRole::kHips, BodySide::kMiddle};
    hips_ = hips;
  }

  bool CarriesRole(size_t b, BodyRole role) const {
    for (size_t other = b + 1; other < bones_.size(); ++other) {
      if (places_[other].role == role && IsBelow(other, b)) return true;
    }
    return false;
  }

  // The way from the neck, the head or an arm down to the hips. A neck that carries arms is a part
  // of it; what carries legs, as the first spine of a Biped, is not.
  void SetSpine() {
    int top = -1;
    for (size_t b = 0; b < bones_.size(); ++b) {
      const bool is_neck = places_[b].role == BodyRole::kNeck;
      if (is_neck && CarriesRole(b, BodyRole::kUpperArm)) {
        places_[b] = {BodyRole::kSpine, BodySide::kMiddle};
      }
    }
    for (const BodyRole wanted : {BodyRole::kNeck, BodyRole::kHead, BodyRole::kUpperArm}) {
      for (size_t b = 0; b < bones_.size() && top < 0; ++b) {
        if (places_[b].role == wanted) top = static_cast<int>(b);
      }
    }
    if (top < 0 || !IsBelow(static_cast<size_t>(top), hips_)) return;
    for (int b = parent(static_cast<size_t>(top)); b > static_cast<int>(hips_);
         b = parent(static_cast<size_t>(b))) {
      BodyPlace& place = places_[static_cast<size_t>(b)];
      if (CarriesRole(static_cast<size_t>(b), BodyRole::kThigh)) break;
      if (place.role == BodyRole::kNone) place = {BodyRole::kSpine, BodySide::kMiddle};
    }
  }

  const std::vector<NamedBone>& bones_;
  std::vector<BodyName> told_;
  std::vector<std::string> names_;  // without what all begin with
  std::vector<ReadName> read_;
  std::vector<BodyPlace> places_;
  std::array<std::array<bool, static_cast<size_t>(BodyRole::kHelper) + 1>, 3> taken_ = {};
  size_t hips_ = 0;
};

}  // namespace

BoneRoles RolesByName(const std::vector<NamedBone>& bones) { return Roles(bones).Tell(); }

}  // namespace hazumi
