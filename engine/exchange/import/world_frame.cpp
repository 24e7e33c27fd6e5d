#include "engine/exchange/import/world_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/text.h"
#include "engine/body/body_axes.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr double kShortest = 1.2, kTallest = 2.2;  // of what is taken for a person [m]
constexpr int kLooks = 16;                         // at frames of a clip
constexpr double kUsual = 1.7;                     // [m]
constexpr double kLying = 0.4;                     // this tall for its length it lies
constexpr double kSmallest = 0.2, kLargest = 5.0;  // of what needs no word [m]

struct Extent {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  void Take(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Vec3 size() const { return high - low; }
};

Extent ExtentOf(const Character& character, const Skeleton& skeleton,
                const std::vector<BonePose>& poses, std::optional<BodyPart> part = {}) {
  Extent extent;
  for (const KeptBone& kept : skeleton.bones) {
    if (part && kept.body.part != *part) continue;
    const BonePose& pose = poses[kept.bone];
    extent.Take(pose.p);
    const auto& end = character.bones[kept.bone].end_site;
    if (end) extent.Take(pose.At(*end));
  }
  return extent;
}

// Vertices where the skin is when the skeleton rests, but for the skin's own rest.
Extent SkinExtent(const Character& character, const Skeleton& skeleton) {
  Extent extent;
  for (const SkinMesh& mesh : character.meshes) {
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      const auto& weights = mesh.weights[v];
      const auto most = std::max_element(weights.begin(), weights.end()) - weights.begin();
      const SkinMesh::Bind& bind = mesh.binds[mesh.bind_indices[v][most]];
      const BonePose& pose = skeleton.rest[bind.bone];
      const Vec3 p = (bind.inverse_bind * mesh.positions[v].cast<double>().homogeneous()).head<3>();
      extent.Take(pose.At(p));
    }
  }
  return extent;
}

// From the lowest point of the feet to the highest of the head along `up`, when the figure stands
// straightest: at rest, or in the clip. Nothing if no bone is called head, or none foot.
std::optional<double> StandingHeight(const Character& character, const Skeleton& skeleton,
                                     const Clip* clip, int up) {
  double most = 0.0;
  const auto look = [&](const std::vector<BonePose>& poses) {
    const Extent head = ExtentOf(character, skeleton, poses, BodyPart::kHead);
    const Extent feet = ExtentOf(character, skeleton, poses, BodyPart::kFoot);
    most = std::max(most, head.high[up] - feet.low[up]);
  };
  look(skeleton.rest);
  for (int i = 0; clip && i < kLooks; ++i) {
    look(PosesAt(character, clip, i * (clip->num_frames - 1) / kLooks));
  }
  return most > 0.0 ? std::optional(most) : std::nullopt;
}

// Heads are above feet, whatever they do, nearly all of the time.
std::optional<Vec3> FromFeetToHead(const Character& character, const Skeleton& skeleton,
                                   const Clip* clip) {
  const auto middle = [&](BodyPart part, const std::vector<BonePose>& poses) {
    Vec3 sum = Vec3::Zero();
    int num = 0;
    for (const KeptBone& kept : skeleton.bones) {
      if (kept.body.part != part) continue;
      sum += poses[kept.bone].p;
      ++num;
    }
    return num == 0 ? std::optional<Vec3>() : Vec3(sum / num);
  };
  const int num_frames = clip ? clip->num_frames : 1;
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < kLooks; ++i) {
    const std::vector<BonePose> poses = PosesAt(character, clip, i * (num_frames - 1) / kLooks);
    const auto head = middle(BodyPart::kHead, poses), feet = middle(BodyPart::kFoot, poses);
    if (!head || !feet) return std::nullopt;
    sum += *head - *feet;
  }
  return sum;
}

UpAxis GuessUp(const Character& character, const Skeleton& skeleton, const Clip* clip) {
  Vec3 tall = ExtentOf(character, skeleton, skeleton.rest).size();
  if (const auto upright = FromFeetToHead(character, skeleton, clip)) tall = *upright;
  return std::abs(tall.z()) > std::abs(tall.y()) ? UpAxis::kZ : UpAxis::kY;
}

// In the file's unit.
double HeightOf(const Character& character, const Skeleton& skeleton, const Clip* clip, int up) {
  const bool has_skin = !character.meshes.empty();
  if (!has_skin) {
    if (const auto height = StandingHeight(character, skeleton, clip, up)) return *height;
  }
  const Extent extent =
      has_skin ? SkinExtent(character, skeleton) : ExtentOf(character, skeleton, skeleton.rest);
  // A skeleton may rest lying, or with all bones in a row.
  const double longest = extent.size().maxCoeff();
  const double tall = extent.size()[up];
  return std::max(tall > kLying * longest ? tall : longest, 1e-9);
}

struct Unit {
  double metres;
  const char* name;
};
constexpr Unit kUnits[] = {{1.0, "metres"},
                           {0.01, "centimetres"},
                           {0.0254, "inches"},
                           {0.056444, "2.54 cm / 0.45, the unit of the CMU mocap library"},
                           {0.001, "millimetres"}};

// The unit that makes a person of something so tall; the nearest to 1.7 m of those that do.
Unit GuessUnit(double tall) {
  Unit best = {kUsual / tall, "such that it is 1.7 m tall"};
  double off = std::numeric_limits<double>::infinity();
  for (const Unit& unit : kUnits) {
    const double height = tall * unit.metres;
    const double now = std::abs(std::log(height / kUsual));
    if (height < kShortest || height > kTallest || now >= off) continue;
    off = now;
    best = unit;
  }
  return best;
}

void SayUnit(double metres, const std::string& why, double height, ImportReport* report) {
  const std::string said =
      "1 unit is " + FormatShort(metres) + " m (" + why + "): " + FormatShort(height) + " m tall";
  report->facts.push_back(said);
  if (height >= kSmallest && height <= kLargest) return;
  report->warnings.push_back({"unit", "the figure is " + FormatShort(height) +
                                          " m tall; if that is wrong, give its height"});
}

}  // namespace

Mat3 AxesOf(UpAxis up) {
  Mat3 C = Mat3::Identity();
  if (up == UpAxis::kY) C << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return C;
}

WorldFrame WorldFrameOf(const Character& character, const Skeleton& skeleton, const Clip* clip,
                        const ImportOptions& options, ImportReport* report) {
  WorldFrame world;
  const char* who = options.up ? "as asked for" : character.up ? "as the file says" : "guessed";
  world.up = options.up ? *options.up : character.up.value_or(GuessUp(character, skeleton, clip));
  world.C = AxesOf(world.up);
  report->facts.push_back(std::string(world.up == UpAxis::kY ? "y" : "z") + " is up (" + who + ")");
  const double tall = HeightOf(character, skeleton, clip, world.up == UpAxis::kY ? 1 : 2);
  std::string why = "as asked for";
  if (options.height_m) {
    world.metres = *options.height_m / tall;
  } else if (options.metres_per_unit) {
    world.metres = *options.metres_per_unit;
  } else if (character.metres_per_unit) {
    world.metres = *character.metres_per_unit;
    why = "as the file says";
  } else {
    const Unit unit = GuessUnit(tall);
    world.metres = unit.metres;
    why = std::string("guessed: ") + unit.name;
    report->unit_is_guessed = true;
  }
  world.height = tall * world.metres;
  SayUnit(world.metres, why, world.height, report);
  report->up = world.up;
  report->metres_per_unit = world.metres;
  report->height_m = world.height;
  return world;
}

std::vector<RestBone> RestBonesOf(const Skeleton& skeleton, const WorldFrame& world) {
  std::vector<RestBone> bones;
  for (const KeptBone& kept : skeleton.bones) {
    const Vec3 place = world.Placed(skeleton.rest[kept.bone].p);
    bones.push_back({kept.place, kept.parent, {Mat3::Identity(), place}, {}});
  }
  return bones;
}

// Turns the figure so that it faces x: exactly, or by right angles if it faces nearly along an
// axis.
void FaceForward(const Skeleton& skeleton, ImportReport* report, WorldFrame* world) {
  constexpr double kRight = 90.0 * kDegree, kNear = 10.0 * kDegree;
  const std::optional<double> facing = FacingOf(RestBonesOf(skeleton, *world));
  if (!facing) return;
  const double steps = std::round(*facing / kRight);
  const bool is_along_axis = std::abs(*facing - steps * kRight) < kNear;
  if (is_along_axis && steps == 0.0) return;
  const double turn = -(is_along_axis ? steps * kRight : *facing);
  world->F = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
  if (is_along_axis) world->F = world->F.array().round().matrix().eval();
  report->facts.push_back("turned by " + FormatShort(std::round(turn / kDegree)) +
                          " degrees about the vertical, so that it faces forward");
}

}  // namespace hazumi
