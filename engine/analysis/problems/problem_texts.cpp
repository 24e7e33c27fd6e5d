// Sentences about problems. Their English is the key of the catalogue of the editor.

#include "engine/analysis/problems/problems.h"
#include "engine/base/filled.h"

namespace hazumi {

namespace {

class Sentences {
 public:
  Sentences(const Animation& animation, Translate translate)
      : animation_(animation), Tr(translate) {}

  std::string operator()(const PlacementJump& jump) const {
    if (jump.distance > 0.0 && JumpAt(jump.frame, animation_.placements)) {
      return Filled(Tr("Frame %d: the jump comes down %.2f m from where its keys have it, as on a "
                       "box that was changed."),
                    jump.frame, jump.distance);
    }
    if (jump.speed > 0.0) {
      return Filled(Tr("At frame %d the figure's speed jumps by %.2f m/s."), jump.frame,
                    jump.speed);
    }
    return Filled(
        Tr("At frame %d the figure is %.2f m from its keys, and has %.2f s to get there."),
        jump.frame, jump.distance, jump.seconds);
  }

  // With the name of the region that the warning is about.
  std::string operator()(const Warning& warning) const {
    const std::optional<size_t> region = IndexIn("regions", warning.place);
    if (!region || *region >= animation_.regions.size()) return warning.message;
    return animation_.regions[*region].name + ": " + warning.message;
  }

  std::string operator()(const HeldTurn& turn) const {
    return Filled(Tr("%s: gravity and contacts move the body, but keys hold its turn: nothing "
                     "supplies the %.0f N m that this takes in frame %d."),
                  animation_.regions[turn.region].name.c_str(), turn.moment, turn.frame);
  }

  std::string operator()(const OutlastingConstraint& own) const {
    const Constraint& constraint = animation_.constraints[static_cast<size_t>(own.constraint)];
    return Filled(Tr("%s: from frame %d on no region moves its ends, so that it has no effect up "
                     "to its last frame %d."),
                  constraint.name.c_str(), own.from, constraint.last_frame);
  }

  std::string operator()(const Sinking& sinking) const {
    const std::string& joint = animation_.figure->group(sinking.joint).name;
    return Filled(Tr("Frames %d to %d: %s is up to %.1f cm in the ground."), sinking.first,
                  sinking.last, joint.c_str(), 100.0 * sinking.depth);
  }

  std::string operator()(const SlidingFoot& foot) const {
    return Filled(Tr("Frames %d to %d: %s slides %.0f cm on the ground."), foot.slide.first,
                  foot.slide.last, foot.foot.c_str(), 100.0 * foot.slide.distance);
  }

  std::string operator()(const FallThrough& fall) const {
    return Filled(Tr("Frame %d: %s goes into %s."), fall.frame,
                  animation_.held_objects[static_cast<size_t>(fall.object)].name.c_str(),
                  fall.obstacle.c_str());
  }

  std::string operator()(const ContactJerk& jerk) const {
    constexpr double kOneG = 9.81;  // [m/s^2]
    const char* text =
        jerk.is_landing ? Tr("Frame %d: as it lands the body is braked or thrown with %.1f g.")
                        : Tr("Frame %d: as it takes off the body is braked or thrown with %.1f g.");
    return Filled(text, jerk.frame, jerk.acceleration / kOneG);
  }

  std::string operator()(const MissingSupport& missing) const {
    const Figure& figure = *animation_.figure;
    const std::string edge = missing.joint.is_valid()
                                 ? figure.group(figure.joint(missing.joint).group).name
                                 : figure.root_name();
    const std::string frames = missing.first == missing.last
                                   ? Filled(Tr("Frame %d: "), missing.first)
                                   : Filled(Tr("Frames %d to %d, most at %d: "), missing.first,
                                            missing.last, missing.worst);
    return frames + WhatIsMissing(missing, edge);
  }

  std::string operator()(const TimeScale& time) const { return AlarmText(time, Tr); }

 private:
  std::string WhatIsMissing(const MissingSupport& missing, const std::string& edge) const {
    const double cm = 100.0 * missing.distance;
    switch (missing.fault) {
      case SupportFault::kFloats:
        return Filled(
            Tr("nothing carries the figure, %.0f N are missing. Bring it to the ground, pin "
               "what stands, or let gravity place it."),
            missing.force);
      case SupportFault::kPulled:
        return Filled(Tr("the ground would have to pull the figure down by %.0f N. Slow the drop "
                         "down, or let it leave the ground."),
                      missing.force);
      case SupportFault::kSlides:
        return Filled(Tr("the ground would have to push sideways, by %.0f N harder than friction "
                         "can. Move more slowly, or put the feet further out."),
                      missing.force);
      case SupportFault::kTips:
        return Filled(Tr("the centre of mass is %.1f cm beyond %s, and nothing keeps the figure "
                         "from falling over (%.0f N m). Move the weight back, or step there."),
                      cm, edge.c_str(), missing.moment);
      case SupportFault::kPushedOff:
        return Filled(Tr("the ground would have to push %.1f cm beyond %s (%.0f N m are missing). "
                         "Move more slowly, or step there."),
                      cm, edge.c_str(), missing.moment);
      case SupportFault::kTurned:
        return Filled(Tr("what touches cannot turn the figure so (%.0f N m are missing). Turn "
                         "more slowly, or give it more to stand on."),
                      missing.moment);
      case SupportFault::kTurnsInAir:
        return Filled(Tr("in the air nothing can turn the figure so (%.0f N m are missing). Let "
                         "the root turn evenly until it lands."),
                      missing.moment);
    }
    return "";
  }

  const Animation& animation_;
  Translate Tr;
};

}  // namespace

std::string AlarmText(const TimeScale& time, Translate Tr) {
  const std::string gravity =
      Filled(Tr("Gravity comes out as %.3g m/s² (%.3g – %.3g), not %.3g: "), time.gravity,
             time.gravity_range.low, time.gravity_range.high, time.true_gravity);
  if (time.verdict == TimeVerdict::kWrongFrameTime) {
    return gravity + Filled(Tr("it should be played at %.3g frames a second, not %.3g."),
                            RateToSet(time) ? *time.frame_rate : 1.0 / time.true_frame_time,
                            1.0 / time.frame_time);
  }
  if (time.verdict == TimeVerdict::kWrongLength) {
    return gravity + Filled(Tr("the size was guessed; import it again, %.2f m tall."),
                            time.stature * time.length_factor);
  }
  return "";
}

std::string TextOf(const Finding& finding, const Animation& animation, Translate translate) {
  return std::visit(Sentences(animation, translate), finding);
}

}  // namespace hazumi
