#include "engine/exchange/import/told_roles.h"

#include <algorithm>

#include "engine/body/shape_roles.h"
#include "engine/exchange/import/import_names.h"

namespace hazumi {

namespace {

void TakeRole(BodyPlace place, Skeleton* skeleton, KeptBone* bone) {
  bone->place = place;
  bone->body = {PartOf(place.role), place.side};
  bone->segment = SegmentOf(bone->body.part);
  if (bone->segment != BodySegment::kNone) return;
  const bool is_root = bone->parent < 0;
  bone->segment =
      is_root ? BodySegment::kTrunk : skeleton->bones[static_cast<size_t>(bone->parent)].segment;
}

std::optional<Error> GiveRole(const std::string& name, BodyPlace place, const Character& character,
                              Skeleton* skeleton) {
  const auto wrong = [](const std::string& message) {
    return Error{ErrorCode::kSemantics, "", "roles", message};
  };
  std::vector<KeptBone>& bones = skeleton->bones;
  const auto found = std::find_if(bones.begin(), bones.end(), [&](const KeptBone& bone) {
    return character.bones[static_cast<size_t>(bone.bone)].name == name;
  });
  if (found == bones.end()) return wrong("no bone that becomes a joint is called " + Quoted(name));
  if (NeedsSide(place.role) && place.side == BodySide::kMiddle) {
    return wrong(Quoted(name) + " is left or right: say which, as \"left " +
                 std::string(NameOf(place.role)) + "\"");
  }
  for (KeptBone& bone : bones) {
    if (IsSingle(place.role) && bone.place == place) bone.place = BodyPlace();
  }
  TakeRole(place, skeleton, &*found);
  return std::nullopt;
}

}  // namespace

bool TellRolesByShape(const WorldFrame& world, Skeleton* skeleton) {
  std::vector<KeptBone>& kept = skeleton->bones;
  const auto has_place = [](const KeptBone& bone) { return bone.place != BodyPlace(); };
  if (std::any_of(kept.begin(), kept.end(), has_place)) return false;
  std::vector<RestBone> bones = RestBonesOf(*skeleton, world);
  if (!SetRolesByShape(&bones)) return false;
  for (size_t k = 0; k < bones.size(); ++k) TakeRole(bones[k].place, skeleton, &kept[k]);
  return true;
}

std::optional<Error> GiveRoles(const RoleMap& roles, const Character& character,
                               Skeleton* skeleton) {
  for (const auto& [name, place] : roles) {
    if (auto error = GiveRole(name, place, character, skeleton)) return error;
  }
  return std::nullopt;
}

void SayMissingParts(const Skeleton& skeleton, ImportReport* report) {
  using enum BodyRole;
  const auto has = [&](const auto& is_it) {
    return std::any_of(skeleton.bones.begin(), skeleton.bones.end(),
                       [&](const KeptBone& bone) { return is_it(bone.place); });
  };
  const auto has_limb = [&](BodyRole first, BodyRole last) {
    return has([&](BodyPlace place) { return place.role >= first && place.role <= last; });
  };
  if (!has_limb(kUpperArm, kHand) || !has_limb(kThigh, kFoot)) return;
  for (const BodyRole role : {kUpperArm, kForearm, kThigh, kShin}) {
    for (const BodySide side : {BodySide::kLeft, BodySide::kRight}) {
      if (has([&](BodyPlace place) { return place == BodyPlace{role, side}; })) continue;
      std::string part = NameOf(role);
      std::replace(part.begin(), part.end(), '_', ' ');
      report->warnings.push_back(
          {"roles", std::string("no bone is the ") + NameOf(side) + " " + part +
                        "; say which it is, or throws, jumps and poses leave that limb alone"});
    }
  }
}

}  // namespace hazumi
