#pragma once

// Internal. From the names of a document to the joints of a figure.

#include <optional>
#include <string>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/project/checks/checks.h"
#include "engine/project/json/site.h"
#include "engine/project/project.h"

namespace hazumi {

// What a name means: one hinge, or a group and all its hinges.
struct MeantJoints {
  JointIndex first, end;  // the joints [first, end)
  GroupIndex group;
};

// A group goes before a hinge of the same name: it then has this hinge only.
std::optional<MeantJoints> FindJoints(const Figure& figure, const std::string& name);

// True if the name means the root: its own name, or "root", unless a joint is called so.
bool MeansRoot(const std::string& name, const Figure& figure);

// Resolves a reference: "name+" is "name" and everything beyond it, unless a joint or the root has
// the whole name.
JointRef Meant(const JointRef& ref, const Figure& figure);
// Replaces each reference by what it means.
void Resolve(const Figure& figure, std::vector<JointRef>* refs);

// Name of the root in lists of joints: its own, or "root" where a joint has that name; empty if
// joints have both.
std::string NameOfRoot(const Figure& figure);

// True if one of them names the root.
bool NameRoot(const std::vector<JointRef>& refs, const Figure& figure);
// True if the region drives the root's orientation.
bool DrivesRoot(const ProjectRegion& region, const Figure& figure);

// The hinges that are meant, by index; of a region those that it drives. Unknown names are left
// out.
std::vector<bool> JointsOf(const std::vector<JointRef>& refs, const Figure& figure);
std::vector<bool> JointsOf(const ProjectRegion& region, const Figure& figure);

// False, and reported, if there is no such joint.
bool ExpectJoint(const std::string& name, const Figure& figure, const Site& site);

// Reports the first name in the project that the figure does not know, or that does not fit where
// it stands.
void CheckNames(const Project& project, const Figure& figure, FirstError* errors);

}  // namespace hazumi
