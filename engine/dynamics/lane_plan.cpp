#include "engine/dynamics/lane_plan.h"

#include <string>

#include "engine/dynamics/lane_bodies.h"

namespace hazumi {

namespace {

// The body in each lane of each step, -1 for none.
using Occupants = std::vector<std::array<int, kMaxLanes>>;

Occupants FindOccupants(const LanePlan& plan, int num_steps) {
  Occupants occupants(num_steps, {-1, -1, -1, -1});
  for (int b = 0; b < static_cast<int>(plan.bodies.size()); ++b) {
    occupants[plan.bodies[b].step][plan.bodies[b].lane] = b;
  }
  return occupants;
}

// Four lanes cost little more than one, but only pay if at least half of them have work.
void ChooseWidth(LanePlan* plan) {
  std::vector<LaneBody> wide = plan->bodies;
  const int steps = ScheduleBodies(kMaxLanes, &wide);
  if (2 * steps <= static_cast<int>(wide.size())) {
    plan->bodies = wide;
    plan->width = kMaxLanes;
    plan->steps.resize(steps);
  } else {
    plan->width = 1;
    plan->steps.resize(ScheduleBodies(1, &plan->bodies));
  }
}

// A shortest sequence of axes that contains the hinges of every lane in their order. `left` is what
// each lane has still to come, one letter an axis.
std::string CommonTurns(const std::array<std::string, kMaxLanes>& left) {
  std::string best;
  bool any = false;
  for (const char axis : {'0', '1', '2'}) {
    std::array<std::string, kMaxLanes> rest = left;
    for (std::string& lane : rest) {
      if (!lane.empty() && lane[0] == axis) lane.erase(0, 1);
    }
    if (rest == left) continue;
    const std::string turns = axis + CommonTurns(rest);
    if (!any || turns.size() < best.size()) best = turns;
    any = true;
  }
  return best;
}

void AddRows(const std::array<int, kMaxLanes>& lanes, LaneStep* step, LanePlan* plan) {
  std::array<std::string, kMaxLanes> left;
  for (int l = 0; l < plan->width; ++l) {
    if (lanes[l] < 0) continue;
    for (const LaneHinge& hinge : plan->bodies[lanes[l]].hinges) {
      left[l] += static_cast<char>('0' + hinge.axis);
    }
  }
  step->first_row = plan->num_rows();
  std::array<size_t, kMaxLanes> next = {};  // hinge of each lane
  for (const char turn : CommonTurns(left)) {
    const int row = plan->row(plan->num_rows());
    plan->row_axis.push_back(turn - '0');
    for (int l = 0; l < plan->width; ++l) {
      const bool used = next[l] < left[l].size() && left[l][next[l]] == turn;
      const LaneHinge hinge = used ? plan->bodies[lanes[l]].hinges[next[l]++] : LaneHinge{};
      plan->row_joint.push_back(used ? hinge.joint.value() : 0);
      if (!used) continue;
      plan->joint_at[hinge.joint.value()] = row + l;
      plan->joint_sign[hinge.joint.value()] = hinge.sign;
    }
  }
  step->end_row = plan->num_rows();
}

void SetFlags(const LanePlan& plan, const std::array<int, kMaxLanes>& lanes, LaneStep* step) {
  for (int l = 0; l < plan.width; ++l) {
    if (lanes[l] < 0) continue;
    const LaneBody& body = plan.bodies[lanes[l]];
    step->turned |= !body.F.isIdentity(0.0);
    step->shifted |= !body.p_PB.isZero(0.0);
  }
}

// Lanes without a body read along with the first that has one.
void SetParents(const LanePlan& plan, const std::array<int, kMaxLanes>& lanes, LaneStep* step) {
  std::array<int, kMaxLanes> states;
  int any = plan.root_state();
  for (int l = 0; l < plan.width; ++l) {
    if (lanes[l] < 0) continue;
    const int parent = plan.bodies[lanes[l]].parent;
    any = parent < 0 ? plan.root_state() : plan.state(plan.bodies[parent].step);
  }
  step->parent.contiguous = true;
  for (int l = 0; l < plan.width; ++l) {
    const int parent = lanes[l] < 0 ? -1 : plan.bodies[lanes[l]].parent;
    const bool at_root = lanes[l] >= 0 && parent < 0;
    states[l] = parent >= 0 ? plan.state(plan.bodies[parent].step)
                : at_root   ? plan.root_state()
                            : any;
    const int lane = parent >= 0 ? plan.bodies[parent].lane : l;
    step->parent.from[l] = states[l] + lane;
    step->parent.contiguous &= lane == l && states[l] == states[0];
  }
}

// What the lanes of one step add to their parents' loads, one child of each parent a round.
class ChildRounds {
 public:
  ChildRounds(const LanePlan& plan, const std::array<int, kMaxLanes>& parents)
      : plan_(plan), parents_(parents) {}

  void Add(const LaneBody& child) {
    const int lane = plan_.bodies[child.parent].lane;
    const int load = plan_.state(child.step) + LaneState::kLoad * plan_.width;
    if (child.step != step_) first_ = static_cast<int>(rounds_.size());
    step_ = child.step;
    int r = first_;
    while (r < static_cast<int>(rounds_.size()) && rounds_[r].from[lane] != plan_.empty_load()) ++r;
    if (r == static_cast<int>(rounds_.size())) AddRound();
    rounds_[r].from[lane] = load + child.lane;
  }

  // Lanes without a parent may read anything that is at hand.
  std::vector<LaneSource> Take() {
    for (LaneSource& round : rounds_) {
      const int base = round.from[FirstUsed(round)] - FirstUsed(round);
      round.contiguous = base % plan_.width == 0;  // lanes stay where they are
      for (int l = 0; l < plan_.width; ++l) {
        if (parents_[l] >= 0) round.contiguous &= round.from[l] == base + l;
      }
      if (round.contiguous) round.from[0] = base;
    }
    return std::move(rounds_);
  }

 private:
  void AddRound() {
    rounds_.emplace_back();
    rounds_.back().from.fill(plan_.empty_load());
  }
  int FirstUsed(const LaneSource& round) const {
    int l = 0;
    while (round.from[l] == plan_.empty_load()) ++l;
    return l;
  }

  const LanePlan& plan_;
  const std::array<int, kMaxLanes>& parents_;
  std::vector<LaneSource> rounds_;
  int step_ = -1, first_ = 0;
};

void SetChildren(const Occupants& occupants, LanePlan* plan) {
  std::vector<std::vector<int>> children(plan->steps.size());  // by the step of the parent
  for (const auto& lanes : occupants) {
    for (const int b : lanes) {
      if (b < 0 || plan->bodies[b].parent < 0) continue;
      children[plan->bodies[plan->bodies[b].parent].step].push_back(b);
    }
  }
  for (size_t s = 0; s < plan->steps.size(); ++s) {
    ChildRounds rounds(*plan, occupants[s]);
    for (const int b : children[s]) rounds.Add(plan->bodies[b]);
    plan->steps[s].first_child = static_cast<int>(plan->children.size());
    for (const LaneSource& round : rounds.Take()) plan->children.push_back(round);
    plan->steps[s].end_child = static_cast<int>(plan->children.size());
  }
}

// The sign of each entry of the rows, 0 where the lane sits the turn out.
LaneArray RowSigns(const LanePlan& plan) {
  LaneArray signs(plan.row_joint.size());
  for (size_t i = 0; i < plan.row_joint.size(); ++i) {
    const int r = static_cast<int>(i) / plan.width, l = static_cast<int>(i) % plan.width;
    const int joint = plan.row_joint[i];
    if (plan.joint_at[joint] == plan.row(r) + l) signs.data()[i] = plan.joint_sign[joint];
  }
  return signs;
}

// A lane without a body carries a unit one, so that nothing is ever divided by zero there.
LaneBody Dummy() {
  LaneBody body;
  body.inertia = {1.0, Vec3::Zero(), Mat3::Identity()};
  return body;
}

// Writes the constants of a body to every width-th place from `at`.
void WriteConstants(const LaneBody& body, int width, double* at) {
  const RigidInertia& inertia = body.inertia;
  const auto put = [&](int field, double value) { at[field * width] = value; };
  const Mat3 I_o = inertia.I_com + PointInertia(inertia.mass, inertia.com);
  put(LaneConstants::kMass, inertia.mass);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) put(LaneConstants::kF + 3 * i + j, body.F(i, j));
    put(LaneConstants::kOrigin + i, body.p_PB[i]);
    put(LaneConstants::kMoment + i, inertia.mass * inertia.com[i]);
    put(LaneConstants::kInertia + i, I_o(i, i));
    put(LaneConstants::kInertia + 3 + i, I_o((i + 1) % 3, (i + 2) % 3));
  }
}

}  // namespace

LanePlan::LanePlan(const Figure& figure)
    : bodies(MergeConcentricHinges(figure)),
      joint_at(figure.num_joints()),
      joint_sign(figure.num_joints()) {
  ChooseWidth(this);
  const Occupants occupants = FindOccupants(*this, static_cast<int>(steps.size()));
  constants = LaneArray(steps.size() * LaneConstants::kFields * width);
  for (size_t s = 0; s < steps.size(); ++s) {
    AddRows(occupants[s], &steps[s], this);
    SetFlags(*this, occupants[s], &steps[s]);
    SetParents(*this, occupants[s], &steps[s]);
    for (int l = 0; l < width; ++l) {
      const int b = occupants[s][l];
      WriteConstants(b < 0 ? Dummy() : bodies[b], width,
                     constants.data() + s * LaneConstants::kFields * width + l);
    }
  }
  row_sign = RowSigns(*this);
  SetChildren(occupants, this);
}

}  // namespace hazumi
