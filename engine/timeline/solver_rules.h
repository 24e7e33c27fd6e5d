#pragma once

#include <tuple>

namespace hazumi {

// The newest version of the solver, which new projects ask for.
inline constexpr int kSolverVersion = 2;

// What a version of the solver does. A file states its version and keeps its motion, bit for bit,
// until somebody raises it. Each rule is a mend that changed motions; the comment says what the
// versions before did.
struct SolverRules {
  explicit constexpr SolverRules(int version)
      : keeps_speed_of_what_touches(version >= 2),
        is_causal(version >= 2),
        releases_at_keyed_speed(version >= 2),
        stands_on_springs(version >= 2) {}

  // A figure that contacts place keeps its velocity where a region begins. Before: its placement
  // pinned what touched, which stopped the figure dead. [METHOD 12.9]
  bool keeps_speed_of_what_touches;
  // No frame depends on what comes after it. Before: steps, fits and refinements looked ahead to
  // the next end, whose place changed frames before it in their last bits. [METHOD 8.6]
  bool is_causal;
  // An object that is let go on the first frame takes its keyed velocity. Before: it was at rest.
  // [METHOD 5.9]
  bool releases_at_keyed_speed;
  // Springs of joints that carry weight count the inertia of what they carry, feed-forward knows
  // the ground, and springs are implicit while contacts are in time-stepping mode. Before: springs
  // counted what lies beyond their joint alone, and were explicit. [METHOD 2.6, 12.4]
  bool stands_on_springs;

  bool operator==(const SolverRules&) const = default;
};
inline auto MembersOf(const SolverRules& rules) {
  const auto& [keeps_speed_of_what_touches, is_causal, releases_at_keyed_speed, stands_on_springs] =
      rules;
  return std::tie(keeps_speed_of_what_touches, is_causal, releases_at_keyed_speed,
                  stands_on_springs);
}

}  // namespace hazumi
