#pragma once

#include <tuple>
#include <utility>

#include "engine/region/forces/force_law.h"

namespace hazumi {

class Retention;
struct RetentionSpec {
  using Law = Retention;
  static constexpr bool kIsOuter = false;  // as its law says
  VecX rates;  // by free hinge [1/s]: a hinge left to itself slows down as e^(-rate t)
};
inline auto MembersOf(const RetentionSpec& spec) {
  const auto& [rates] = spec;
  return std::tie(rates);
}

// Friction as the paper has it: a rule for accelerations, no torque. [METHOD 2.3]
class Retention : public ForceLaw {
 public:
  explicit Retention(RetentionSpec spec) : rates_(std::move(spec.rates)) {}

  std::string_view name() const override { return "friction"; }
  void AddAccelerations(const RegionState& state, double* x) const override;
  bool is_rule() const override { return true; }
  double FastestRate() const override;

 private:
  void AddOfHinges(const RegionState& state, const RegionLayout::Node& node, double* x) const;
  void AddOfBall(const RegionState& state, int node, double* x) const;

  VecX rates_;
};

}  // namespace hazumi
