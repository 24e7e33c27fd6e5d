#pragma once

#include <cmath>

namespace hazumi {

// A function is at most zero at `a` and positive at `b`.
struct Bracket {
  double a, fa, b, fb;
};

// Narrows a bracket to `width` by secants, with a bisection every third time so that it always
// shrinks, or until the function at `b` is at most `small`.
template <typename Function>
Bracket Narrow(Bracket x, double width, Function&& f, double small = 0.0) {
  for (int i = 0; i < 100 && x.b - x.a > width && x.fb > small; ++i) {
    double t =
        i % 3 == 2 || x.fa == x.fb ? 0.5 * (x.a + x.b) : (x.a * x.fb - x.b * x.fa) / (x.fb - x.fa);
    if (!(t > x.a && t < x.b)) t = 0.5 * (x.a + x.b);
    const double value = f(t);
    (value > 0.0 ? x.b : x.a) = t;
    (value > 0.0 ? x.fb : x.fa) = value;
  }
  return x;
}

// Place of a look into a step, in equal looks. Looks before the first one (0, -1, ...) crowd
// towards the start of the step.
inline double PlaceOfLook(int look) { return look > 0 ? look : std::pow(0.25, 1 - look); }

}  // namespace hazumi
