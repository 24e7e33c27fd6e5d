#pragma once

#include <vector>

#include "engine/passive/articulated_bodies.h"

namespace hazumi {

// How the bodies of a tree move when impulses act on several of them. Each operation concerns one
// body or one joint, so that a tour of all of them, which may change the impulses on its way, takes
// O(nodes) [METHOD 12.10]. Velocities are changes, with all rates before them zero. World axes.
class TreeImpulses {
 public:
  struct Impulse {
    small::V3 n, f;  // about a node's origin [N m s], at it [N s]
  };
  struct Motion {
    small::V3 w, v;  // of a node [rad/s], of its origin [m/s]
  };

  explicit TreeImpulses(const RegionModel& model);

  // For bodies that were solved for this layout, which has no balls, and this motion.
  void Begin(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
             const ArticulatedBodies& bodies);

  // A step to a dynamic node from its parent or, of `up`, back.
  struct Step {
    int node;
    bool up;
  };
  // From the ground, which carries every tree, to all dynamic nodes and back.
  const std::vector<Step>& tour() const { return tour_; }

  bool is_dynamic(int node) const { return joints_[node].is_dynamic; }
  // What an impulse on a node does to it.
  Motion ResponseTo(int node, const Impulse& impulse) const;
  // What an impulse of 1 N m s about a hinge does to the rate of that hinge [1 / (kg m^2)].
  double ResponseOfHinge(int node, int hinge) const;

  // Impulses that are known: all of them are added, then Settle makes the nodes move.
  void Clear();
  void Add(int node, const Impulse& impulse);
  void AddAboutHinge(int node, int hinge, double impulse);
  void Settle();

  // A tour begins at the ground after Settle, and takes its steps in order. Where it is at a node
  // that moves as Of says, and may be pushed; at the parent of a node Rates are right, and the
  // node's hinges may be pushed.
  void Take(const Step& step);
  const Motion& Of(int node) const { return motion_[node]; }
  void Push(int node, const Impulse& impulse);
  double Rate(int node, int hinge) const;
  void PushHinge(int node, int hinge, double impulse);

  // After Settle: changes of the rates of all free hinges [rad/s].
  VecX Rates() const;

 private:
  struct Joint {
    bool is_dynamic = false;
    int parent = 0;  // or the ground
    int dofs = 0, dof = 0;
    small::V3 r;                            // from the parent's origin [m]
    std::array<small::V3, 3> axis, UI, UF;  // as ArticulatedBodies has them
    small::S3 D_inverse;
  };
  struct Response {
    small::S3 of_turn;  // w of n
    small::M3 mixed;    // w of f
    small::S3 of_shift;
  };

  void ListTour();
  void FindResponse(int node);
  static small::V3 AlongAxes(const Joint& joint, const small::V3& n);
  static small::V3 RatesOf(const Joint& joint, small::V3 u, const Motion& at);
  small::V3 TotalAbout(int node) const;
  static Motion ParentAt(const Joint& joint, const Motion& parent);
  Impulse Passed(int node, const Impulse& impulse, const small::V3& about_hinges) const;
  static Motion Carried(const Joint& joint, const small::V3& u, const Motion& parent);

  int ground_;  // its index: after the nodes
  int num_free_;
  std::vector<Joint> joints_;        // by node
  std::vector<Response> responses_;  // by node, and of the ground
  std::vector<Impulse> total_, pending_;
  std::vector<small::V3> about_hinges_;
  std::vector<Motion> motion_;
  std::vector<Step> tour_;
};

}  // namespace hazumi
