#include "engine/body/body_names.h"

#include <algorithm>
#include <array>

namespace hazumi {

namespace {

bool IsEnd(BodyPart part) {
  return part == BodyPart::kHand || part == BodyPart::kFoot || part == BodyPart::kHead;
}

class Names {
 public:
  explicit Names(const std::vector<NamedBone>& bones) : bones_(bones) {
    std::vector<std::string> names;
    names.reserve(bones.size());
    for (const NamedBone& bone : bones) names.push_back(bone.name);
    names = WithoutPrefix(std::move(names));
    for (size_t b = 0; b < bones.size(); ++b) {
      const int parent = bones[b].parent;
      ReadName name = ReadBoneName(names[b]);
      BodySide& side = name.body.side;
      if (side == BodySide::kMiddle && parent >= 0) side = read_[parent].body.side;
      read_.push_back(name);
      Count(name);
    }
  }

  std::vector<BodyName> Tell() {
    for (size_t b = 0; b < bones_.size(); ++b) told_.push_back(Told(b));
    return std::move(told_);
  }

 private:
  void Count(const ReadName& name) {
    const auto side = static_cast<size_t>(name.body.side);
    words_[side][static_cast<size_t>(name.word)] = true;
    if (name.word == BodyWord::kClear) parts_[side][static_cast<size_t>(name.body.part)] = true;
    const bool is_sided = name.body.side != BodySide::kMiddle;
    has_sides_ = has_sides_ || (is_sided && IsLimb(name.body.part));
  }
  bool Has(BodySide side, BodyPart part) const {
    return parts_[static_cast<size_t>(side)][static_cast<size_t>(part)];
  }
  bool Has(BodySide side, BodyWord word) const {
    return words_[static_cast<size_t>(side)][static_cast<size_t>(word)];
  }

  BodyName Told(size_t b) const {
    BodyName name = read_[b].body;
    const BodyName above = bones_[b].parent < 0 ? BodyName() : told_[bones_[b].parent];
    name.part = Clear(read_[b], above.part);
    // "Footsteps", "spring": words of limbs that are on no side, where others are.
    if (has_sides_ && name.side == BodySide::kMiddle && IsLimb(name.part)) {
      name.part = BodyPart::kOther;
    }
    if (IsEnd(above.part)) name.part = above.part;
    return name;
  }

  BodyPart Clear(const ReadName& name, BodyPart above) const {
    const BodySide side = name.body.side;
    switch (name.word) {
      case BodyWord::kClear:
        return name.body.part;
      case BodyWord::kHip:
        return Has(side, BodyPart::kThigh) ? BodyPart::kPelvis : BodyPart::kThigh;
      case BodyWord::kShoulder:
        return Has(side, BodyPart::kUpperArm) || Has(side, BodyWord::kArm) ? BodyPart::kTrunk
                                                                           : BodyPart::kUpperArm;
      case BodyWord::kArm:
        return Next(name, above, {BodyPart::kUpperArm, BodyPart::kForearm, BodyPart::kHand});
      case BodyWord::kLeg:
        return Leg(name, above);
    }
    return name.body.part;
  }

  BodyPart Leg(const ReadName& name, BodyPart above) const {
    const BodySide side = name.body.side;
    const bool has_thigh = Has(side, BodyPart::kThigh) || Has(side, BodyWord::kHip);
    if (has_thigh && !name.is_twist) return BodyPart::kShank;
    return Next(name, above, {BodyPart::kThigh, BodyPart::kShank, BodyPart::kFoot});
  }

  // Of a limb whose bones are all called the same: the next one down, unless another has its name.
  BodyPart Next(const ReadName& name, BodyPart above, const std::array<BodyPart, 3>& limb) const {
    for (size_t i = 0; i < limb.size(); ++i) {
      if (above != limb[i]) continue;
      const bool is_last = name.is_twist || i + 1 == limb.size();
      return is_last || Has(name.body.side, limb[i + 1]) ? above : limb[i + 1];
    }
    return limb[0];
  }

  const std::vector<NamedBone>& bones_;
  std::vector<ReadName> read_;
  std::vector<BodyName> told_;
  std::array<std::array<bool, kNumBodyParts>, 3> parts_ = {};  // by side: named clearly
  std::array<std::array<bool, 5>, 3> words_ = {};              // by side
  bool has_sides_ = false;
};

}  // namespace

std::vector<BodyName> BonesInBody(const std::vector<NamedBone>& bones) {
  return Names(bones).Tell();
}

bool IsBody(const std::vector<BodyName>& bones) {
  bool has_middle = false, has_limb = false;
  for (const BodyName& bone : bones) {
    const bool is_middle = bone.side == BodySide::kMiddle;
    const bool is_of_limb = IsLimb(bone.part);
    has_middle = has_middle || (is_middle && !is_of_limb && bone.part != BodyPart::kOther);
    has_limb = has_limb || (!is_middle && is_of_limb);
  }
  return has_middle && has_limb;
}

}  // namespace hazumi
