#pragma once

// Internal: how fast a dynamics region has to let its joints go for a thrown object to come down on
// a spot. The equations are in throw_aim.cpp.

#include <optional>
#include <string>

#include "engine/makers/throws/throw_case.h"
#include "engine/makers/throws/throw_path.h"
#include "engine/makers/trial_bakes.h"

namespace hazumi::makers {

struct AimedThrow {
  int release = 0;       // the frame in which it is let go
  VecX rates;            // of the region's start [rad/s], by index of ThrowCase::hinges
  double farther = 0.0;  // has the fastest hinge swung as the region starts [rad]
  ThrowPath path;
  // Who hits a limit until then, and how often all do.
  std::string at_limit;
  long limit_hits = 0;
  // Its speed, by how much the rates change that of the start, and half a metre per second for each
  // hit of a limit [m/s].
  double cost = 0.0;

  // The unknowns: the rates, and last the angle.
  VecX swing() const {
    VecX all(rates.size() + 1);
    all << rates, farther;
    return all;
  }
};

// The hinges on the region's first frame, by index of ThrowCase::hinges.
struct ThrowStart {
  VecX q;                    // [rad]
  VecX before, after;        // rates, as the keys arrive and as the region starts [rad/s]
  Eigen::Index fastest = 0;  // as it starts
};

class ThrowAim {
 public:
  // Limits the work of its bakes (Work), not the time, so that every machine finds the same throw.
  // Once a throw is found, a part of it remains to search for a better one.
  ThrowAim(const Animation& animation, ThrowCase of, double most_work);

  // Finds a throw whose object centre reaches `spot`. `height`: rise above the hand [m]; default:
  // the height with the least change; higher if an object of the scene is in the way. The object
  // may be released in another frame of the region. Returns the throw of least cost. Errors:
  // kSchema, with the object in the way; kSemantics, with the distance missed when released in the
  // given frame; kInterrupted if the search takes too much work.
  Result<AimedThrow> At(const Vec3& spot, std::optional<double> height);

  // Start of the region, once At has found a throw.
  const ThrowStart& start() const { return *start_; }
  double work() const { return trials_.work(); }

 private:
  // `swing`: AimedThrow::swing.
  static double Farther(const VecX& swing) { return swing[swing.size() - 1]; }

  Result<Done> TakeStart();
  void Set(const VecX& swing);
  Result<ThrowPath> Let(const VecX& swing, int release);
  ThrowPath PathFrom(int release) const;  // as it is baked
  Result<std::vector<int>> Releases(const Vec3& spot, const VecX& swing, bool given_first);
  VecX MissOf(const ThrowPath& path, const Vec3& spot, const std::optional<double>& height) const;
  Result<AimedThrow> Solve(const Vec3& spot, const std::optional<double>& height, int release,
                           VecX swing);
  Result<AimedThrow> Over(const Vec3& spot, int release, const VecX& swing);
  Result<AimedThrow> AsHigh(const Vec3& spot, double height, int release, const VecX& swing);
  Error WithHeight(Error error, const Vec3& spot);
  void Judge(AimedThrow* aimed) const;
  bool SwingsBack(const VecX& rates) const;
  VecX Swing(int number) const;

  Animation animation_;
  ThrowCase case_;
  TrialBakes trials_;
  std::optional<ThrowStart> start_;
  VecX ease_;  // how readily each unknown is changed: its hinge's squared distance from the object
               // [m^2]; of the angle a share of that
  double radius_;  // of what is thrown [m]
};

// The frame in which it is let go, and the keys that let the region's joints go so fast. Keys
// before them keep their curves, but for the last few degrees of one that arrives about as fast.
void PutThrow(const ThrowCase& of, const AimedThrow& aimed, const ThrowStart& start,
              const Animation& animation, Project* project);

}  // namespace hazumi::makers
