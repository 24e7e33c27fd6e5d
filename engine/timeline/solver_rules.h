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
        stands_on_springs(version >= 2),
        parts_what_is_tied(version >= 2),
        keeps_touching_links_apart(version >= 2),
        lifts_plates_at_all_angles(version >= 2),
        feels_what_is_deep(version >= 2),
        slides_straight_beyond_stop(version >= 2),
        rests_without_gravity(version >= 2),
        lands_before_contacts(version >= 2),
        sweeps_large_islands(version >= 2) {}

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
  // What a point or a weld ties does not collide. Before: a hand collided with what it gripped.
  // [METHOD 11]
  bool parts_what_is_tied;
  // Links that just touch when all angles are zero stay out of each other. Before: they went
  // through each other. [METHOD 12.7]
  bool keeps_touching_links_apart;
  // A plate's lift is not faded next to 0 and 90 degrees, where it is 0 anyway. [METHOD 9.1]
  bool lifts_plates_at_all_angles;
  // What begins more than 0.1 m deep inside a box is let out. Before: it fell through.
  // [METHOD 12.5]
  bool feels_what_is_deep;
  // A step that goes beyond the instant where sliding stops keeps the direction of friction there.
  // Before: friction across that direction was so stiff that the step made motion of rounding, and
  // the stop was found milliseconds late. [METHOD 12.2]
  bool slides_straight_beyond_stop;
  // In time-stepping mode forces may give what is at rest a speed of 0.1 mm/s. Before: without
  // gravity they could give it nothing, and what lay still was solved in steps of 1/64 ms.
  // [METHOD 12.4]
  bool rests_without_gravity;
  // What lands by a placement is found before contacts of a region close there. Before: both were
  // found equally deep, and rounding decided whether the figure landed. [METHOD 5.6]
  bool lands_before_contacts;
  // Contacts of large islands are solved by sweeps from body to body, in time-stepping mode alone.
  // Before: by matrices, whose time grows by the cube. [METHOD 12.10]
  bool sweeps_large_islands;

  bool operator==(const SolverRules&) const = default;
};
inline auto MembersOf(const SolverRules& rules) {
  const auto& [keeps_speed_of_what_touches, is_causal, releases_at_keyed_speed, stands_on_springs,
               parts_what_is_tied, keeps_touching_links_apart, lifts_plates_at_all_angles,
               feels_what_is_deep, slides_straight_beyond_stop, rests_without_gravity,
               lands_before_contacts, sweeps_large_islands] = rules;
  return std::tie(keeps_speed_of_what_touches, is_causal, releases_at_keyed_speed,
                  stands_on_springs, parts_what_is_tied, keeps_touching_links_apart,
                  lifts_plates_at_all_angles, feels_what_is_deep, slides_straight_beyond_stop,
                  rests_without_gravity, lands_before_contacts, sweeps_large_islands);
}

}  // namespace hazumi
