#pragma once

// Wrong projects, and what Hazumi must say about each.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/project/checks/checks.h"

namespace hazumi::testing {

struct WrongProject {
  Check check;                       // the complaint's number; kNumChecks: of the figure builder
  std::function<std::string()> say;  // does the wrong thing; gives "place: message"
  std::string expected;
};

std::vector<WrongProject> WrongProjects();

// True if `message` is the check's sentence with its {} filled in.
bool Instantiates(std::string_view message, Check check);

// The part of them that is well formed: values, names and contradictions.
std::vector<WrongProject> WrongDocuments();

// Those of drives.
std::vector<WrongProject> WrongDrives();

// Those of a skin.
std::vector<WrongProject> WrongSkins();

// Those of forces from outside.
std::vector<WrongProject> WrongForces();

// Those of constraints.
std::vector<WrongProject> WrongConstraints();

// Those of contacts.
std::vector<WrongProject> WrongContacts();

}  // namespace hazumi::testing
