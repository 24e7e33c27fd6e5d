#pragma once

#include <string>
#include <vector>

#include "tests/support/random.h"
#include "ui/edit/session/session.h"

namespace hazumi::test {

// Drives that there are, that an operator may be asked to change.
struct DriveOfRegion {
  std::string region;
  int number;
  ProjectDrive drive;
};
// By the operator's name: torques, torques with keys, or any.
std::vector<DriveOfRegion> DrivesFor(const std::string& id, const edit::Session& session);

// Joints of a region, and a drive that there is.
void KeepToDrive(const std::string& id, const edit::Session& session, Random* random,
                 edit::Json* parameters);

}  // namespace hazumi::test
