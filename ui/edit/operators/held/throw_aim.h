#pragma once

// Internal: how fast a dynamics region has to let its joints go for a thrown object to come down on
// a spot. The equations are in throw_aim.cpp.

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "engine/bake/incremental_bake.h"
#include "engine/base/result.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi::edit {

// What is thrown, and by what.
struct ThrowCase {
  int object = 0;   // of the project's held objects
  int holder = -1;  // of the object's later holders, who throws it; -1: who has it at first
  int release = 0;  // the frame in which it is let go
  int region = 0;   // of the project's, which moves what holds it
  // Hinges of the region that carry the holder and whose start rates are free, and those rates now.
  std::vector<JointIndex> hinges;
  VecX rates;  // [rad/s], by index of `hinges`
  VecX ease;   // how readily each is changed: its squared distance from the object [m^2]
  std::vector<ProjectKey> keys;  // of the hinges on the region's first frame, without these rates
};

struct ThrowPath {
  Vec3 from = Vec3::Zero(), velocity = Vec3::Zero();  // as it is let go, world [m, m/s]
  double seconds = 0.0;                               // to the spot
};

struct AimedThrow {
  VecX rates;  // [rad/s], by index of ThrowCase::hinges
  ThrowPath path;
};

// How high above where it is let go the slowest throw onto a spot rises [m].
double HeightOfSlowestThrow(const Vec3& from, const Vec3& spot, double gravity);
// The velocity of a throw that rises so high, and its time. It must rise above the spot.
ThrowPath ThrowOver(const Vec3& from, const Vec3& spot, double height, double gravity);

class ThrowAim {
 public:
  // It gives up after `until`, and never finds another throw for it.
  ThrowAim(Project project, std::shared_ptr<const Figure> figure, ThrowCase of,
           std::chrono::steady_clock::time_point until);

  // The centre of the object comes to `spot`, rising so high above the hand [m] or, not given, as
  // the least change has it; higher where something of the scene is in the way. Searched for
  // from start rates with this number, 0: from those there are. Errors: kSchema, with what is out
  // of reach or in the way.
  Result<AimedThrow> At(const Vec3& spot, std::optional<double> height, int start);
  // The keys that let the region's joints go so fast, and the frame in which it is let go.
  static void Apply(const ThrowCase& of, const VecX& rates, const Figure& figure, Project* project);

 private:
  VecX MissOf(const ThrowPath& path, const Vec3& spot, const std::optional<double>& height) const;
  Result<AimedThrow> Solve(const Vec3& spot, const std::optional<double>& height, VecX rates);
  VecX Start(int number) const;
  Result<ThrowPath> Let(const VecX& rates);

  Project project_;
  std::shared_ptr<const Figure> figure_;
  ThrowCase case_;
  std::chrono::steady_clock::time_point until_;
  std::unique_ptr<IncrementalBake> bake_;
};

}  // namespace hazumi::edit
