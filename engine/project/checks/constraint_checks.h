#pragma once

// Internal. What must hold between constraints, objects, and regions.

#include <optional>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/project/checks/checks.h"
#include "engine/project/checks/spans.h"
#include "engine/project/json/site.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Reports the first object that a constraint names and that is not there, or is not the only one
// that may be meant, and an end with both a joint and an object.
void CheckConstraintNames(const Project& project, const Site& site);

// Who has an object in all of these frames; null, and reported, if no one has.
const Holder* HolderDuring(const HeldObject& object, Span span, const Animation& animation,
                           const Site& site);

// As CheckAnimation.
void CheckConstraints(const Animation& animation, FirstError* errors);

// Whether a region may move one of its ends.
bool IsFelt(const Constraint& constraint, const Animation& animation);
// Returns the frame from which no region moves the ends of a constraint, if that is before its last
// frame; nullopt if no region moves them at all.
std::optional<int> OutlastsFrom(const Constraint& constraint, const Animation& animation);
// Returns the constraints with such a frame.
std::vector<OutlastingConstraint> FindOutlasting(const Animation& animation);
// Warns of constraints without effect, whose ends no region moves or only up to a frame before the
// last one.
void WarnAboutConstraints(const Animation& animation, std::vector<Warning>* warnings);

}  // namespace hazumi
