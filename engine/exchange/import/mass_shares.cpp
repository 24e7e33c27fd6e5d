// Masses by the table: links are cut into pieces. A piece belongs to the segment of its bone, in
// the trunk to the part at its height on the line from the middle of the hip joints (MIDH, 0)
// through that of the shoulders (MIDS) to the cervicale (CERV, 1). A segment's mass is spread over
// its pieces by m_i ~ V_i exp(lambda t_i), V_i the volume and t_i the place along the segment, with
// the lambda that puts the centre of mass, the mean of t_i, where the table has it. A head that is
// far larger than people's has the share of the mass that it has of the mesh's volume.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/exchange/import/figure_parts.h"

namespace hazumi {

namespace {

constexpr int kPieces = 32;            // of a link
constexpr double kSteepest = 8.0;      // |lambda|: e^8 from one end to the other
constexpr double kShoulders = 0.8545;  // of the way from MIDH to CERV [de Leva 1996]
constexpr double kBigHead = 1.5;       // share of the volume over the table's of the mass
constexpr double kUnseen = 0.1;        // of a link's volume, if the mesh there encloses nothing

double VolumeOf(const LinkSpec& link) {
  const double r = link.radius;
  return std::numbers::pi * r * r * ((link.to - link.from).norm() + 4.0 / 3.0 * r);
}

struct Line {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  Vec3 At(double t) const { return from + t * (to - from); }
  // 0 at its beginning, 1 at its end.
  double Along(const Vec3& p) const {
    const Vec3 way = to - from;
    const double length2 = way.squaredNorm();
    return length2 > 0.0 ? (p - from).dot(way) / length2 : 0.5;
  }
};

struct Piece {
  LinkSpec* link;
  size_t slot;
  Vec3 p;         // in its bone's frame [m]
  double t;       // from the segment's beginning to its end, kept to [0, 1]
  double weight;  // in its slot, to a factor: first the volume
};

// Weights so that the mean of t is `com`, or as near to it as pieces can be made to weigh.
void TiltTo(double com, std::vector<Piece*>* pieces) {
  const auto mean = [&](double lambda) {
    double sum = 0.0, moment = 0.0;
    for (const Piece* piece : *pieces) {
      const double weight = piece->weight * std::exp(lambda * piece->t);
      sum += weight;
      moment += weight * piece->t;
    }
    return moment / sum;
  };
  double low = -kSteepest, high = kSteepest;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (mean(middle) < com ? low : high) = middle;
  }
  for (Piece* piece : *pieces) piece->weight *= std::exp(0.5 * (low + high) * piece->t);
}

// A slot is a segment of a side.
constexpr size_t kSlots = 3 * kNumRows;
size_t SlotOf(BodySegment segment, BodySide side) {
  const BodySide of_limb = IsLimb(segment) ? side : BodySide::kMiddle;
  return 3 * static_cast<size_t>(segment) + static_cast<size_t>(of_limb);
}

class Table {
 public:
  // `volumes`: of the mesh, by kept bone; empty: not known.
  Table(const Skeleton& skeleton, const FigurePlan& plan, const std::vector<double>& volumes,
        std::vector<std::vector<LinkSpec>>* links)
      : skeleton_(skeleton), bodies_(RestBodies(plan)), volumes_(volumes), links_(*links) {}

  std::string Weigh(double mass) {
    FindLimbs();
    FindTrunk();
    for (size_t k = 0; k < links_.size(); ++k) {
      for (LinkSpec& link : links_[k]) Cut(k, &link);
    }
    Tilt();
    FillTrunk();
    const bool has_big_head = GiveHeadItsVolume();
    Spread(mass);
    return "as de Leva's table of men has them" + Missing() +
           (has_big_head ? ", its big head by the volume of the mesh" : "");
  }

 private:
  struct Limb {
    Line line;
    bool is_there = false, has_end = false;
  };

  const KeptBone& bone(size_t k) const { return skeleton_.bones[k]; }
  Limb& LimbOf(size_t k) { return limbs_[SlotOf(bone(k).segment, bone(k).body.side)]; }

  // From where a segment's first bone begins to where the next segment does, or to the farthest
  // end.
  void FindLimbs() {
    for (size_t k = 0; k < links_.size(); ++k) {
      if (bone(k).segment == BodySegment::kTrunk) continue;
      Limb& limb = LimbOf(k);
      if (!limb.is_there) limb.line.from = limb.line.to = bodies_[k].p;
      limb.is_there = true;
      for (const int child : bone(k).children) {
        const bool is_next = IsLimb(bone(child).segment) && &LimbOf(child) != &limb;
        if (is_next) limb.line.to = bodies_[child].p;
        limb.has_end = limb.has_end || is_next;
      }
      for (const LinkSpec& link : links_[k]) {
        const Vec3 end = bodies_[k] * link.to, from = limb.line.from;
        const bool is_farther = (end - from).norm() > (limb.line.to - from).norm();
        if (!limb.has_end && is_farther) limb.line.to = end;
      }
    }
  }

  // The middle of where a segment begins on each side it is on.
  std::optional<Vec3> Beginning(BodySegment segment) const {
    Vec3 sum = Vec3::Zero();
    int num = 0;
    for (const BodySide side : {BodySide::kMiddle, BodySide::kLeft, BodySide::kRight}) {
      const Limb& limb = limbs_[SlotOf(segment, side)];
      if (!limb.is_there || (num > 0 && !IsLimb(segment))) continue;
      sum += limb.line.from;
      ++num;
    }
    return num == 0 ? std::optional<Vec3>() : Vec3(sum / num);
  }

  void FindTrunk() {
    trunk_.from = Beginning(BodySegment::kThigh).value_or(bodies_[0].p);
    trunk_.to = trunk_.from;
    const auto reach = [&](const std::optional<Vec3>& p) {
      const Vec3 from = trunk_.from;
      if (p && (*p - from).norm() > (trunk_.to - from).norm()) trunk_.to = *p;
    };
    if (const auto shoulders = Beginning(BodySegment::kUpperArm)) {
      reach(trunk_.from + (*shoulders - trunk_.from) / kShoulders);
      return BeginHead();
    }
    reach(Beginning(BodySegment::kHead));
    if (trunk_.to != trunk_.from) return;
    for (size_t k = 0; k < links_.size(); ++k) {
      if (bone(k).segment != BodySegment::kTrunk) continue;
      for (const LinkSpec& link : links_[k]) reach(bodies_[k] * link.to);
    }
  }

  // At CERV, wherever the bones of the neck begin.
  void BeginHead() {
    Limb& head = limbs_[SlotOf(BodySegment::kHead, BodySide::kMiddle)];
    const bool is_above = (head.line.to - trunk_.to).dot(trunk_.to - trunk_.from) > 0.0;
    if (head.is_there && is_above) head.line.from = trunk_.to;
  }

  static BodySegment PartOfTrunk(double height) {
    if (height < RowOf(BodySegment::kLowerTrunk).trunk_end) return BodySegment::kLowerTrunk;
    if (height < RowOf(BodySegment::kMiddleTrunk).trunk_end) return BodySegment::kMiddleTrunk;
    return BodySegment::kUpperTrunk;
  }

  static double BeginningOf(BodySegment part) {
    if (part == BodySegment::kLowerTrunk) return 0.0;
    return RowOf(part == BodySegment::kMiddleTrunk ? BodySegment::kLowerTrunk
                                                   : BodySegment::kMiddleTrunk)
        .trunk_end;
  }

  void Cut(size_t k, LinkSpec* link) {
    const BodySide side = bone(k).body.side;
    for (int i = 0; i < kPieces; ++i) {
      const double at = (i + 0.5) / kPieces;
      const Vec3 p = link->from + at * (link->to - link->from);
      const Vec3 p_R = bodies_[k] * p;
      BodySegment segment = bone(k).segment;
      const bool is_trunk = segment == BodySegment::kTrunk;
      double t = is_trunk ? trunk_.Along(p_R) : LimbOf(k).line.Along(p_R);
      const bool is_spine = is_trunk && side == BodySide::kMiddle;
      const Vec3 place = is_spine ? bodies_[k].Inverse() * trunk_.At(t) : p;
      if (is_trunk) {
        segment = PartOfTrunk(t);
        const double begin = BeginningOf(segment);
        t = (t - begin) / (RowOf(segment).trunk_end - begin);
      }
      pieces_.push_back(
          {link, SlotOf(segment, side), place, std::clamp(t, 0.0, 1.0), VolumeOf(*link)});
    }
  }

  void Tilt() {
    std::array<std::vector<Piece*>, kSlots> of_slot;
    for (Piece& piece : pieces_) of_slot[piece.slot].push_back(&piece);
    for (size_t slot = 0; slot < kSlots; ++slot) {
      if (of_slot[slot].empty()) continue;
      TiltTo(RowOf(static_cast<BodySegment>(slot / 3)).com, &of_slot[slot]);
      for (const Piece* piece : of_slot[slot]) sums_[slot] += piece->weight;
    }
  }

  // A part of the trunk where no bone is weighs with the part beside it.
  void FillTrunk() {
    using enum BodySegment;
    for (int row = 0; row < kNumRows; ++row) {
      for (size_t side = 0; side < 3; ++side) {
        shares_[3 * row + side] = RowOf(static_cast<BodySegment>(row)).mass;
      }
    }
    const auto give = [&](BodySegment from, BodySegment to) {
      const size_t a = SlotOf(from, BodySide::kMiddle), b = SlotOf(to, BodySide::kMiddle);
      if (sums_[a] > 0.0) return;
      shares_[b] += shares_[a];
      shares_[a] = 0.0;
    };
    give(kLowerTrunk, kMiddleTrunk);
    give(kUpperTrunk, kMiddleTrunk);
    const bool has_lower = sums_[SlotOf(kLowerTrunk, BodySide::kMiddle)] > 0.0;
    give(kMiddleTrunk, has_lower ? kLowerTrunk : kUpperTrunk);
  }

  double SumOfShares() const {
    double sum = 0.0;
    for (size_t slot = 0; slot < kSlots; ++slot) sum += sums_[slot] > 0.0 ? shares_[slot] : 0.0;
    return sum;
  }

  bool GiveHeadItsVolume() {
    double head = 0.0, all = 0.0;
    for (size_t k = 0; k < volumes_.size(); ++k) {
      const double volume = std::max(0.0, volumes_[k]);
      all += volume;
      if (bone(k).segment == BodySegment::kHead) head += volume;
    }
    const size_t slot = SlotOf(BodySegment::kHead, BodySide::kMiddle);
    const double sum = SumOfShares();
    if (all <= 0.0 || head >= all || sums_[slot] <= 0.0) return false;
    if (head / all <= kBigHead * shares_[slot] / sum) return false;
    shares_[slot] = (sum - shares_[slot]) * head / (all - head);
    return true;
  }

  void Spread(double mass) {
    const double sum = SumOfShares();
    for (auto& links : links_) {
      for (LinkSpec& link : links) link.mass = 0.0;
    }
    for (size_t i = 0; i < pieces_.size(); i += kPieces) {
      LinkSpec& link = *pieces_[i].link;
      Vec3 moment = Vec3::Zero();
      for (size_t j = i; j < i + kPieces; ++j) {
        const Piece& piece = pieces_[j];
        const double own = mass * shares_[piece.slot] / sum * piece.weight / sums_[piece.slot];
        *link.mass += own;
        moment += own * piece.p;
      }
      link.com = moment / *link.mass;
    }
  }

  std::string Missing() const {
    constexpr std::pair<BodySegment, const char*> kNames[] = {
        {BodySegment::kHead, "head"},        {BodySegment::kUpperArm, "upper arms"},
        {BodySegment::kForearm, "forearms"}, {BodySegment::kHand, "hands"},
        {BodySegment::kThigh, "thighs"},     {BodySegment::kShank, "shanks"},
        {BodySegment::kFoot, "feet"}};
    std::string missing;
    for (const auto& [segment, name] : kNames) {
      if (!Beginning(segment))
        missing += (missing.empty() ? " without " : ", ") + std::string(name);
    }
    return missing;
  }

  const Skeleton& skeleton_;
  std::vector<Pose> bodies_;
  const std::vector<double>& volumes_;
  std::vector<std::vector<LinkSpec>>& links_;
  std::array<Limb, kSlots> limbs_ = {};
  Line trunk_;
  std::vector<Piece> pieces_;  // of a link one after the other
  std::array<double, kSlots> sums_ = {}, shares_ = {};
};

std::string WeighByVolume(const std::vector<double>& of_mesh, double mass,
                          std::vector<std::vector<LinkSpec>>* links) {
  double sum = 0.0;
  for (size_t k = 0; k < links->size(); ++k) {
    double of_links = 0.0;
    for (const LinkSpec& link : (*links)[k]) of_links += VolumeOf(link);
    const double volume = of_mesh.empty() ? of_links : std::max(of_mesh[k], kUnseen * of_links);
    for (LinkSpec& link : (*links)[k]) link.mass = volume * VolumeOf(link) / of_links;
    sum += volume;
  }
  for (auto& of_bone : *links) {
    for (LinkSpec& link : of_bone) *link.mass *= mass / sum;
  }
  return of_mesh.empty() ? "by the volume of the bones' capsules" : "by the volume of the mesh";
}

}  // namespace

std::string Weigh(const Skeleton& skeleton, const FigurePlan& plan, const Skin& skin, double mass,
                  std::vector<std::vector<LinkSpec>>* links) {
  const std::vector<double> volumes = MeshVolumes(skin, plan);
  if (skeleton.bones[0].segment != BodySegment::kNone) {
    return Table(skeleton, plan, volumes, links).Weigh(mass);
  }
  return WeighByVolume(volumes, mass, links);
}

}  // namespace hazumi
