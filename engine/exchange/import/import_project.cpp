#include "engine/exchange/import/import_project.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/text.h"
#include "engine/exchange/character/character_check.h"
#include "engine/exchange/import/detached_ends.h"
#include "engine/exchange/import/figure_joints.h"
#include "engine/exchange/import/figure_parts.h"
#include "engine/exchange/import/import_check.h"
#include "engine/exchange/import/import_names.h"
#include "engine/exchange/import/import_plan.h"
#include "engine/exchange/import/import_source.h"
#include "engine/exchange/import/joint_plan.h"
#include "engine/exchange/import/key_reduction.h"
#include "engine/exchange/import/one_root.h"
#include "engine/exchange/import/told_roles.h"
#include "engine/exchange/units.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr double kMassOfHeight = 70.0 / (1.7 * 1.7);  // [kg/m^2]
constexpr double kMetresPerDegree = 0.002;            // tolerance of the root's place
constexpr double kDwarf = 1e-3;                       // [m]
constexpr double kPoint = 1e-8;                       // of a file's height, in its unit
constexpr double kLeap = 1.0,
                 kSudden = 5.0;       // of the root from frame to frame [m], and of its other steps
constexpr double kFar = 100.0;        // from the origin [m]
constexpr double kWorthAWord = 1e-4;  // [m]
ProjectKey KeyOf(double frame, double value, std::optional<double> rate = {}) {
  ProjectKey key;
  key.frame = frame;
  key.value = value;
  key.rate = rate;
  return key;
}

Result<const Clip*> ClipOf(const Character& character, const std::string& name) {
  if (name.empty()) return character.clips.empty() ? nullptr : &character.clips.front();
  for (const Clip& clip : character.clips)
    if (clip.name == name) return &clip;
  return Error{
      ErrorCode::kSemantics, "", "clip",
      "there is no " + Quoted(name) + "; there " +
          (character.clips.empty() ? std::string("are none") : "are " + NamesOf(character.clips))};
}

// Frames per second as a ratio: a whole number, or one of 1/1.001 of it.
ProjectRate RateOf(double fps) {
  fps = std::clamp(fps, 1e-3, 1e6);  // a project has less, and says so
  const double whole = std::round(fps);
  if (whole >= 1.0 && std::abs(fps - whole) <= 1e-4 * fps) return {static_cast<int>(whole), 1, {}};
  const double more = std::round(1.001 * fps);
  if (std::abs(1.001 * fps - more) <= 1e-4 * fps) {
    return {static_cast<int>(1000.0 * more), 1001, {}};
  }
  return {std::max(1, static_cast<int>(std::round(1000.0 * fps))), 1000, {}};
}

// With ends on their limbs and with one root; none: it is so.
std::optional<Character> Hung(const Character& character) {
  const std::optional<Character> limbs = WithEndsOnLimbs(WantedBones(character), character);
  const Character& whole = limbs ? *limbs : character;
  std::optional<Character> rooted = WithOneRoot(WantedBones(whole), whole);
  return rooted ? rooted : limbs;
}

class Importer {
 public:
  Importer(const Character& character, const ImportOptions& options)
      : character_(character), options_(options) {}

  Result<Imported> Import() {
    if (Result<Done> planned = Plan(); !planned.ok()) return planned.error();
    SayError();
    if (auto error = SetFigure()) return *error;
    if (options_.skin && !skin_.meshes.empty()) {
      project_.skin.skin = std::make_shared<const Skin>(std::move(skin_));
    }
    project_.size_is_guessed = report_.unit_is_guessed;
    project_.source = SourceOf(character_, skeleton_, clip_, world_, options_);
    if (auto error = WhyNoProject(project_)) return *error;
    return Imported{std::move(project_), std::move(report_)};
  }

  Result<ImportPlan> OnlyPlan() {
    if (Result<Done> planned = Plan(); !planned.ok()) return planned.error();
    ImportPlan plan = {character_, std::move(skeleton_), world_, std::move(plan_), std::nullopt};
    if (clip_) plan.clip = static_cast<size_t>(clip_ - character_.clips.data());
    return plan;
  }

 private:
  // Makes the keys' angles, and all that has to be known for them.
  Result<Done> Plan() {
    Result<Skeleton> skeleton = SkeletonOf(character_);
    if (!skeleton.ok()) return skeleton.error();
    skeleton_ = std::move(skeleton).value();
    const Result<const Clip*> clip = ClipOf(character_, options_.clip);
    if (!clip.ok()) return clip.error();
    clip_ = clip.value();
    if (clip_ && clip_->num_frames < 1) clip_ = nullptr;
    if (auto error = WhyTooManyKeys()) return *error;
    SayClip();
    report_.warnings.insert(report_.warnings.end(), character_.warnings.begin(),
                            character_.warnings.end());
    SayBones();
    world_ = WorldFrameOf(character_, skeleton_, clip_, options_, &report_);
    if (TellRolesByShape(world_, &skeleton_)) {
      report_.warnings.push_back(
          {RootName(), "names of bones say nothing: which is what is told by their shape"});
    }
    if (auto error = GiveRoles(options_.roles, character_, &skeleton_)) return *error;
    if (options_.faces_forward) FaceForward(skeleton_, &report_, &world_);
    ReportBones();
    SayMissingParts(skeleton_, &report_);
    if (auto error = WhyTooTall(world_)) return *error;
    if (auto error = CheckSize()) return *error;
    plan_ = PlanFigure(character_, skeleton_, clip_, world_, options_, &report_);
    skin_ = SkinFor(character_, skeleton_, plan_, world_);
    SayPlace();
    SayJump();
    SetTime();
    SetKeys();
    return Done();
  }

  // Estimated number of hinges that have more than one key.
  static int NumMoving(const BoneTrack& track) {
    int moving = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const auto moves = [&](const Eigen::Quaterniond& q) {
        return q.coeffs()[axis] != track.rotations[0].coeffs()[axis];
      };
      if (std::any_of(track.rotations.begin(), track.rotations.end(), moves)) ++moving;
    }
    return moving;
  }

  // Refuses a clip whose keys, one a frame, are far more than a project holds.
  std::optional<Error> WhyTooManyKeys() const {
    if (!clip_ || options_.reduce_deg) return std::nullopt;
    long curves = 3;  // x, y and z of the root
    for (const KeptBone& kept : skeleton_.bones) {
      const BoneTrack& track = clip_->tracks[static_cast<size_t>(kept.bone)];
      if (!track.rotations.empty()) curves += NumMoving(track);
    }
    return hazumi::WhyTooManyKeys(static_cast<double>(curves), clip_->num_frames,
                                  clip_->num_frames * clip_->seconds_per_frame);
  }

  void SayClip() {
    const std::vector<Clip>& clips = character_.clips;
    if (!options_.clip.empty() || clips.size() < 2) return;
    report_.warnings.push_back({"clip", Quoted(clips.front().name) + " is taken, the first of " +
                                            std::to_string(clips.size()) + ": " + NamesOf(clips) +
                                            "; to take another, give its name (--clip NAME)"});
  }

  void SayBones() {
    report_.num_joints = static_cast<int>(skeleton_.bones.size()) - 1;
    report_.facts.push_back(std::to_string(report_.num_joints) + " joints below \"" + RootName() +
                            "\"");
    if (skeleton_.left_out.empty()) return;
    std::string names;
    for (const std::string& name : skeleton_.left_out) names += (names.empty() ? "" : ", ") + name;
    report_.warnings.push_back(
        {RootName(), "bones beside it that carry no skin are left out: " + names});
  }

  void ReportBones() {
    const std::vector<RestBone> rest = RestBonesOf(skeleton_, world_);
    for (size_t k = 0; k < rest.size(); ++k) {
      const KeptBone& bone = skeleton_.bones[k];
      report_.bones.push_back({character_.bones[static_cast<size_t>(bone.bone)].name, bone.parent,
                               bone.place, rest[k].X_R.p});
    }
  }

  // A character that nobody could see or move is none.
  std::optional<Error> CheckSize() const {
    const auto refuse = [](const std::string& message) {
      return Error{ErrorCode::kSemantics, "", "", message};
    };
    if (skeleton_.bones.size() == 1 && character_.meshes.empty()) {
      return refuse("its skeleton is one bone, \"" + RootName() +
                    "\", without joints or a mesh; export the whole skeleton, or bake its "
                    "animation to the bones");
    }
    if (!(world_.height / world_.metres > kPoint)) {
      return refuse("all its bones lie in one place; export the skeleton in its rest pose");
    }
    if (world_.height >= kDwarf) return std::nullopt;
    return refuse("the figure would be " + FormatShort(world_.height) +
                  " m tall; say how tall it is (--height), or how long its unit is (--unit)");
  }

  // Pictures are of single precision, and cameras look for the figure about the origin.
  void SayPlace() {
    const double away = plan_.root_position.front().norm();
    if (away <= kFar) return;
    report_.warnings.push_back({RootName(), "is " + FormatShort(away) +
                                                " m from the origin when the clip begins; if that "
                                                "is wrong, give the unit or the height"});
  }

  // A root that goes from one frame to the next much farther than before and after it.
  void SayJump() {
    const std::vector<Vec3>& at = plan_.root_position;
    const auto step = [&](size_t f) {
      return f > 0 && f < at.size() ? (at[f] - at[f - 1]).norm() : 0.0;
    };
    for (size_t f = 1; f < at.size(); ++f) {
      const double length = step(f);
      if (length <= kLeap || length <= kSudden * std::max(step(f - 1), step(f + 1))) continue;
      report_.warnings.push_back(
          {RootName(), "jumps by " + FormatShort(length) + " m from frame " +
                           std::to_string(f - 1) +
                           " to the next; a region over it would fling what hangs on it: begin or "
                           "end regions there, or cut the clip"});
      return;
    }
  }

  const std::string& RootName() const { return character_.bones[skeleton_.bones[0].bone].name; }

  void SetTime() {
    project_.name = character_.name;
    const double fps = clip_ ? 1.0 / clip_->seconds_per_frame : 30.0;
    project_.fps = RateOf(fps);
    num_frames_ = clip_ ? clip_->num_frames : 1;
    project_.frames.last = clip_ ? std::max(num_frames_ - 1, 1) : 60;
    if (!clip_) return report_.facts.push_back("no clip is in it: the figure is at rest");
    report_.facts.push_back("clip \"" + clip_->name + "\", " + std::to_string(num_frames_) +
                            " frames at " + FormatNumber(std::round(1e3 * fps) / 1e3) +
                            " a second");
  }

  // One curve from its values by frame, in the file's units; these become what the keys say.
  ProjectCurve CurveOf(std::vector<double>* values, double tolerance) {
    ProjectCurve curve;
    const bool is_still = std::all_of(values->begin(), values->end(),
                                      [&](double value) { return value == values->front(); });
    if (is_still) {
      curve.keys.push_back(KeyOf(0.0, values->front()));
    } else if (options_.reduce_deg) {
      const std::vector<ReducedKey> keys = ReduceKeys(*values, tolerance);
      const double per_second = static_cast<double>(project_.fps.num) / project_.fps.den;
      for (const ReducedKey& key : keys) {
        curve.keys.push_back(KeyOf(key.frame, key.value, key.rate * per_second));
      }
      *values = ValuesOf(keys);
    } else {
      for (int f = 0; f < num_frames_; ++f) {
        curve.keys.push_back(KeyOf(f, (*values)[f]));
      }
    }
    report_.num_keys += static_cast<int>(curve.keys.size());
    return curve;
  }

  // Curve of one component, of places [m] or angles [rad]; what its keys say goes back there.
  ProjectCurve CurveOf(std::vector<Vec3>* vectors, int component, bool is_angle, double tolerance) {
    std::vector<double> values;
    values.reserve(vectors->size());
    for (const Vec3& vector : *vectors) {
      values.push_back(is_angle ? ShortestDegrees(vector[component]) : vector[component]);
    }
    ProjectCurve curve = CurveOf(&values, tolerance);
    for (size_t f = 0; f < values.size(); ++f) {
      (*vectors)[f][component] = is_angle ? values[f] * kDegree : values[f];
    }
    return curve;
  }

  void SetKeys() {
    const double tolerance = options_.reduce_deg.value_or(0.0);
    for (int i = 0; i < 3; ++i) {
      project_.root.curves[kRootX + i] =
          CurveOf(&plan_.root_position, i, false, kMetresPerDegree * tolerance);
      project_.root.curves[kRootAngleZ + i] = CurveOf(&plan_.root_angles, i, true, tolerance);
    }
    for (size_t k = 1; k < plan_.joints.size(); ++k) {
      PlannedJoint& joint = plan_.joints[k];
      for (int h = 0; h < joint.num_hinges; ++h) {
        if (!clip_) continue;
        project_.joints.push_back({joint.HingeName(h), CurveOf(&joint.angles, h, true, tolerance)});
      }
    }
    if (!clip_) return;
    report_.facts.push_back(std::to_string(report_.num_keys) + " keys" +
                            (options_.reduce_deg
                                 ? ", within " + FormatShort(tolerance) +
                                       (tolerance == 1.0 ? " degree" : " degrees") + " of the clip"
                                 : std::string(", one a frame")));
  }

  void SayError() {
    std::string where;
    for (int f = 0; f < num_frames_; ++f) {
      const std::vector<Vec3> here = PositionsOf(plan_, f);
      const std::vector<Vec3> there = FilePositions(character_, skeleton_, clip_, world_, f);
      for (size_t k = 0; k < here.size(); ++k) {
        const double off = (here[k] - there[k]).norm();
        if (off <= report_.position_error_m) continue;
        report_.position_error_m = off;
        where = "\"" + plan_.joints[k].name + "\" at frame " + std::to_string(f);
      }
    }
    if (report_.position_error_m < kWorthAWord) return;
    report_.facts.push_back("joints are up to " + FormatShort(100.0 * report_.position_error_m) +
                            " cm from where the file has them: " + where);
  }

  // By kept bone; `how` follows the mass.
  std::vector<std::vector<LinkSpec>> WeighedLinks(std::string* how) const {
    if (auto known = KnownLinks(character_, skeleton_, world_, options_.mass_kg)) {
      *how = "shaped and weighed as Hazumi wrote it";
      return std::move(*known);
    }
    const double mass = options_.mass_kg.value_or(kMassOfHeight * world_.height * world_.height);
    auto links = LinksOf(character_, skeleton_, plan_, skin_, world_);
    *how = Weigh(skeleton_, plan_, skin_, mass, &links);
    return links;
  }

  std::optional<Error> SetFigure() {
    std::string how;
    const auto links = WeighedLinks(&how);
    FigureSpec spec;
    spec.name = character_.name;
    spec.root_name = plan_.joints[0].name;
    spec.root_links = links[0];
    spec.joints = JointsOf(skeleton_, plan_, links, world_, options_.limits, &report_);
    const Result<Figure> figure = BuildFigure(spec);
    if (!figure.ok()) return figure.error();
    project_.figure.embedded_json = FigureText(spec);
    project_.figure.spec = std::move(spec);
    report_.facts.push_back(FormatShort(figure.value().total_mass()) + " kg, " + how);
    SetGround(GroundUnder(skeleton_, plan_, skin_, links));
    return std::nullopt;
  }

  void SetGround(double height) {
    ProjectPlane plane;
    plane.offset_m = height;
    ProjectSceneObject& ground = project_.scene.objects.emplace_back();
    ground.name = "ground";
    ground.shape = plane;
    if (height == 0.0) return;
    report_.facts.push_back("the ground is put at z = " + FormatShort(height) +
                            " m, under the figure's feet");
  }

  const Character& character_;
  const ImportOptions& options_;
  Skeleton skeleton_;
  const Clip* clip_ = nullptr;
  WorldFrame world_;
  FigurePlan plan_;
  Skin skin_;
  int num_frames_ = 1;
  Project project_;
  ImportReport report_;
};

}  // namespace

Result<Imported> ImportProject(const Character& character, const ImportOptions& options) {
  const std::optional<Character> hung = Hung(character);
  return Importer(hung ? *hung : character, options).Import();
}

Result<ImportPlan> PlanImport(const Character& character, const ImportOptions& options) {
  const std::optional<Character> hung = Hung(character);
  return Importer(hung ? *hung : character, options).OnlyPlan();
}

}  // namespace hazumi
