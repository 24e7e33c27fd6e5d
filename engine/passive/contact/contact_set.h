#pragma once

#include <vector>

#include "engine/passive/constraints/constraint_row.h"
#include "engine/passive/contact/contact_push.h"
#include "engine/passive/contact/touch_point.h"
#include "engine/passive/forces/force_law.h"

namespace hazumi {

enum class ContactMode : char {
  kOpen,
  kStick,  // the points that touch do not move against each other
  kSlide,  // they do, against `direction`
};

// A pair of features that may touch: of a capsule and an obstacle or, numbered after these, of both
// capsules of one of ContactSpec::own.
struct ContactPair {
  int capsule = 0, obstacle = 0, pair = 0;
  ContactMode mode = ContactMode::kOpen;
  // So deep is it let in, since it was when it was found; and, once it is closed, at that it is
  // kept [m].
  double floor = 0.0;
  small::V3 direction = {};  // unit, of sliding
  // Of sliding: it has been fast; or for so many steps it has not.
  bool was_fast = false;
  int slow_steps = 0;
  double load = 0.0;      // that pushed on it when it closed [N]
  small::V3 frozen = {};  // what it gave for the latest while (FrozenContacts) [N]
};

// Slower than this what slides counts as coming to rest [m/s]: its direction turns faster than
// steps can follow.
inline constexpr double kSlowSlide = 1e-4;

// What an island's capsules touch. Between events the modes stay; whoever finds an event sets them
// anew. [METHOD 12]
class ContactSet {
 public:
  explicit ContactSet(ContactSpec spec);

  const ContactSpec& spec() const { return spec_; }
  const SolverRules& rules() const { return spec_.rules; }
  bool is_possible() const { return !spec_.empty(); }
  bool any_closed() const { return num_closed_ > 0; }
  // Points of pairs computed so far, for counting work.
  long num_samples() const { return num_samples_; }

  // Forgets everything.
  void Begin();
  // Lists the pairs that are nearer than `reach` [m]; keeps what is known of those that were
  // there, and those that are closed.
  void FindPairs(const RegionState& state, double reach);
  // Pairs that have come out may not go in again.
  void RaiseFloors(const RegionState& state);
  double thinnest() const { return thinnest_; }  // radius of a capsule [m]
  // The fastest that any capsule's end moves [m/s], or any capsule turns [rad/s].
  struct Speed {
    double end, turn;
  };
  Speed Fastest(const RegionState& state) const;
  double FastestEnd(const RegionState& state) const { return Fastest(state).end; }

  const std::vector<ContactPair>& pairs() const { return pairs_; }
  void OpenAll();
  void SetMode(int pair, ContactMode mode);
  void Slide(int pair, const small::V3& direction);
  // At the end of a step: directions for the next one. True: something slides too slowly.
  bool FollowSlides(const RegionState& state);
  void SetLoad(int pair, double load) { pairs_[pair].load = load; }
  void SetFrozen(int pair, const small::V3& force) { pairs_[pair].frozen = force; }
  void SetFloor(int pair, double floor) { pairs_[pair].floor = floor; }

  std::optional<TouchPoint> PointOf(int pair, const RegionState& state) const;
  // So deep inside a box, or a capsule, that there is no telling on which side it comes out: it is
  // not felt.
  bool IsBuried(int pair, double gap) const;
  double FrictionOf(int pair) const;
  // The capsule that it is with, if it is not with an obstacle.
  std::optional<int> OtherCapsule(const ContactPair& pair) const;
  double RestitutionOf(int pair) const;
  // Returns the held object of the first capsule; -1 for a capsule of the figure.
  int BallOf(int pair) const { return spec_.capsules[pairs_[pair].capsule].ball; }
  // With a ball that may have been let go inside.
  bool MayStayInside(const ContactPair& pair) const;

  ContactParts PartsOf(const ContactPair& pair) const;

  // Of the closed ones: a row each along the normal, and two across of those that stick; the force
  // of one that slides points backwards as well.
  void AppendRows(const RegionState& state, std::vector<ConstraintRow>* rows) const;

 private:
  bool IsExempt(int capsule, int obstacle) const;
  MovingCapsule CapsuleAt(int capsule, const RegionState& state) const;
  const OwnContact* OwnOf(const ContactPair& pair) const;
  int NumPairsOf(const ContactPair& pair) const;
  std::optional<TouchPoint> PointOf(const ContactPair& pair, const MovingCapsule& moving,
                                    const MovingCapsule* other) const;
  void AddPairs(ContactPair pair);

  small::V3 SlideOf(const ContactPair& pair, const TouchPoint& point) const;

  ContactSpec spec_;
  double thinnest_;
  std::vector<ContactPair> pairs_, before_;
  std::vector<MovingCapsule> moving_;  // by capsule, in FindPairs
  int num_closed_ = 0;
  mutable long num_samples_ = 0;
};

// Two unit vectors across n.
struct Across {
  small::V3 s, t;
};
Across AcrossOf(const small::V3& n);

}  // namespace hazumi
