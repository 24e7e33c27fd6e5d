#include "engine/region/forces/force_spec.h"

#include <algorithm>
#include <utility>

#include "engine/base/assert.h"

namespace hazumi {

namespace {

std::shared_ptr<const ForceLaw> MakeLaw(const RetentionSpec& spec) {
  return std::make_shared<Retention>(spec);
}
std::shared_ptr<const ForceLaw> MakeLaw(const TorqueSpec& spec) {
  return std::make_shared<TorqueDrive>(spec);
}
std::shared_ptr<const ForceLaw> MakeLaw(const SpringSpec& spec) {
  return std::make_shared<SpringDrive>(spec);
}
std::shared_ptr<const ForceLaw> MakeLaw(const WindSpec& spec) {
  return std::make_shared<Wind>(spec);
}
std::shared_ptr<const ForceLaw> MakeLaw(const AttractionSpec& spec) {
  return std::make_shared<Attraction>(spec);
}

}  // namespace

bool ActsFromOutside(const std::vector<ForceSpec>& specs) {
  return std::any_of(specs.begin(), specs.end(), [](const ForceSpec& spec) {
    return std::visit([](const auto& law) { return law.kIsOuter; }, spec);
  });
}

ForceLaws MakeLaws(const std::vector<ForceSpec>& specs) {
  ForceLaws laws;
  for (const ForceSpec& spec : specs) {
    laws.push_back(std::visit(
        [](const auto& values) {
          std::shared_ptr<const ForceLaw> law = MakeLaw(values);
          HAZUMI_DEMAND(law->is_outer() == values.kIsOuter);
          return law;
        },
        spec));
  }
  return laws;
}

ForceLaws FrictionAlone(VecX rates) {
  if (rates.isZero(0.0)) return {};
  return MakeLaws({RetentionSpec{std::move(rates)}});
}

}  // namespace hazumi
