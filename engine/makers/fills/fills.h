#pragma once

// Fills joints between the keys that the animator sets: keys of the type generated.

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/project/project.h"

namespace hazumi::makers {

// Result of one fill.
struct FillReport {
  int keys = 0;           // that it wrote
  double farthest = 0.0;  // that a joint is from where the animator's keys alone have it [m]
  std::string joint;      // that one, and the frame; empty: none moves
  int frame = 0;
  // Curves that keep parts that hold, are linear or eased.
  std::vector<std::string> stepped;
  // Curves that stay as they are: the joint has fewer than two keys in the fill, or its rotations
  // lead to other angles than its keys have.
  std::vector<std::string> unfilled;
};

// True for a key that the fill wrote.
bool IsOfFill(const ProjectKey& key, const ProjectFill& fill);
// Removes all generated keys of joints and root.
void RemoveGeneratedKeys(Project* project);
// Removes the keys that one fill wrote.
void RemoveGeneratedKeys(const ProjectFill& fill, const Figure& figure, Project* project);
// Gives the keys that a fill wrote to the animator.
void KeepGeneratedKeys(const ProjectFill& fill, const Figure& figure, Project* project);

struct MadeFills {
  Project project;
  std::vector<FillReport> reports;  // by index of Project::fills
};
// Makes the keys of all fills anew, in the order of the list. The same project gives the same keys,
// whatever keys the fills had. Errors: those of CompileAnimation and Bake without the fills' keys;
// kSchema for keys between frames; kInterrupted where `cancel` is set.
// `figure`: the project's, if it is known.
Result<MadeFills> MakeFills(const Project& project, std::shared_ptr<const Figure> figure = nullptr,
                            const std::atomic<bool>* cancel = nullptr);

// True if two projects agree in all that their fills depend on.
bool HaveSameFills(const Project& a, const Project& b);

}  // namespace hazumi::makers
