#pragma once

namespace hazumi::bench {

// Each prints one table of comma-separated values to the standard output. Every entry is the least
// of `rounds` alternating rounds over everything that the table compares.

// Calls of the dynamics: subject, model, call, microseconds, ratio to MuJoCo.
void PrintCalls(int rounds);
// Swings of the arm: subject, case, setting, microseconds, error of the end in rad, microseconds
// to make the model, which the former leave out.
void PrintWorkPrecision(int rounds);
// Forward dynamics of growing figures: method, shape, joints, microseconds.
void PrintScaling(int rounds);
void PrintRegionScaling(int rounds);  // its last rows: one group of a region, in two ways
// Coarsest settings that survive: slice, method, its two coordinates, the setting and the
// evaluations of the equations of motion in a second; both empty if none did.
void PrintStability(int rounds);
// Swings on springs: as PrintWorkPrecision.
void PrintSprings(int rounds);
// Coarsest settings that survive a second on springs: damping ratio, method, frequency of the
// springs, the step of methods with equal steps or the tolerance of the others, evaluations.
void PrintSpringStability(int rounds);
// Falls of a human: friction factor, method, setting, microseconds for 2 s, greatest depth in the
// floor, energy not accounted for and lost, when time-stepping mode was entered first, error of
// angles at some instants. The rows of references: where the root is at the last instant, and how
// well they are known.
void PrintContact(int rounds);
// All evaluations of an example's bake: case, level of modelling, microseconds.
void PrintModelling(int rounds);

}  // namespace hazumi::bench
