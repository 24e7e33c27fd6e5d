#include "ui/panels/problems/problems.h"

#include <algorithm>
#include <charconv>

#include "engine/base/text.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/placement/jumps.h"
#include "ui/panels/problems/contact_jerk.h"
#include "ui/panels/problems/falls_through.h"
#include "ui/panels/problems/region_problems.h"
#include "ui/panels/problems/support_problem.h"
#include "ui/panels/problems/taken_object.h"
#include "ui/panels/text/filled.h"
#include "ui/panels/timeline/flight_text.h"

namespace hazumi::ui {

namespace {

// The number in a place such as "regions[1].joints[0]", if the place is of this list.
std::optional<size_t> IndexIn(const std::string& list, const std::string& place) {
  if (!place.starts_with(list + "[")) return std::nullopt;
  size_t index = 0;
  const char* first = place.data() + list.size() + 1;
  const auto read = std::from_chars(first, place.data() + place.size(), index);
  return read.ec == std::errc() ? std::optional(index) : std::nullopt;
}

constexpr double kFarSlide = 0.05;  // of a foot; captures have shorter ones in every step [m]

bool SlidesFar(const FlightAnalysis& analysis) {
  return std::any_of(analysis.skates.begin(), analysis.skates.end(), [](const FootSkate& skate) {
    return std::any_of(skate.slides.begin(), skate.slides.end(),
                       [](const FootSlide& slide) { return slide.distance > kFarSlide; });
  });
}

bool IsOf(const MissingSupport& missing, const Figure& figure) {
  return missing.joint.value() < figure.num_joints();
}

// Returns whether the bake warns of a ball that is released inside an object.
bool IsWarnedOf(const FallThrough& fall, const Motion& motion) {
  return std::any_of(motion.warnings.begin(), motion.warnings.end(), [&](const Warning& warning) {
    return IndexIn("held_objects", warning.place) == static_cast<size_t>(fall.object) &&
           warning.frame == fall.frame;
  });
}

class ProblemList {
 public:
  explicit ProblemList(Editor* editor) : editor_(*editor), project_(editor->session().project()) {}

  std::vector<Problem> Find() {
    edit::Session& session = editor_.session();
    if (const std::optional<Error> error = session.KnownError()) {
      AddPlaced({error->place, error->message}, /*is_error=*/true);
      return std::move(problems_);
    }
    const Result<const Motion*> motion = session.ShownMotionTo(editor_.last_frame());
    if (!motion.ok()) return {};
    for (const PlacementJump& jump : motion.value()->placement_jumps) AddJump(jump);
    for (const Warning& warning : motion.value()->warnings) {
      // Those of placements are the jumps.
      if (IndexIn("placements", warning.place)) continue;
      AddPlaced(warning, false);
      if (const auto object = IndexIn("held_objects", warning.place)) {
        AddTaking(static_cast<int>(*object), warning, *motion.value());
      }
    }
    editor_.turns.Look(&session);
    AddRegionProblems(editor_.turns.turns(), &session, &problems_);
    for (const Sinking& sinking : editor_.ground.sinkings()) AddSinking(sinking);
    for (const FootSkate& skate : editor_.flights.analysis().skates) {
      for (const FootSlide& slide : skate.slides) {
        if (slide.distance > kFarSlide) AddSlide(skate.foot, slide);
      }
    }
    for (const FallThrough& fall : FallsThrough(*session.animation(), *motion.value())) {
      if (!IsWarnedOf(fall, *motion.value())) AddFall(fall);
    }
    for (const ContactJerk& jerk : ContactJerks(*session.animation(), *motion.value())) {
      AddJerk(jerk);
    }
    for (const MissingSupport& missing : editor_.effort.missing()) {
      if (!IsOf(missing, session.figure())) continue;  // another one was opened in this frame
      problems_.push_back(SupportProblem(missing, session.figure()));
    }
    AddTime(editor_.flights.analysis().time);
    return Grouped();
  }

 private:
  // With the name of the region or the joint of the hold that it is about.
  void AddPlaced(const Warning& warning, bool is_error) {
    Problem problem{warning.message, editor_.session().frame(), "", {}, is_error, {}};
    const auto region = IndexIn("regions", warning.place), hold = IndexIn("holds", warning.place);
    if (region && *region < project_.regions.size()) {
      const ProjectRegion& of = project_.regions[*region];
      problem.text = of.name + ": " + warning.message;
      problem.region = of.identity.id;
      problem.frame = warning.frame.value_or(of.first_frame);
      AddRemedy(warning.remedy, of, &problem);
    } else if (hold && *hold < project_.holds.size()) {
      const ProjectHold& of = project_.holds[*hold];
      problem.joint = of.joint;
      problem.frame = of.first_frame;
      if (is_error && of.reach == HoldReach::kLimb) {
        problem.cures.push_back({"hold.set",
                                 {{"index", *hold}, {"reach", "body"}},
                                 problem.frame,
                                 Tr("Let the body reach too")});
      }
    }
    problems_.push_back(std::move(problem));
  }

  // The last problem is that an object jumps into a hand: that hand may reach for it.
  void AddTaking(int object, const Warning& warning, const Motion& motion) {
    if (!warning.frame) return;
    const auto taking = TakingAt(object, *warning.frame, *editor_.session().animation(), motion);
    if (!taking) return;
    Problem& problem = problems_.back();
    problem.frame = *warning.frame;
    problem.joint = taking->joint;
    problem.cures.push_back({"pose.reach",
                             {{"joint", taking->joint},
                              {"x", edit::WithoutRoundOff(taking->object.x())},
                              {"y", edit::WithoutRoundOff(taking->object.y())},
                              {"z", edit::WithoutRoundOff(taking->object.z())},
                              {"offset_x", taking->offset.x()},
                              {"offset_y", taking->offset.y()},
                              {"offset_z", taking->offset.z()}},
                             problem.frame,
                             Tr("Reach for it")});
  }

  void AddRemedy(Warning::Remedy remedy, const ProjectRegion& region, Problem* problem) {
    constexpr int kBlendFrames = 5;
    if (remedy == Warning::Remedy::kBlend) {
      problem->cures.push_back({"region.set",
                                {{"region", region.name}, {"blend", kBlendFrames}},
                                problem->frame,
                                Filled(Tr("Blend back over %d frames"), kBlendFrames)});
    } else if (remedy == Warning::Remedy::kLimitTangents) {
      problem->cures.push_back({"region.set",
                                {{"region", region.name}, {"limit_tangents", true}},
                                problem->frame,
                                Tr("Limit tangents")});
    }
  }

  void AddJump(const PlacementJump& jump) {
    std::string text;
    if (jump.speed > 0.0) {
      text =
          Filled(Tr("At frame %d the figure's speed jumps by %.2f m/s."), jump.frame, jump.speed);
    } else {
      text =
          Filled(Tr("At frame %d the figure is %.2f m from its keys, and has %.2f s to get there."),
                 jump.frame, jump.distance, jump.seconds);
    }
    Problem problem{text, static_cast<double>(jump.frame), "", {}, false, {}};
    if (edit::JumpAt(jump.frame, project_)) {
      if (jump.distance > 0.0) {
        problem.text = Filled(
            Tr("Frame %d: the jump comes down %.2f m from where its keys have it, as on a box that "
               "was changed."),
            jump.frame, jump.distance);
      }
      problem.cures.push_back(
          {"jump.aim", Json::object(), problem.frame, Tr("Aim the jump there again")});
    }
    problems_.push_back(std::move(problem));
  }

  void AddJerk(const ContactJerk& jerk) {
    constexpr double kOneG = 9.81;  // [m/s^2]
    const char* text = jerk.is_landing
                           ? "Frame %d: as it lands the body is braked or thrown with %.1f g."
                           : "Frame %d: as it takes off the body is braked or thrown with %.1f g.";
    Problem problem{Filled(Tr(text), jerk.frame, jerk.acceleration / kOneG),
                    static_cast<double>(jerk.frame),
                    "",
                    {},
                    false,
                    {}};
    problem.cures.push_back(
        {"jump.aim", Json::object(), problem.frame, Tr("Aim the jump there again")});
    problems_.push_back(std::move(problem));
  }

  void AddSinking(const Sinking& sinking) {
    const Figure& figure = editor_.session().figure();
    const std::string& joint = figure.group(sinking.joint).name;
    Problem problem;
    problem.text = Filled(Tr("Frames %d to %d: %s is up to %.1f cm in the ground."), sinking.first,
                          sinking.last, joint.c_str(), 100.0 * sinking.depth);
    problem.frame = sinking.deepest;
    problem.joint = joint;
    const auto places = [&](const ProjectPlacement& span) {
      return span.first_frame <= sinking.deepest && sinking.deepest <= span.last_frame;
    };
    const auto& spans = project_.placements;
    if (std::none_of(spans.begin(), spans.end(), places)) {
      problem.cures.push_back({"root.to_ground", Json::object(), problem.frame, ""});
    }
    problems_.push_back(std::move(problem));
  }

  // A region's warnings of one kind and frame are one: each of its hinges has one.
  std::vector<Problem> Grouped() {
    std::vector<Problem> grouped;
    std::vector<int> more;
    for (Problem& problem : problems_) {
      const auto same = std::find_if(grouped.begin(), grouped.end(), [&](const Problem& other) {
        return problem.region.is_valid() && other.region == problem.region &&
               other.frame == problem.frame && !problem.cures.empty() && !other.cures.empty() &&
               other.cures[0].parameters == problem.cures[0].parameters;
      });
      if (same != grouped.end()) {
        ++more[same - grouped.begin()];
        continue;
      }
      grouped.push_back(std::move(problem));
      more.push_back(0);
    }
    for (size_t i = 0; i < grouped.size(); ++i) {
      if (more[i] > 0) grouped[i].text += " (" + Filled(Tr("and %d more"), more[i]) + ")";
    }
    return grouped;
  }

  void AddFall(const FallThrough& fall) {
    constexpr double kFlat = 0.7;  // least slope on which something rests, z of the normal
    const std::string& name = project_.held_objects[fall.object].name;
    Problem problem;
    problem.text =
        Filled(Tr("Frame %d: %s goes into %s."), fall.frame, name.c_str(), fall.obstacle.c_str());
    problem.frame = fall.frame;
    if (fall.normal.z() >= kFlat) {
      problem.cures.push_back({"held.key",
                               {{"object", name},
                                {"x", edit::WithoutRoundOff(fall.outside.x())},
                                {"y", edit::WithoutRoundOff(fall.outside.y())},
                                {"z", edit::WithoutRoundOff(fall.outside.z())}},
                               problem.frame,
                               Tr("Let it rest there")});
    }
    const bool may_touch =
        std::holds_alternative<ProjectSphereShape>(project_.held_objects[fall.object].shape);
    if (may_touch && project_.solver.method == Method::kExact) {
      problem.cures.push_back({"held.set",
                               {{"object", name}, {"contacts", true}},
                               problem.frame,
                               Tr("Let it touch the scene")});
    }
    problems_.push_back(std::move(problem));
  }

  void AddSlide(const std::string& foot, const FootSlide& slide) {
    Problem problem;
    problem.text = Filled(Tr("Frames %d to %d: %s slides %.0f cm on the ground."), slide.first,
                          slide.last, foot.c_str(), 100.0 * slide.distance);
    problem.frame = slide.first;
    problem.joint = foot;
    if (editor_.session().figure().FindGroup(foot)) {
      problem.cures.push_back({"hold.add",
                               {{"joint", foot}, {"first", slide.first}, {"last", slide.last}},
                               problem.frame,
                               Tr("Hold it there")});
    }
    problems_.push_back(std::move(problem));
  }

  void AddTime(const TimeScale& time) {
    const std::string alarm = AlarmText(time), repair = RepairText(time);
    if (alarm.empty()) return;
    Problem problem{alarm, editor_.session().frame(), "", {}, false, {}};
    if (!repair.empty()) {
      problem.cures.push_back({"time.rate",
                               {{"num", *time.frame_rate}, {"den", 1}, {"keep_shape", true}},
                               problem.frame,
                               repair});
    }
    problems_.push_back(std::move(problem));
  }

  Editor& editor_;
  const Project& project_;
  std::vector<Problem> problems_;
};

}  // namespace

bool HasProblems(Editor* editor) {
  edit::Session& session = editor->session();
  if (session.KnownError()) return true;
  const Result<const Motion*> motion = session.ShownMotionTo(editor->last_frame());
  if (!motion.ok()) return false;
  editor->turns.Look(&session);
  // Jumps are among the warnings.
  return !motion.value()->warnings.empty() || !editor->turns.turns().empty() ||
         AnyOutlasts(*session.animation()) || !editor->ground.sinkings().empty() ||
         SlidesFar(editor->flights.analysis()) || !editor->effort.missing().empty() ||
         !FallsThrough(*session.animation(), *motion.value()).empty() ||
         !ContactJerks(*session.animation(), *motion.value()).empty() ||
         !AlarmText(editor->flights.analysis().time).empty();
}

std::vector<Problem> ProblemsOf(Editor* editor) { return ProblemList(editor).Find(); }

void GoTo(const Problem& problem, Editor* editor) {
  editor->Do("time.frame", {{"frame", problem.frame}});
  if (!problem.joint.empty())
    editor->Do("select.joints", {{"joints", Json::array({problem.joint})}});
  if (problem.region.is_valid()) editor->side.region = problem.region;
}

bool Apply(const Cure& cure, Editor* editor) {
  return editor->Do("time.frame", {{"frame", cure.frame}}) &&
         editor->Do(cure.operator_id, cure.parameters);
}

}  // namespace hazumi::ui
