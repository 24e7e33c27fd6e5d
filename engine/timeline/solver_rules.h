#pragma once

#include <tuple>

namespace hazumi {

// Newest version of the solver, which new projects use.
inline constexpr int kSolverVersion = 2;

// Rules of a solver version. A file states its version and keeps its motion, bit for bit, until the
// user raises it. Each rule is a correction that changed motions; its comment states the behaviour
// of previous versions.
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
        locates_landings_exactly(version >= 2),
        pins_what_would_sink(version >= 2),
        sweeps_large_islands(version >= 2),
        keeps_balls_apart(version >= 2),
        opens_what_begins_to_pull(version >= 2),
        looks_about_poles(version >= 2),
        stops_by_impulse(version >= 2),
        no_friction_at_pins(version >= 2),
        tells_motion_from_rounding(version >= 2),
        sticks_by_hinge(version >= 2),
        limits_follow_hinges(version >= 2),
        hits_at_one_distance(version >= 2),
        controls_equal_steps(version >= 2),
        finds_brief_losses(version >= 2),
        lists_strength_kinks(version >= 2) {}

  // Velocity of a figure that contacts place is kept where a region begins. Before: its placement
  // pinned the contacts, which stopped the figure. [METHOD 12.9]
  bool keeps_speed_of_what_touches;
  // Frames do not depend on later frames. Before: steps, fits and refinements depended on the next
  // end, whose place changed the last bits of earlier frames. [METHOD 8.6]
  bool is_causal;
  // Objects that are released on the first frame take their keyed velocity. Before: they were at
  // rest. [METHOD 5.9]
  bool releases_at_keyed_speed;
  // Springs of joints that carry weight use the inertia of the carried bodies, feed-forward
  // includes the ground, and springs are implicit in time-stepping mode. Before: springs used the
  // inertia beyond their joint and were explicit. [METHOD 2.6, 12.4]
  bool stands_on_springs;
  // Bodies that a point or a weld ties do not collide. Before: a hand collided with the object that
  // it gripped. [METHOD 11]
  bool parts_what_is_tied;
  // Links that just touch when all angles are zero collide. Before: they passed through each other.
  // [METHOD 12.7]
  bool keeps_touching_links_apart;
  // Lift of a plate is not faded next to 0 and 90 degrees, where the lift is 0. [METHOD 9.1]
  bool lifts_plates_at_all_angles;
  // Bodies that begin more than 0.1 m deep inside a box are depenetrated. Before: they fell
  // through. [METHOD 12.5]
  bool feels_what_is_deep;
  // Direction of friction is kept for the rest of a step in which sliding stops. Before: friction
  // across that direction was so stiff that the step amplified rounding, and the stop was located
  // milliseconds late. [METHOD 12.2]
  bool slides_straight_beyond_stop;
  // Forces in time-stepping mode may give a body at rest a speed of 0.1 mm/s. Before: without
  // gravity they could give none, and resting bodies were solved in steps of 1/64 ms. [METHOD 12.4]
  bool rests_without_gravity;
  // Landings of a placement are detected at a depth of 1e-13 m, before contacts of a region become
  // active. Before: both had a threshold of 1e-9 m, rounding decided whether the figure landed, and
  // landings at little speed were milliseconds late. [METHOD 5.6]
  bool locates_landings_exactly;
  // A pin holds while the touching point would sink if the figure took off. Before: the figure took
  // off and landed several times in the same instant, then the pin held for 1/30 s. [METHOD 5.5]
  bool pins_what_would_sink;
  // Contacts of large islands are solved by sweeps from body to body, in time-stepping mode alone.
  // Before: by matrices, in cubic time. [METHOD 12.10]
  bool sweeps_large_islands;
  // Balls that fly collide with each other where a region touches the scene. Before: they passed
  // through each other. [METHOD 12.8]
  bool keeps_balls_apart;
  // A contact whose push is 0 after an event opens when it begins to pull. Before: it could pull
  // until the step ended. [METHOD 12.2]
  bool opens_what_begins_to_pull;
  // Releases are located about the poles of a ball joint with a hinge at its limit. Before: a pull
  // shorter than 1/16 of a step was missed. [METHOD 3.4]
  bool looks_about_poles;
  // A hinge that an impact pushes off its limit, but not for long, is stopped by an impulse that
  // the others feel; one that leaves its limit slowly is stopped before an impact, which may push
  // it off. Before: the first lost its speed, and the others kept theirs, or it kept on being
  // pushed off; the second was held, even by a pull. [METHOD 3.5]
  bool stops_by_impulse;
  // A contact whose point a pin holds, so that nothing changes its velocity along the normal, does
  // not push and has no friction. Before: a push of any size, with its friction. [METHOD 12.3]
  bool no_friction_at_pins;
  // Rounding is no motion: neither the force of a pin in a step of a few nanoseconds, for which a
  // figure took off before, nor the rate of a hinge that constraints hold, by which limits went
  // round in circles; nor is the pull of a limit that nothing presses, which let go again and
  // again, or the way that a hinge is outside as it leaves its limit, which it met again and
  // again, or the velocity of a point that slides along the ground, which an impact stopped.
  // [METHOD 5.5, 3.3, 3.4, 12.3]
  bool tells_motion_from_rounding;
  // The limits of a hinge become sticky when that hinge comes to them again and again. Before: the
  // limits of all hinges did when there were many events, which stopped hinges that were only
  // passing. [METHOD 3.5]
  bool sticks_by_hinge;
  // The limit of a hinge that is outside follows it until the hinge turns. Before: until the end of
  // the step before, so that the hinge swung out again a little. [METHOD 3.6]
  bool limits_follow_hinges;
  // A hinge hits its limit 5e-11 rad beyond it. Before: up to 1e-10 rad, where a step or a look of
  // the search happened to end, which a slow hinge reaches much later. [METHOD 3.4]
  bool hits_at_one_distance;
  // A step of the control solution that the solution takes as well errs by five times its error
  // more. Before: both erred alike, which no estimate shows. [METHOD 8.2]
  bool controls_equal_steps;
  // A pinned figure takes off where it comes away from the ground, or rises while its pin pulls,
  // however briefly. Before: if that lasted until one of a few looks into the step. [METHOD 5.5]
  bool finds_brief_losses;
  // Steps end where the strength of muscles that give all they can has a kink, as at rest. Before:
  // they went over it, with an error that was in no estimate. [METHOD 8.1]
  bool lists_strength_kinks;

  bool operator==(const SolverRules&) const = default;
};
inline auto MembersOf(const SolverRules& rules) {
  const auto& [keeps_speed_of_what_touches, is_causal, releases_at_keyed_speed, stands_on_springs,
               parts_what_is_tied, keeps_touching_links_apart, lifts_plates_at_all_angles,
               feels_what_is_deep, slides_straight_beyond_stop, rests_without_gravity,
               locates_landings_exactly, pins_what_would_sink, sweeps_large_islands,
               keeps_balls_apart, opens_what_begins_to_pull, looks_about_poles, stops_by_impulse,
               no_friction_at_pins, tells_motion_from_rounding, sticks_by_hinge,
               limits_follow_hinges, hits_at_one_distance, controls_equal_steps, finds_brief_losses,
               lists_strength_kinks] = rules;
  return std::tie(
      keeps_speed_of_what_touches, is_causal, releases_at_keyed_speed, stands_on_springs,
      parts_what_is_tied, keeps_touching_links_apart, lifts_plates_at_all_angles,
      feels_what_is_deep, slides_straight_beyond_stop, rests_without_gravity,
      locates_landings_exactly, pins_what_would_sink, sweeps_large_islands, keeps_balls_apart,
      opens_what_begins_to_pull, looks_about_poles, stops_by_impulse, no_friction_at_pins,
      tells_motion_from_rounding, sticks_by_hinge, limits_follow_hinges, hits_at_one_distance,
      controls_equal_steps, finds_brief_losses, lists_strength_kinks);
}

}  // namespace hazumi
