#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/bake/bake_context.h"
#include "engine/bake/walk/drive_curves.h"
#include "engine/bake/walk/feed_forward.h"
#include "engine/region/node_motion.h"

namespace hazumi {

// What drives the models of exact regions from outside, as polynomials of time.
class DrivenCurves {
 public:
  explicit DrivenCurves(BakeContext* context);

  // From here on these regions are active, and their drives are told of.
  void SetRegions(const std::vector<int>& regions);

  // Fits the curves of the coordinates that no region drives, from a frame on. Returns the frame,
  // `end` at the latest, up to which each curve is one polynomial. With holds, the curves of the
  // held joints are fitted up to the next frame at most; an error where a hold is out of reach. The
  // interval does not depend on `end` where the solver is causal (DrivenMotion::holds_until).
  Result<double> Take(double from, int end, bool with_holds);

  // By Coordinate.
  const DrivenMotion& motion() const { return motion_; }

 private:
  struct FromTo {
    double from;  // [frames]
    int end;
  };
  // One curve; up to `to` at the latest, or as far as it is one polynomial.
  void TakeCurve(CurveTrack* track, const FromTo& span, DrivenCurve* curve, double* to) const;
  void TakeDrives(const FromTo& span, double* to);
  void TakeLimp(const FromTo& span, double* to);
  // Of what is no polynomial: up to which frame it is fitted by one, and that one.
  double FitUntil(const CurveTrack::Piece& piece, double from) const;
  DrivenCurve Fitted(const CurveTrack::Piece& piece, double from, double to) const;
  std::optional<Error> FitHolds(double from, double to);
  // What springs add to their pull.
  FigureMotion KeyedAt(double seconds) const;
  void FitForward(double from, double to);

  BakeContext& context_;
  DriveCurves drives_;
  DrivenMotion motion_;
  std::unique_ptr<FeedForward> forward_;  // where a spring asks for it, and then:
  std::vector<DrivenCurve> limp_;         // by Coordinate, the keys of what regions move
  bool stands_by_contacts_ = false;       // contacts of the regions place the figure
};

}  // namespace hazumi
