#include "tests/unit/edit/random/drives_of_regions.h"

namespace hazumi::test {

namespace {

std::vector<ProjectKey> KeysOf(const ProjectDrive& drive) {
  std::vector<ProjectKey> keys = drive.torque.keys;
  for (const ProjectCurve* curve : {&drive.frequency_over_time, &drive.strength_over_time}) {
    keys.insert(keys.end(), curve->keys.begin(), curve->keys.end());
  }
  return keys;
}

// Gives what a drive of its kind has over time.
void KeepToCurves(const ProjectDrive& drive, Random* random, edit::Json* parameters) {
  for (const char* curve : {"torque", "frequency", "strength"}) parameters->erase(curve);
  if (drive.kind == DriveKind::kTorque) {
    (*parameters)["torque"] = random->Uniform(-20.0, 20.0);
    return;
  }
  (*parameters)["frequency"] = random->Uniform(0.5, 10.0);
}

}  // namespace

std::vector<DriveOfRegion> DrivesFor(const std::string& id, const edit::Session& session) {
  std::vector<DriveOfRegion> found;
  for (const ProjectRegion& region : session.project().regions) {
    for (size_t i = 0; i < region.drives.size(); ++i) {
      const ProjectDrive& drive = region.drives[i];
      if (id == "drive.key" && drive.kind == DriveKind::kKeys) continue;
      if (id == "drive.remove_key" && KeysOf(drive).empty()) continue;
      found.push_back({region.name, static_cast<int>(i), drive});
    }
  }
  return found;
}

void KeepToDrive(const std::string& id, const edit::Session& session, Random* random,
                 edit::Json* parameters) {
  const auto any = [random](const auto& list) {
    return list[random->Integer(0, static_cast<int>(list.size()) - 1)];
  };
  const std::vector<ProjectRegion>& regions = session.project().regions;
  if (regions.empty()) return;
  ProjectRegion region = any(regions);
  if (parameters->contains("number")) {
    const std::vector<DriveOfRegion> drives = DrivesFor(id, session);
    if (drives.empty()) return;
    const DriveOfRegion own = any(drives);
    (*parameters)["number"] = own.number;
    for (const ProjectRegion& each : regions) {
      if (each.name == own.region) region = each;
    }
    const std::vector<ProjectKey> keys = KeysOf(own.drive);
    if (id == "drive.remove_key") parameters->erase("of");
    if (id == "drive.remove_key" && !keys.empty()) (*parameters)["frame"] = any(keys).frame;
    if (id == "drive.key") KeepToCurves(own.drive, random, parameters);
  }
  (*parameters)["region"] = region.name;
  if (!parameters->contains("joints") || region.joints.empty()) return;
  const JointRef ref = any(region.joints);
  (*parameters)["joints"] = {ref.name + (ref.beyond ? "+" : "")};
}

}  // namespace hazumi::test
