#include "engine/bake/moving_base_cache.h"

namespace hazumi {

namespace {

int NumDrivenHinges(const std::vector<ModelNode>& nodes) {
  int count = 0;
  for (const ModelNode& node : nodes) count += node.role == Role::kDriven ? node.num_hinges : 0;
  return count;
}

}  // namespace

Carrier CarrierOf(const RegionModel& model, int first_moved, double gravity,
                  const DrivenMotion& curves, double t, double end) {
  Carrier carrier;
  carrier.t = t;
  carrier.end = end;
  carrier.gravity = gravity;
  carrier.node = model.nodes[first_moved].parent;
  carrier.chain.assign(model.nodes.begin(), model.nodes.begin() + first_moved);
  const auto first = curves.angles.begin();
  carrier.curves = {{first, first + NumDrivenHinges(carrier.chain)}, curves.root_position};
  carrier.curves.holds_until = curves.holds_until;
  carrier.R_root = model.R_root;
  carrier.coupling = model.coupling;
  carrier.pin_node = model.pin_node;
  carrier.p_pin = model.p_pin;
  return carrier;
}

}  // namespace hazumi
