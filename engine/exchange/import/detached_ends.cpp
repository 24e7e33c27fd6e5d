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

// An end, and the limb's last bone that it belongs on: bones of the character.
struct End {
  int bone = 0, limb = 0;
};

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

  std::vector<End> Find() const {
    const bool has_clips = !character_.clips.empty();
    if (has_clips && samples_.empty()) return {};  // nothing goes from place to place
    const std::vector<BodyPlace> places = has_clips ? std::vector<BodyPlace>() : Places();
    std::vector<End> found;
    for (int b = 0; b < size(); ++b) {
      if (!Wanted(b) || Parent(b) < 0) continue;
      const int limb = has_clips ? MovingLimb(b) : NamedLimb(b, places);
      if (limb >= 0) found.push_back({b, limb});
    }
    // A bone that hangs on an end is no limb of another.
    std::vector<End> sound;
    for (const End& end : found) {
      const bool hangs_on_end = std::any_of(found.begin(), found.end(), [&](const End& other) {
        return IsAbove(other.bone, end.limb);
      });
      if (!hangs_on_end) sound.push_back(end);
    }
    return sound;
  }

 private:
  int size() const { return static_cast<int>(wanted_.size()); }
  bool Wanted(int b) const { return wanted_[static_cast<size_t>(b)] != 0; }
  int Parent(int b) const { return character_.bones[static_cast<size_t>(b)].parent; }

  bool MayMove(int b) const {
    return std::any_of(character_.clips.begin(), character_.clips.end(), [&](const Clip& clip) {
      return !clip.tracks[static_cast<size_t>(b)].translations.empty();
    });
  }

  // Poses of some frames, if any bone but a top one goes from place to place.
  void Sample() {
    bool any_moves = false;
    for (int b = 0; b < size(); ++b) any_moves |= Wanted(b) && Parent(b) >= 0 && MayMove(b);
    if (!any_moves) return;
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
  // Ways of a bone from its median place in the frame of another.
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
    if (!MayMove(b) || MostMove(b) < kMoves * height_) return -1;
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
      // A limb without an end ends as far as the bone above is long.
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

// An end in the frame of its limb.
struct HungPose {
  Mat3 R;
  Vec3 p, scale;
};

HungPose PoseOn(const End& end, const Poses& poses) {
  const BonePose &b = poses[static_cast<size_t>(end.bone)],
                 &c = poses[static_cast<size_t>(end.limb)];
  return {c.R.transpose() * b.R, PlaceIn(c, b.p),
          b.stretch.diagonal() / c.stretch.diagonal().mean()};
}

void HangAtRest(const End& end, const Poses& rest, Character* character) {
  Bone& bone = character->bones[static_cast<size_t>(end.bone)];
  const HungPose pose = PoseOn(end, rest);
  bone.rest = {pose.R, pose.p};
  bone.rest_scale = pose.scale;
  bone.rotation_order.clear();
  bone.is_limb_end = true;
  bone.parent = end.limb;
}

void AddFrame(const HungPose& pose, bool has_scales, BoneTrack* track) {
  Eigen::Quaterniond q(pose.R);
  if (!track->rotations.empty() && q.dot(track->rotations.back()) < 0.0) q.coeffs() = -q.coeffs();
  track->rotations.push_back(q.normalized());
  track->translations.push_back(pose.p);
  if (has_scales) track->scales.push_back(pose.scale);
}

std::vector<BoneTrack> HungTracks(const std::vector<End>& ends, const Character& character,
                                  const Clip& clip) {
  std::vector<BoneTrack> tracks(ends.size());
  for (int f = 0; f < clip.num_frames; ++f) {
    const Poses poses = PosesAt(character, &clip, f);
    for (size_t i = 0; i < ends.size(); ++i) {
      const bool has_scales = !clip.tracks[static_cast<size_t>(ends[i].bone)].scales.empty();
      AddFrame(PoseOn(ends[i], poses), has_scales, &tracks[i]);
    }
  }
  return tracks;
}

}  // namespace

std::optional<Character> WithEndsOnLimbs(const std::vector<char>& wanted,
                                         const Character& character) {
  if (character.bones.size() < 3 || character.bones.size() > kMostBones) return std::nullopt;
  const std::vector<End> ends = Ends(wanted, character).Find();
  if (ends.empty()) return std::nullopt;
  Character hung = character;
  for (size_t k = 0; k < hung.clips.size(); ++k) {
    std::vector<BoneTrack> tracks = HungTracks(ends, character, character.clips[k]);
    for (size_t i = 0; i < ends.size(); ++i)
      hung.clips[k].tracks[static_cast<size_t>(ends[i].bone)] = std::move(tracks[i]);
  }
  const Poses rest = PosesAt(character, nullptr, 0);
  const auto name = [&](int b) { return character.bones[static_cast<size_t>(b)].name; };
  for (const End& end : ends) {
    HangAtRest(end, rest, &hung);
    hung.warnings.push_back(
        {name(end.bone), "moves with \"" + name(end.limb) + "\" but hangs on \"" +
                             name(character.bones[static_cast<size_t>(end.bone)].parent) +
                             "\": it is hung on the first"});
  }
  PutParentsFirst(&hung);
  return hung;
}

}  // namespace hazumi
