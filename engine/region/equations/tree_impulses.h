#pragma once

#include <vector>

#include "engine/region/equations/articulated_bodies.h"

namespace hazumi {

// Motion of the bodies of a tree under impulses on several of them. Each operation concerns one
// body or one joint. A tour of all bodies, which may change the impulses on its way, takes O(nodes)
// [METHOD 12.10]. Velocities are changes; all rates before the impulses are zero. World axes.
class TreeImpulses {
 public:
  struct Impulse {
    small::V3 n, f;  // angular, about a node's origin [N m s]; linear [N s]
  };
  struct Motion {
    small::V3 w, v;  // angular, of a node [rad/s]; linear, of its origin [m/s]
  };

  explicit TreeImpulses(const RegionModel& model);

  // Prepares the tree for solved bodies of this layout, which has no balls, in this motion.
  void Begin(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
             const ArticulatedBodies& bodies);

  // Step of a tour to a dynamic node from its parent or, if `up`, back to the parent.
  struct Step {
    int node;
    bool up;
  };
  // Tour from the ground, the root of every tree, to all dynamic nodes and back.
  const std::vector<Step>& tour() const { return tour_; }

  bool is_dynamic(int node) const { return joints_[node].is_dynamic; }
  // Motion of a node due to an impulse on it.
  Motion ResponseTo(int node, const Impulse& impulse) const;
  // Change of the rate of a hinge due to an impulse of 1 N m s about it [1 / (kg m^2)].
  double ResponseOfHinge(int node, int hinge) const;

  // Sets known impulses: Clear, then Add for each, then Settle, which computes the motion of the
  // nodes.
  void Clear();
  void Add(int node, const Impulse& impulse);
  void AddAboutHinge(int node, int hinge, double impulse);
  void Settle();

  // Takes the next step of a tour, which begins at the ground after Settle. At the current node, Of
  // is valid and Push is allowed. At the parent of a node, Rate is valid and PushHinge is allowed
  // for the hinges of that node.
  void Take(const Step& step);
  const Motion& Of(int node) const { return motion_[node]; }
  void Push(int node, const Impulse& impulse);
  double Rate(int node, int hinge) const;
  void PushHinge(int node, int hinge, double impulse);

  // Changes of the rates of all free hinges [rad/s]. Requires Settle.
  VecX Rates() const;

 private:
  struct Joint {
    bool is_dynamic = false;
    int parent = 0;  // parent node or ground
    int dofs = 0, dof = 0;
    small::V3 r;                            // position relative to the parent's origin [m]
    std::array<small::V3, 3> axis, UI, UF;  // notation of ArticulatedBodies
    small::S3 D_inverse;
  };
  struct Response {
    small::S3 of_turn;  // w due to n
    small::M3 mixed;    // w due to f
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

  int ground_;  // index of the ground, after the nodes
  int num_free_;
  std::vector<Joint> joints_;        // one per node
  std::vector<Response> responses_;  // one per node, and the ground
  std::vector<Impulse> total_, pending_;
  std::vector<small::V3> about_hinges_;
  std::vector<Motion> motion_;
  std::vector<Step> tour_;
};

}  // namespace hazumi
