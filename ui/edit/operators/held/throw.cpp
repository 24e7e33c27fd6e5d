// Throws of held objects that are made (MakeThrow) and aimed (AimThrow).

#include "engine/makers/throws/throws.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

Result<makers::ThrowTarget> TargetOf(const Session& session, const Parameters& p) {
  std::vector<ProjectHeldObject> objects = session.project().held_objects;
  const Result<ProjectHeldObject*> object = EntryNamed(p.text("object"), "object", &objects);
  if (!object.ok()) return object.error();
  return makers::ThrowTarget{static_cast<int>(object.value() - objects.data()),
                             Vec3(p.number("x"), p.number("y"), p.number("z")),
                             p.maybe_number("height")};
}

void Tell(const makers::ThrowReport& report, Session* session) {
  session->Measured("release_frame", report.release);
  session->Measured("down_frame", report.down);
  session->Measured("speed_m_s", report.velocity.norm());
  session->Measured("limit_hits", static_cast<double>(report.limit_hits));
}

Result<Done> AddThrow(Session* session, const Parameters& p) {
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!now.ok()) return now.error();
  const Result<makers::ThrowTarget> target = TargetOf(*session, p);
  if (!target.ok()) return target.error();
  Result<makers::MadeThrow> made =
      makers::MakeThrow(target.value(), *now.value(), *session->animation(), session->project());
  if (!made.ok()) return made.error();
  Tell(made.value().report, session);
  return Put(session, "Add throw", std::move(made.value().project), p.text("drag"));
}

Result<Done> ThrowOnto(Session* session, const Parameters& p) {
  const Result<makers::ThrowTarget> target = TargetOf(*session, p);
  if (!target.ok()) return target.error();
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return motion.error();
  Result<makers::MadeThrow> made = makers::AimThrow(
      target.value(), session->frame(), *session->animation(), *motion.value(), session->project());
  if (!made.ok()) return made.error();
  Tell(made.value().report, session);
  return Put(session, "Throw onto", std::move(made.value().project), p.text("drag"));
}

}  // namespace

std::vector<Operator> ThrowOperators() {
  const std::vector<ParameterInfo> parameters = {
      {"object", kText, true, "the held object's name", Thing::kHeldObject},
      {"x", kNumber, true, "the spot, metres"},
      {"y", kNumber, true, "the spot, metres"},
      {"z", kNumber, false, "the spot, metres; not given: 0"},
      {"height", kNumber, false, "how far it rises above the hand, metres"},
      kDrag};
  return {{"held.throw_onto", "Throw onto",
           "Aims a throw: the dynamics region that moves the arm as it lets go starts as fast as "
           "it has to for the object to come down on a spot, where it lies then. Not given how "
           "high: as slowly as it gets there past what stands in between.",
           parameters, ThrowOnto},
          {"throw.add", "Add throw",
           "Makes a throw of what a hand holds in the current frame onto a spot: the arm swings "
           "back, a dynamics region lets it swing forward and let go. Not given how high: as "
           "slowly as it gets there past what stands in between. A figure that only stands is "
           "turned to the spot.",
           parameters, AddThrow}};
}

}  // namespace hazumi::edit
