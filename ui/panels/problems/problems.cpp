#include "ui/panels/problems/problems.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/analysis/problems/problems.h"
#include "engine/base/filled.h"
#include "engine/base/text.h"
#include "engine/dynamics/kinematics.h"
#include "engine/project/checks/constraint_checks.h"
#include "engine/project/checks/joint_names.h"
#include "ui/edit/operators/edits.h"
#include "ui/panels/text/quantity_text.h"

namespace hazumi::ui {

namespace {

// Analyses of the motion, as far as the editor has made them.
Analyses KnownAnalyses(Editor* editor) {
  edit::Session& session = editor->session();
  const Animation& animation = *session.animation();
  editor->turns.Look(&session);
  Analyses known;
  known.turns = editor->turns.turns();
  std::erase_if(known.turns, [&](const HeldTurn& turn) {
    return turn.region >= animation.regions.size();  // the current edit removed the region
  });
  known.outlasting = FindOutlasting(animation);
  known.sinkings = editor->ground.sinkings();
  known.skates = editor->flights.analysis().skates;
  known.time = editor->flights.analysis().time;
  known.missing = editor->effort.missing();
  std::erase_if(known.missing, [&](const MissingSupport& missing) {
    return missing.joint.value() >= session.figure().num_joints();  // of another document
  });
  return known;
}

// Findings of the motion that is shown; none if there is no motion.
std::vector<Finding> FindingsOf(Editor* editor) {
  const Result<const Motion*> motion = editor->session().ShownMotionTo(editor->last_frame());
  if (!motion.ok()) return {};
  return FindProblems(*editor->session().animation(), *motion.value(), KnownAnalyses(editor));
}

// Two places on the frame on which a joint takes a held object.
struct Taking {
  std::string joint;
  Vec3 object;  // where the object is until then [m]
  Vec3 offset;  // where it lies in the joint's frame from then on [m]
};

// `object`: of the animation's held objects. Nothing if none takes it on that frame.
std::optional<Taking> TakingAt(int object, int frame, const Animation& animation,
                               const Motion& motion) {
  const std::vector<Holder>& holders = animation.held_objects[static_cast<size_t>(object)].holders;
  const auto taker = std::find_if(holders.begin(), holders.end(),
                                  [&](const Holder& each) { return each.first_frame == frame; });
  const int i = frame - animation.first_frame;
  if (taker == holders.end() || i < 2 || i >= static_cast<int>(motion.frames.size())) return {};
  const Figure& figure = *animation.figure;
  if (taker == holders.begin() || std::prev(taker)->last_frame != frame) {
    // As between the two frames before.
    const auto place = [&](int before) -> const Vec3& {
      const MotionFrame& there = motion.frames[static_cast<size_t>(i - before)];
      return there.objects[static_cast<size_t>(object)].X_WO.p;
    };
    return Taking{figure.group(taker->joint).name, 2.0 * place(1) - place(2), taker->offset};
  }
  const MotionFrame& now = motion.frames[static_cast<size_t>(i)];
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, now.X_WR, now.q, &ws);
  const Holder& giver = *std::prev(taker);
  const BodyScratch& body = ws.body(figure.group(giver.joint).last());
  return Taking{figure.group(taker->joint).name, body.p + body.R * giver.offset, taker->offset};
}

// Adds to a problem what leads to it, and its cures.
class Guide {
 public:
  Guide(edit::Session* session, const Motion* motion, Problem* problem)
      : session_(*session), project_(session->project()), motion_(motion), problem_(*problem) {}

  void operator()(const PlacementJump& jump) {
    if (!JumpAt(jump.frame, project_.placements)) return;
    AddCure("jump.aim", Json::object(), Tr("Aim the jump there again"));
  }

  void operator()(const Warning& warning) {
    if (const auto region = IndexIn("regions", warning.place)) Lead(*region, warning);
    if (const auto hold = IndexIn("holds", warning.place)) LeadToHold(*hold);
    if (const auto object = IndexIn("held_objects", warning.place)) {
      OfferToReach(static_cast<int>(*object), warning);
    }
  }

  void operator()(const HeldTurn& turn) {
    if (turn.region >= project_.regions.size()) return;
    const ProjectRegion& region = project_.regions[turn.region];
    problem_.region = region.identity.id;
    AddCure("region.add_joints",
            {{"region", region.name}, {"joints", {NameOfRoot(session_.figure())}}},
            Tr("Let the whole body turn freely"));
  }

  void operator()(const OutlastingConstraint& own) {
    const std::string& name =
        session_.animation()->constraints[static_cast<size_t>(own.constraint)].name;
    AddCure("constraint.set", {{"constraint", name}, {"last", own.from}}, Tr("End it there"));
  }

  void operator()(const Sinking& sinking) {
    problem_.joint = session_.figure().group(sinking.joint).name;
    const auto places = [&](const ProjectPlacement& span) {
      return span.first_frame <= sinking.deepest && sinking.deepest <= span.last_frame;
    };
    const auto& spans = project_.placements;
    if (std::none_of(spans.begin(), spans.end(), places)) {
      AddCure("root.to_ground", Json::object(), "");
    }
  }

  void operator()(const SlidingFoot& foot) {
    problem_.joint = foot.foot;
    if (!session_.figure().FindGroup(foot.foot)) return;
    AddCure("hold.add",
            {{"joint", foot.foot}, {"first", foot.slide.first}, {"last", foot.slide.last}},
            Tr("Hold it there"));
  }

  void operator()(const FallThrough& fall) {
    constexpr double kFlat = 0.7;  // least slope on which something rests, z of the normal
    const ProjectHeldObject& object = project_.held_objects[static_cast<size_t>(fall.object)];
    if (fall.normal.z() >= kFlat) {
      AddCure("held.key",
              {{"object", object.name},
               {"x", WithoutRoundOff(fall.outside.x())},
               {"y", WithoutRoundOff(fall.outside.y())},
               {"z", WithoutRoundOff(fall.outside.z())}},
              Tr("Let it rest there"));
    }
    const bool may_touch = std::holds_alternative<ProjectSphereShape>(object.shape);
    if (may_touch && project_.solver.method == Method::kExact) {
      AddCure("held.set", {{"object", object.name}, {"contacts", true}},
              Tr("Let it touch the scene"));
    }
  }

  void operator()(const ContactJerk&) {
    AddCure("jump.aim", Json::object(), Tr("Aim the jump there again"));
  }

  void operator()(const MissingSupport&) {}

  void operator()(const TimeScale& time) {
    const std::string repair = RepairText(time);
    if (repair.empty()) return;
    AddCure("time.rate", {{"num", *time.frame_rate}, {"den", 1}, {"keep_shape", true}}, repair);
  }

 private:
  void AddCure(const char* operator_id, Json parameters, std::string label) {
    problem_.cures.push_back(
        {operator_id, std::move(parameters), problem_.frame, std::move(label)});
  }

  void Lead(size_t region, const Warning& warning) {
    constexpr int kBlendFrames = 5;
    if (region >= project_.regions.size()) return;
    const ProjectRegion& own = project_.regions[region];
    problem_.region = own.identity.id;
    problem_.frame = warning.frame.value_or(own.first_frame);
    if (warning.remedy == Warning::Remedy::kBlend) {
      AddCure("region.set", {{"region", own.name}, {"blend", kBlendFrames}},
              Filled(Tr("Blend back over %d frames"), kBlendFrames));
    } else if (warning.remedy == Warning::Remedy::kLimitTangents) {
      AddCure("region.set", {{"region", own.name}, {"limit_tangents", true}}, Tr("Limit tangents"));
    }
  }

  void LeadToHold(size_t hold) {
    if (hold >= project_.holds.size()) return;
    const ProjectHold& own = project_.holds[hold];
    problem_.joint = own.joint;
    problem_.frame = own.first_frame;
    if (problem_.is_error && own.reach == HoldReach::kLimb) {
      AddCure("hold.set", {{"index", hold}, {"reach", "body"}}, Tr("Let the body reach too"));
    }
  }

  // An object jumps into a hand: that hand may reach for it.
  void OfferToReach(int object, const Warning& warning) {
    if (!warning.frame || motion_ == nullptr) return;
    const auto taking = TakingAt(object, *warning.frame, *session_.animation(), *motion_);
    if (!taking) return;
    problem_.frame = *warning.frame;
    problem_.joint = taking->joint;
    AddCure("pose.reach",
            {{"joint", taking->joint},
             {"x", WithoutRoundOff(taking->object.x())},
             {"y", WithoutRoundOff(taking->object.y())},
             {"z", WithoutRoundOff(taking->object.z())},
             {"offset_x", taking->offset.x()},
             {"offset_y", taking->offset.y()},
             {"offset_z", taking->offset.z()}},
            Tr("Reach for it"));
  }

  edit::Session& session_;
  const Project& project_;
  const Motion* motion_;
  Problem& problem_;
};

// Joins a region's warnings of one kind and frame: each of its hinges has one.
std::vector<Problem> Grouped(std::vector<Problem> problems) {
  std::vector<Problem> grouped;
  std::vector<int> more;
  for (Problem& problem : problems) {
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

// The error that prevents a motion, with the name of the region that it is about.
Problem ProblemOf(const Error& error, edit::Session* session) {
  Problem problem{error.message, session->frame(), "", {}, /*is_error=*/true, {}};
  const auto region = IndexIn("regions", error.place);
  if (region && *region < session->project().regions.size()) {
    problem.text = session->project().regions[*region].name + ": " + error.message;
  }
  Guide(session, nullptr, &problem)(Warning{error.place, error.message});
  return problem;
}

}  // namespace

bool HasProblems(Editor* editor) {
  return editor->session().KnownError().has_value() || !FindingsOf(editor).empty();
}

std::vector<Problem> ProblemsOf(Editor* editor) {
  edit::Session& session = editor->session();
  if (const std::optional<Error> error = session.KnownError()) return {ProblemOf(*error, &session)};
  const Result<const Motion*> motion = session.ShownMotionTo(editor->last_frame());
  if (!motion.ok()) return {};
  std::vector<Problem> problems;
  for (const Finding& finding : FindingsOf(editor)) {
    Problem problem;
    problem.text = TextOf(finding, *session.animation(), Tr);
    const std::optional<int> frame = FrameOf(finding);
    problem.frame = frame ? *frame : session.frame();
    std::visit(Guide(&session, motion.value(), &problem), finding);
    problems.push_back(std::move(problem));
  }
  return Grouped(std::move(problems));
}

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
