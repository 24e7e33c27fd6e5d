#pragma once

// Internal: what aiming a throw and making one share.

#include <memory>
#include <optional>

#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/held/throw_aim.h"

namespace hazumi::edit {

// Where something is to come down [m], and how far it rises above the hand, if that is given [m].
struct ThrowTarget {
  Vec3 ground;
  std::optional<double> height;
};
// Of the operators' parameters: "object", the target's, and a drag.
std::vector<ParameterInfo> ThrowParameters();
ThrowTarget TargetOf(const Parameters& p);
// The project becomes this one, in one undo step.
Result<Done> PutThrown(Session* session, const char* label, Project project, const Parameters& p);

// How far to the side of where the figure faces it can throw [rad].
inline constexpr double kWidestThrow = 75.0 * kDegree;

// Whether a dynamics region moves who lets go of the object next, so that its throw can be aimed;
// not if who has it in the current frame keeps it.
bool HasThrow(int object, Session* session);

// A throw that was made, whose arm goes back and swings forward by its keys, swings and turns as if
// it were made for this target, and knows that it has a backswing; any other stays as it is.
void SwingAnew(const ThrowTarget& target, const Animation& animation, const Motion& motion,
               ThrowCase* of, Project* project);

// The region starts as fast as it has to, and what is thrown lies on the spot from when it comes
// down. The hinges of the case are found. Errors: those of ThrowAim, and what would help.
Result<Done> ThrowTo(const ThrowTarget& target, ThrowCase of, std::shared_ptr<const Figure> figure,
                     Project* project);

}  // namespace hazumi::edit
