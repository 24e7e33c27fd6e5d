// With X_b = (p_b, R_b, s_b) place, rotation and even scale of a bone in the world, an end b that
// is hung on a limb's bone c has in its frame
//   p = R_c^T (p_b - p_c) / s_c,   R = R_c^T R_b,   s = s_b / s_c,
// at rest and in each frame of a clip.

#include "engine/exchange/import/detached_ends.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "engine/body/bone_roles.h"
#include "engine/exchange/import/bone_order.h"
#include "engine/exchange/import/skeleton.h"

namespace hazumi {

namespace {

constexpr double kStays = 3e-3;      // what an end moves at its limb, the median, of the height
constexpr double kCloser = 1e-3;     // of two limbs that move alike the nearer one
constexpr double kMoves = 2e-2;      // what it moves in its parent at least, of the height
constexpr double kNear = 0.12;       // from the limb's end at rest without clips, of the height
constexpr int kMostSamples = 200;    // frames of all clips that are looked at
constexpr size_t kMostBones = 1000;  // of a character that is searched

using Poses = std::vector<BonePose>;

double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Vec3 PlaceIn(const BonePose& frame, const Vec3& p) {
  return (frame.R * frame.stretch).inverse() * (p - frame.p);
}

class Ends {
 public:
  Ends(const std::vector<char>& wanted, const Character& character)
      : wanted_(wanted), character_(character), rest_(PosesAt(character, nullptr, 0)) {
    Vec3 low = rest_[0].p, high = low;
    for (const BonePose& pose : rest_) {
      low = low.cwiseMin(pose.p);
      high = high.cwiseMax(pose.p);
    }
    height_ = (high - low).maxCoeff();
    has_wanted_child_.assign(wanted.size(), 0);
    for (size_t b = wanted.size(); b-- > 0;) {
      const int parent = character.bones[b].parent;
      const bool carries = wanted[b] || has_wanted_child_[b];
      if (parent >= 0 && carries) has_wanted_child_[static_cast<size_t>(parent)] = 1;
    }
    Sample();
  }

  // Pairs of an end and the bone that it belongs on.
  std::vector<std::pair<int, int>> Find() const {
    std::vector<std::pair<int, int>> found;
    const std::vector<BodyPlace> places = samples_.empty() ? Places() : std::vector<BodyPlace>();
    for (int b = 0; b < size(); ++b) {
      if (!Wanted(b) || Parent(b) < 0) continue;
      const int limb = samples_.empty() ? NamedLimb(b, places) : MovingLimb(b);
      if (limb >= 0) found.emplace_back(b, limb);
    }
    // What hangs on an end is no limb of another.
    const auto hangs_on_end = [&](const std::pair<int, int>& pair) {
      return std::any_of(found.begin(), found.end(),
                         [&](const auto& other) { return IsAbove(other.first, pair.second); });
    };
    std::vector<std::pair<int, int>> sound;
    for (const std::pair<int, int>& pair : found) {
      if (!hangs_on_end(pair)) sound.push_back(pair);
    }
    return sound;
  }

 private:
  int size() const { return static_cast<int>(wanted_.size()); }
  bool Wanted(int b) const { return wanted_[static_cast<size_t>(b)] != 0; }
  int Parent(int b) const { return character_.bones[static_cast<size_t>(b)].parent; }

  void Sample() {
    long frames = 0;
    for (const Clip& clip : character_.clips) frames += clip.num_frames;
    const long step = std::max<long>(1, frames / kMostSamples);
    long at = 0;
    for (const Clip& clip : character_.clips) {
      for (int f = 0; f < clip.num_frames; ++f) {
        if (at++ % step == 0) samples_.push_back(PosesAt(character_, &clip, f));
      }
    }
  }

  bool IsAbove(int above, int b) const {
    for (; b >= 0; b = Parent(b)) {
      if (b == above) return true;
    }
    return false;
  }

  // Last bones of limbs: nothing that is wanted hangs on them. An end's own parent is above them.
  bool MayBelong(int b, int limb) const {
    return Wanted(limb) && !has_wanted_child_[static_cast<size_t>(limb)] && !IsAbove(b, limb) &&
           Parent(b) != limb && IsAbove(Parent(b), limb) && Parent(limb) != Parent(b) &&
           rest_[static_cast<size_t>(limb)].is_even();
  }

  struct Move {
    double median = 0.0, mean = 0.0;
  };
  // What a bone moves in the frame of another, from its median place there.
  Move MoveIn(int b, int frame) const {
    std::array<std::vector<double>, 3> places;
    for (const Poses& poses : samples_) {
      const Vec3 p = PlaceIn(poses[static_cast<size_t>(frame)], poses[static_cast<size_t>(b)].p);
      for (size_t i = 0; i < 3; ++i) places[i].push_back(p[static_cast<Eigen::Index>(i)]);
    }
    const Vec3 middle = {MedianOf(places[0]), MedianOf(places[1]), MedianOf(places[2])};
    std::vector<double> ways;
    double sum = 0.0;
    for (size_t s = 0; s < samples_.size(); ++s) {
      ways.push_back((Vec3(places[0][s], places[1][s], places[2][s]) - middle).norm());
      sum += ways.back();
    }
    const double scale = rest_[static_cast<size_t>(frame)].stretch.diagonal().mean();
    return {MedianOf(ways) * scale, sum / static_cast<double>(ways.size()) * scale};
  }

  double RestDistance(int a, int b) const {
    return (rest_[static_cast<size_t>(a)].p - rest_[static_cast<size_t>(b)].p).norm();
  }

  double MostMove(int b) const {
    const auto parent = static_cast<size_t>(Parent(b));
    const auto own = static_cast<size_t>(b);
    const Vec3 first = PlaceIn(samples_[0][parent], samples_[0][own].p);
    double most = 0.0;
    for (const Poses& poses : samples_)
      most = std::max(most, (PlaceIn(poses[parent], poses[own].p) - first).norm());
    return most * rest_[parent].stretch.diagonal().mean();
  }

  int MovingLimb(int b) const {
    const bool may_move =
        std::any_of(character_.clips.begin(), character_.clips.end(), [&](const Clip& clip) {
          return !clip.tracks[static_cast<size_t>(b)].translations.empty();
        });
    if (!may_move || MostMove(b) < kMoves * height_) return -1;
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int limb = 0; limb < size(); ++limb) {
      if (!MayBelong(b, limb)) continue;
      const Move move = MoveIn(b, limb);
      const double cost = move.mean + kCloser * RestDistance(b, limb);
      if (move.median > kStays * height_ || cost >= least) continue;
      least = cost;
      best = limb;
    }
    return best;
  }

  std::vector<BodyPlace> Places() const {
    std::vector<NamedBone> named;
    for (const Bone& bone : character_.bones) named.push_back({bone.name, bone.parent});
    return RolesByName(named).places;
  }

  int NamedLimb(int b, const std::vector<BodyPlace>& places) const {
    const BodyPlace& own = places[static_cast<size_t>(b)];
    const BodyRole wanted = own.role == BodyRole::kFoot   ? BodyRole::kShin
                            : own.role == BodyRole::kHand ? BodyRole::kForearm
                                                          : BodyRole::kNone;
    if (wanted == BodyRole::kNone) return -1;
    const Vec3& at = rest_[static_cast<size_t>(b)].p;
    for (int limb = 0; limb < size(); ++limb) {
      const bool is_its = places[static_cast<size_t>(limb)] == BodyPlace{wanted, own.side};
      if (!is_its || !MayBelong(b, limb)) continue;
      const BonePose& pose = rest_[static_cast<size_t>(limb)];
      const auto& end = character_.bones[static_cast<size_t>(limb)].end_site;
      const Vec3& above = rest_[static_cast<size_t>(Parent(limb))].p;
      // Where it ends is not known without an end: as far as the bone above is long.
      const double off = end ? (pose.At(*end) - at).norm()
                             : std::abs((pose.p - at).norm() - (pose.p - above).norm());
      if (off <= kNear * height_) return limb;
    }
    return -1;
  }

  const std::vector<char>& wanted_;
  const Character& character_;
  const Poses rest_;
  std::vector<char> has_wanted_child_;
  std::vector<Poses> samples_;
  double height_ = 0.0;
};

// `from`: the character as it was.
void Hang(int end, int limb, const Character& from, Character* character) {
  const auto b = static_cast<size_t>(end), c = static_cast<size_t>(limb);
  const auto below = [&](const Poses& poses, Mat3* R, Vec3* p, Vec3* scale) {
    *R = poses[c].R.transpose() * poses[b].R;
    *p = PlaceIn(poses[c], poses[b].p);
    *scale = poses[b].stretch.diagonal() / poses[c].stretch.diagonal().mean();
  };
  Bone& bone = character->bones[b];
  Bone hung = bone;
  below(PosesAt(from, nullptr, 0), &hung.rest.R, &hung.rest.p, &hung.rest_scale);
  for (size_t i = 0; i < from.clips.size(); ++i) {
    Clip& clip = character->clips[i];
    BoneTrack track;
    for (int f = 0; f < clip.num_frames; ++f) {
      Mat3 R;
      Vec3 p, scale;
      below(PosesAt(from, &from.clips[i], f), &R, &p, &scale);
      Eigen::Quaterniond q(R);
      if (f > 0 && q.dot(track.rotations.back()) < 0.0) q.coeffs() = -q.coeffs();
      track.rotations.push_back(q.normalized());
      track.translations.push_back(p);
      if (!clip.tracks[b].scales.empty()) track.scales.push_back(scale);
    }
    clip.tracks[b] = std::move(track);
  }
  hung.is_limb_end = true;
  hung.rotation_order.clear();
  hung.parent = limb;
  bone = std::move(hung);
}

}  // namespace

std::optional<Character> WithEndsOnLimbs(const std::vector<char>& wanted,
                                         const Character& character) {
  if (character.bones.size() < 3 || character.bones.size() > kMostBones) return std::nullopt;
  const std::vector<std::pair<int, int>> ends = Ends(wanted, character).Find();
  if (ends.empty()) return std::nullopt;
  Character hung = character;
  for (const auto& [end, limb] : ends) {
    const auto name = [&](int b) { return character.bones[static_cast<size_t>(b)].name; };
    Hang(end, limb, character, &hung);
    hung.warnings.push_back({name(end), "moves with \"" + name(limb) + "\" but hangs on \"" +
                                            name(character.bones[static_cast<size_t>(end)].parent) +
                                            "\": it is hung on the first"});
  }
  PutParentsFirst(&hung);
  return hung;
}

}  // namespace hazumi
