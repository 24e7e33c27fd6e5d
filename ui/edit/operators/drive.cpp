// Drives of regions: with how much muscle their joints move.

#include <algorithm>

#include "engine/project/checks/joint_names.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/regions.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kNumberOf = {"number", kInteger, true, "of its drives, from 0"};
const ParameterInfo kDriveFrame = {"frame", kNumber, false, "not given: the current one"};

template <typename Action>
Result<Done> ChangeDrive(Session* session, const Parameters& p, const char* label, Action action) {
  return ChangeRegion(session, p, label, [&](Project*, ProjectRegion* region) -> Result<Done> {
    const int number = p.integer("number"), count = static_cast<int>(region->drives.size());
    if (number < 0 || number >= count) {
      return Refusal("number", "\"" + region->name + "\" has " + std::to_string(count) +
                                   " drives, counted from 0");
    }
    // A drive that the animator touches is his: no aim finds it anew.
    region->drives[number].solved_by.clear();
    return action(region, number);
  });
}

// Joints have one drive: those that the others name alike go over to this one, and a drive that has
// none left goes.
void TakeOver(size_t number, ProjectRegion* region) {
  const std::vector<JointRef> taken = region->drives[number].joints;
  for (size_t d = 0; d < region->drives.size(); ++d) {
    if (d == number) continue;
    std::erase_if(region->drives[d].joints, [&](const JointRef& ref) {
      return std::any_of(taken.begin(), taken.end(),
                         [&](const JointRef& own) { return NameOf(own) == NameOf(ref); });
    });
  }
  std::erase_if(region->drives, [](const ProjectDrive& drive) { return drive.joints.empty(); });
}

// Removes the root, which has no muscles.
void LeaveOutRoot(const Figure& figure, std::vector<JointRef>* refs) {
  std::erase_if(*refs,
                [&](const JointRef& ref) { return !ref.beyond && MeansRoot(ref.name, figure); });
}

// Resets fields that the file does not say of this kind: a project that is opened again has to be
// the same.
void DropHidden(ProjectDrive* drive) {
  if (drive->kind != DriveKind::kTorque) {
    drive->torque = {};
    drive->solved_by.clear();
  }
  if (drive->kind == DriveKind::kSpring) return;
  ProjectDrive kept;
  kept.kind = drive->kind;
  kept.joints = std::move(drive->joints);
  kept.torque = std::move(drive->torque);
  kept.solved_by = drive->solved_by;
  kept.extra = std::move(drive->extra);
  kept.identity = drive->identity;
  *drive = std::move(kept);
}

Result<Done> AddDrive(Session* session, const Parameters& p) {
  return ChangeRegion(session, p, "Add drive",
                      [&](Project*, ProjectRegion* region) -> Result<Done> {
                        ProjectDrive drive;
                        for (const std::string& name : session->selected_joints()) {
                          drive.joints.push_back({name, false, {}});
                        }
                        LeaveOutRoot(session->figure(), &drive.joints);
                        if (drive.joints.empty()) drive.joints = region->joints;
                        LeaveOutRoot(session->figure(), &drive.joints);
                        if (Result<Done> set = SetFields(p, &drive); !set.ok()) return set.error();
                        DropHidden(&drive);
                        Resolve(session->figure(), &drive.joints);
                        region->drives.push_back(std::move(drive));
                        TakeOver(region->drives.size() - 1, region);
                        return Done();
                      });
}

// A curve that a drive has, and what it is called.
struct DriveCurve {
  const char* parameter;
  ProjectCurve ProjectDrive::*curve;
  DriveKind kind;  // of drives that have it
};
constexpr DriveCurve kDriveCurves[] = {
    {"torque", &ProjectDrive::torque, DriveKind::kTorque},
    {"frequency", &ProjectDrive::frequency_over_time, DriveKind::kSpring},
    {"strength", &ProjectDrive::strength_over_time, DriveKind::kSpring},
};

Result<Done> SetDrive(Session* session, const Parameters& p) {
  return ChangeDrive(session, p, "Change drive", [&](ProjectRegion* region, int number) {
    ProjectDrive& drive = region->drives[number];
    if (p.yes("unlimited")) {
      drive.max_torque_n_m.reset();
      drive.strength.reset();
      drive.strength_over_time = {};
    }
    Result<Done> set = SetFields(p, &drive);
    DropHidden(&drive);
    if (p.has("joints")) {
      Resolve(session->figure(), &drive.joints);
      TakeOver(static_cast<size_t>(number), region);
    }
    return set;
  });
}

Result<Done> RemoveDrive(Session* session, const Parameters& p) {
  return ChangeDrive(session, p, "Remove drive", [](ProjectRegion* region, int number) {
    region->drives.erase(region->drives.begin() + number);
    return Result<Done>(Done());
  });
}

Result<Done> PutKeyOf(const DriveCurve& what, const Parameters& p, double frame,
                      ProjectDrive* drive) {
  if (drive->kind != what.kind) {
    return Refusal(what.parameter, std::string("it is of kind ") + NameOf(drive->kind) +
                                       ", which has none over time");
  }
  ProjectCurve* curve = &(drive->*what.curve);
  ProjectKey key = KeyToChange(frame, *curve);
  key.value = p.number(what.parameter);
  if (Result<Done> set = SetFields(p, &key); !set.ok()) return set;
  PutKey(key, curve);
  return Done();
}

Result<Done> KeyDrive(Session* session, const Parameters& p) {
  return ChangeDrive(session, p, "Key drive", [&](ProjectRegion* region, int number) {
    Result<Done> done = Refusal("torque", "give a torque, a frequency or a strength");
    for (const DriveCurve& what : kDriveCurves) {
      if (!p.has(what.parameter)) continue;
      done = PutKeyOf(what, p, p.number("frame", session->frame()), &region->drives[number]);
      if (!done.ok()) break;
    }
    return done;
  });
}

Result<Done> RemoveDriveKey(Session* session, const Parameters& p) {
  return ChangeDrive(
      session, p, "Remove key of drive", [&](ProjectRegion* region, int number) -> Result<Done> {
        const double frame = p.number("frame", session->frame());
        const std::string of = p.text("of");
        size_t gone = 0;
        for (const DriveCurve& what : kDriveCurves) {
          if (!of.empty() && of != what.parameter) continue;
          gone += std::erase_if((region->drives[number].*what.curve).keys,
                                [frame](const ProjectKey& key) { return key.frame == frame; });
        }
        if (gone == 0) return Refusal("frame", "there is no such key");
        return Done();
      });
}

}  // namespace

std::vector<Operator> DriveOperators() {
  const ParameterInfos fields = FieldsOf<ProjectDrive>();
  return {
      {"drive.add", "Add drive",
       "Gives joints of a region muscle. Not given: a spring to the keys, of the selected joints, "
       "else of all.",
       Joined({{kOfRegion}, fields, {kDrag}}), AddDrive},
      {"drive.set", "Change drive", "Changes what is given of a drive.",
       Joined({{kOfRegion, kNumberOf},
               fields,
               {{"unlimited", kYesNo, false, "true: it pulls as hard as it takes"}, kDrag}}),
       SetDrive},
      {"drive.remove",
       "Remove drive",
       "Takes a drive away: its joints are limp.",
       {kOfRegion, kNumberOf},
       RemoveDrive},
      {"drive.key", "Key drive",
       "Sets a key of a torque, or of a spring's frequency or strength over time, or makes one.",
       Joined(
           {{kOfRegion,
             kNumberOf,
             kDriveFrame,
             {"torque", kNumber, false, "positive accelerates the angle positively", {}, "", "N m"},
             {"frequency",
              kNumber,
              false,
              "how often a second it would swing, undamped",
              {},
              "",
              "Hz"},
             {"strength", kNumber, false, "share of what the joints' muscles can give"}},
            Only({"rate", "interpolation", "easing", "rate_in", "length_in", "length_out", "type"},
                 FieldsOf<ProjectKey>()),
            {kDrag}}),
       KeyDrive},
      {"drive.remove_key",
       "Remove key of drive",
       "Takes keys of a drive on a frame away.",
       {kOfRegion,
        kNumberOf,
        kDriveFrame,
        {"of", kText, false, "torque, frequency or strength; not given: all"}},
       RemoveDriveKey}};
}

}  // namespace hazumi::edit
