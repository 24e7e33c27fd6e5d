// Who holds an object: hands pass it on and let go; nobody's are moved by keys.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/project/edits/holders.h"
#include "engine/spatial/euler_angles.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/objects.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kFrame = {"frame", kInteger, false, "not given: the current one"};
const ParameterInfo kOfHolders = {"number", kInteger, true, "of its later holders, from 0"};

int FrameOf(const Session& session, const Parameters& p) {
  return p.integer("frame", static_cast<int>(std::lround(session.frame())));
}

// How it lies in the hand of that holder, angles z, y, x [deg].
Vec3& RotationOf(int number, ProjectHeldObject* object) {
  return number < 0 ? object->rotation_deg : object->holders[number].rotation_deg;
}

// As given; else as in the hand that had it last.
Vec3 RotationOfNext(const Parameters& p, int frame, const std::vector<HolderSpan>& spans,
                    ProjectHeldObject* object) {
  Vec3 rotation = Vec3::Zero();
  for (const HolderSpan& span : spans) {
    if (span.first <= frame) rotation = RotationOf(span.number, object);
  }
  constexpr const char* kAngles[] = {"angle_z", "angle_y", "angle_x"};
  for (int i = 0; i < 3; ++i) rotation[i] = p.number(kAngles[i], rotation[i]);
  return rotation;
}

// Who has it then lets go, and when it would have done so the new one does.
Result<Done> Pass(Session* session, const Parameters& p) {
  const Result<GroupIndex> joint = HolderGiven(*session, p);
  if (!joint.ok()) return joint.error();
  const int frame = FrameOf(*session, p);
  return ChangeHeld(session, p, "Pass on", [&](ProjectHeldObject* object) -> Result<Done> {
    ProjectHolder next;
    next.joint = session->figure().group(joint.value()).name;
    const std::vector<HolderSpan> spans = HoldersOf(*object, session->project().frames);
    next.rotation_deg = RotationOfNext(p, frame, spans, object);
    next.offset_m = p.has("offset_x") || p.has("offset_y") || p.has("offset_z")
                        ? Vec3(p.number("offset_x"), p.number("offset_y"), p.number("offset_z"))
                        : InThePalm(session->figure(), joint.value(), *object, next.rotation_deg);
    next.first_frame = frame;
    const HolderSpan* now = HolderAt(frame, spans);
    if (now && now->first == frame) {
      return Refusal("frame", "\"" + now->joint + "\" has it from frame " + std::to_string(frame) +
                                  " on; choose a later frame, or set that holder's joint");
    }
    if (now) {
      next.last_frame = std::exchange(EndOf(now->number, object), frame);
    } else {
      const auto later = std::find_if(spans.begin(), spans.end(),
                                      [&](const HolderSpan& span) { return span.first > frame; });
      if (later != spans.end()) next.last_frame = later->first;
    }
    const auto place = std::find_if(object->holders.begin(), object->holders.end(),
                                    [&](const ProjectHolder& h) { return h.first_frame > frame; });
    object->holders.insert(place, std::move(next));
    return Done();
  });
}

Result<Done> LetGo(Session* session, const Parameters& p) {
  const int frame = FrameOf(*session, p);
  return ChangeHeld(session, p, "Let go", [&](ProjectHeldObject* object) -> Result<Done> {
    const auto spans = HoldersOf(*object, session->project().frames);
    const HolderSpan* now = HolderAt(frame, spans);
    if (!now) {
      return Refusal("frame",
                     "nobody has \"" + object->name + "\" in frame " + std::to_string(frame));
    }
    EndOf(now->number, object) = frame;
    return Done();
  });
}

// Those before and after it give way where they touch it or would be in its way.
Result<Done> SetFrames(Session* session, const Parameters& p) {
  return ChangeHeld(session, p, "Change holder", [&](ProjectHeldObject* object) -> Result<Done> {
    const std::vector<HolderSpan> spans = HoldersOf(*object, session->project().frames);
    const int number = p.integer("number");
    const auto span = std::find_if(spans.begin(), spans.end(),
                                   [&](const HolderSpan& each) { return each.number == number; });
    if (span == spans.end()) return Refusal("number", "there is no such holder");
    const int first = number < 0 ? span->first : p.integer("first", span->first);
    const int last = p.integer("release", span->last);
    if (span != spans.begin()) {
      const HolderSpan& before = *std::prev(span);
      if (before.is_let_go && (before.last == span->first || before.last > first)) {
        EndOf(before.number, object) = first;
      }
    }
    if (const auto next = std::next(span); next != spans.end()) {
      if (next->first == span->last || next->first < last) {
        object->holders[next->number].first_frame = last;
      }
    }
    if (number >= 0) object->holders[number].first_frame = first;
    if (span->is_let_go || last != span->last) EndOf(number, object) = last;
    return Done();
  });
}

template <typename Action>
Result<Done> ChangeHolder(Session* session, const Parameters& p, const char* label, Action action) {
  return ChangeHeld(session, p, label, [&](ProjectHeldObject* object) -> Result<Done> {
    const int number = p.integer("number"), count = static_cast<int>(object->holders.size());
    if (number < 0 || number >= count) {
      return Refusal("number", "\"" + object->name + "\" has " + std::to_string(count) +
                                   " later holders, counted from 0");
    }
    return action(object, number);
  });
}

Result<Done> SetHolder(Session* session, const Parameters& p) {
  return ChangeHolder(session, p, "Change holder", [&](ProjectHeldObject* object, int number) {
    ProjectHolder& holder = object->holders[number];
    if (p.yes("never")) holder.last_frame.reset();
    return SetFields(p, &holder);
  });
}

Result<Done> RemoveHolder(Session* session, const Parameters& p) {
  return ChangeHolder(session, p, "Remove holder", [](ProjectHeldObject* object, int number) {
    object->holders.erase(object->holders.begin() + number);
    return Result<Done>(Done());
  });
}

// Where objects are in the current frame: by index of the project's.
Result<std::vector<ObjectPose>> PosesNow(Session* session) {
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!now.ok()) return now.error();
  return now.value()->objects;
}

size_t IndexOf(const ProjectHeldObject* object, const Project& project) {
  return static_cast<size_t>(object - project.held_objects.data());
}

// What is not given is as it is there now.
Result<Done> KeyPosition(Session* session, const Parameters& p) {
  const auto poses = PosesNow(session);
  const bool is_given = p.has("x") && p.has("y") && p.has("z");
  if (!poses.ok() && !is_given) return poses.error();
  return session->Edit(
      "Key position",
      [&](Project* project) -> Result<Done> {
        const auto object = EntryNamed(p.text("object"), "object", &project->held_objects);
        if (!object.ok()) return object.error();
        const size_t i = IndexOf(object.value(), *project);
        Vec3 at = poses.ok() && i < poses.value().size() ? poses.value()[i].X_WO.p : Vec3::Zero();
        for (int axis = 0; axis < 3; ++axis) {
          at[axis] = p.number(std::string(1, "xyz"[axis]).c_str(), at[axis]);
        }
        PutPosition(at, session->frame(), object.value());
        return Done();
      },
      p.text("drag"));
}

// Where it is in the current frame, before an edit that is being made of it.
const ObjectPose& PoseBefore(const ProjectHeldObject& object, const Session& session,
                             const MotionFrame& now) {
  const int index = hazumi::IndexOf(object.identity.id, session.project().held_objects);
  return now.objects[static_cast<size_t>(index)];
}

// In a hand its offset; else its place is keyed.
Result<Done> MoveHeld(Session* session, const Parameters& p) {
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!now.ok()) return now.error();
  const Vec3 by(p.number("x"), p.number("y"), p.number("z"));
  const int frame = static_cast<int>(std::lround(session->frame()));
  return ChangeHeld(session, p, "Move held object", [&](ProjectHeldObject* object) -> Result<Done> {
    const ObjectPose& pose = PoseBefore(*object, *session, *now.value());
    const auto spans = HoldersOf(*object, session->project().frames);
    if (const HolderSpan* holder = HolderAt(frame, spans)) {
      Vec3& offset =
          holder->number < 0 ? object->offset_m : object->holders[holder->number].offset_m;
      offset += TurnOf(RotationOf(holder->number, object)) * pose.X_WO.R.transpose() * by;
      for (int axis = 0; axis < 3; ++axis) offset[axis] = WithoutRoundOff(offset[axis]);
      return Done();
    }
    const auto is_over = [&](const HolderSpan& span) { return span.last <= frame; };
    const auto over = std::find_if(spans.rbegin(), spans.rend(), is_over);
    const int let_go = over == spans.rend() ? session->project().frames.first : over->last;
    const auto& keys = object->position.curves[0].keys;
    const bool is_keyed = let_go == session->project().frames.first ||
                          std::any_of(keys.begin(), keys.end(), [&](const ProjectKey& key) {
                            return key.frame >= let_go && key.frame <= frame;
                          });
    if (!is_keyed) {
      return Refusal("object", "\"" + object->name + "\" flies in frame " + std::to_string(frame) +
                                   ": what lets it go moves it; or key its position where it "
                                   "has come down");
    }
    PutPosition(pose.X_WO.p + by, session->frame(), object);
    return Done();
  });
}

// By a vector along an axis of the world: R_BO' = R_BO R_WO^T exp(turn) R_WO.
Result<Done> TurnHeld(Session* session, const Parameters& p) {
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!now.ok()) return now.error();
  const Vec3 turn = kDegree * Vec3(p.number("x"), p.number("y"), p.number("z"));
  const int frame = static_cast<int>(std::lround(session->frame()));
  return ChangeHeld(session, p, "Turn held object", [&](ProjectHeldObject* object) -> Result<Done> {
    const auto spans = HoldersOf(*object, session->project().frames);
    const HolderSpan* holder = HolderAt(frame, spans);
    if (!holder) {
      return Refusal("object", "nobody has \"" + object->name + "\" in frame " +
                                   std::to_string(frame) +
                                   ": it is turned in a hand; go to a frame in which one has it");
    }
    if (turn.isZero(0.0)) return Done();
    const Mat3 R_WO = PoseBefore(*object, *session, *now.value()).X_WO.R;
    const Mat3 about =
        Eigen::AngleAxisd(turn.stableNorm(), turn.stableNormalized()).toRotationMatrix();
    Vec3& angles = RotationOf(holder->number, object);
    const Mat3 R_BO = TurnOf(angles) * R_WO.transpose() * about * R_WO;
    angles = EulerAnglesNear(R_BO, {2, 1, 0}, kDegree * angles) / kDegree;
    for (double& angle : angles) angle = WithoutRoundOff(angle);
    return Done();
  });
}

}  // namespace

std::vector<Operator> HolderOperators() {
  const ParameterInfo object = {"object", kText, true, "the held object's name",
                                Thing::kHeldObject};
  const std::vector<ParameterInfo> position = {{"x", kNumber, false, "metres"},
                                               {"y", kNumber, false, "metres"},
                                               {"z", kNumber, false, "metres"}};
  const ParameterInfos fields = FieldsOf<ProjectHolder>();
  return {
      {"held.pass", "Pass on",
       "From this frame on another joint holds it: the one that is selected, if none is given.",
       Joined({{object, kFrame},
               Only({"joint", "offset_x", "offset_y", "offset_z", "angle_z", "angle_y", "angle_x"},
                    fields)}),
       Pass},
      {"held.let_go", "Let go", "Whoever holds it lets go.", {object, kFrame, kDrag}, LetGo},
      {"held.set_holder", "Change holder", "Sets what is given of a later holder.",
       Joined({{object, kOfHolders},
               fields,
               {{"never", kYesNo, false, "true: it is never let go"}, kDrag}}),
       SetHolder},
      {"held.set_frames",
       "Change frames of holder",
       "From when until when a holder has it; those before and after give way.",
       {object,
        {"number", kInteger, true, "of its later holders, from 0; -1: who has it at first"},
        {"first", kInteger, false, "first frame"},
        {"release", kInteger, false, "let go on this frame"},
        kDrag},
       SetFrames},
      {"held.remove_holder",
       "Remove holder",
       "Takes a later holder away.",
       {object, kOfHolders},
       RemoveHolder},
      {"held.key", "Key position", "Keys where it is while nobody holds it, in the current frame.",
       Joined({{object}, position, {kDrag}}), KeyPosition},
      {"held.move", "Move held object",
       "Moves it in the hand that holds it, or keys its position, in the current frame.",
       Joined({{object}, position, {kDrag}}), MoveHeld},
      {"held.turn",
       "Turn held object",
       "Turns it in the hand that holds it, about an axis of the world, in the current frame.",
       {object,
        {"x", kNumber, false, "degrees about the world's x; with the others the axis is between"},
        {"y", kNumber, false, "degrees about the world's y"},
        {"z", kNumber, false, "degrees about the world's z"},
        kDrag},
       TurnHeld}};
}

}  // namespace hazumi::edit
