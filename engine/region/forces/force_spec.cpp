#include "engine/region/forces/force_spec.h"

#include <algorithm>
#include <utility>

#include "engine/base/assert.h"

namespace hazumi {

bool ActsFromOutside(const std::vector<ForceSpec>& specs) {
  return std::any_of(specs.begin(), specs.end(), [](const ForceSpec& spec) {
    return std::visit([](const auto& law) { return law.kIsOuter; }, spec);
  });
}

ForceLaws MakeLaws(const std::vector<ForceSpec>& specs) {
  ForceLaws laws;
  for (const ForceSpec& spec : specs) {
    laws.push_back(std::visit(
        []<typename Spec>(const Spec& values) -> std::shared_ptr<const ForceLaw> {
          auto law = std::make_shared<typename Spec::Law>(values);
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
