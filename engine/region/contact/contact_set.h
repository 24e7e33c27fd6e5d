#pragma once

#include <variant>
#include <vector>

#include "engine/region/constraints/constraint_row.h"
#include "engine/region/contact/contact_push.h"
#include "engine/region/contact/touch_point.h"
#include "engine/region/forces/force_law.h"

namespace hazumi {

enum class ContactMode : char {
  kOpen,
  kStick,  // the points that touch do not move against each other
  kSlide,  // they do, against `direction`
};

// Partner of a capsule: an obstacle of ContactSpec::obstacles, or the other capsule of a pair of
// ContactSpec::own.
struct TouchesObstacle {
  int obstacle = 0;
  bool operator==(const TouchesObstacle&) const = default;
  bool operator<(const TouchesObstacle& other) const { return obstacle < other.obstacle; }
};
struct TouchesCapsule {
  int own = 0;
  bool operator==(const TouchesCapsule&) const = default;
  bool operator<(const TouchesCapsule& other) const { return own < other.own; }
};
using ContactPartner = std::variant<TouchesObstacle, TouchesCapsule>;

// A pair of features that may touch, of a capsule and of its partner.
struct ContactPair {
  int capsule = 0;
  ContactPartner partner = {};
  int feature = 0;  // number of the pair of features
  ContactMode mode = ContactMode::kOpen;
  // Smallest gap that is allowed: 0, or negative where the pair was found that deep inside. While
  // the contact is active, the gap that it keeps [m].
  double allowed_gap = 0.0;
  small::V3 direction = {};   // unit, of sliding
  bool was_fast = false;      // sliding has been fast
  int slow_steps = 0;         // number of steps of slow sliding
  double load = 0.0;          // normal force when the contact became active [N]
  small::V3 step_force = {};  // in the latest time step [N]

  // Whether both are of the same two bodies.
  bool HasBodiesOf(const ContactPair& other) const {
    return capsule == other.capsule && partner == other.partner;
  }
};

// Slower than this what slides counts as coming to rest [m/s]: its direction turns faster than
// steps can follow.
inline constexpr double kSlowSlide = 1e-4;

// The contacts of an island's capsules. Between events the modes stay; whoever finds an event sets
// them. [METHOD 12]
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
  // Allows open pairs no deeper gap than the present one.
  void TightenGaps(const RegionState& state);
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
  void SetStepForce(int pair, const small::V3& force) { pairs_[pair].step_force = force; }
  void AllowGap(int pair, double gap) { pairs_[pair].allowed_gap = gap; }

  std::optional<TouchPoint> PointOf(int pair, const RegionState& state) const;
  // Returns whether a pair is too deep inside a box, or a capsule, to tell on which side it comes
  // out: it has no force.
  bool IsBuried(int pair, double gap) const;
  double FrictionOf(int pair) const;
  // The other capsule; none with an obstacle.
  std::optional<int> OtherCapsule(const ContactPair& pair) const;
  double RestitutionOf(int pair) const;
  // Returns the held object of the first capsule; -1 for a capsule of the figure.
  int BallOf(int pair) const { return spec_.capsules[pairs_[pair].capsule].ball; }
  // Whether the partner is a ball, which may have been let go inside.
  bool MayStayInside(const ContactPair& pair) const;

  ContactParts PartsOf(const ContactPair& pair) const;

  // Appends the rows of active contacts: one along the normal, and two across for one that sticks.
  // The force of one that slides leans backwards.
  void AppendRows(const RegionState& state, std::vector<ConstraintRow>* rows) const;

 private:
  bool IsExempt(int capsule, int obstacle) const;
  MovingCapsule CapsuleAt(int capsule, const RegionState& state) const;
  const OwnContact* OwnOf(const ContactPair& pair) const;
  const ContactObstacle& ObstacleOf(const ContactPair& pair) const;
  int NumFeaturesOf(const ContactPair& pair) const;
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
