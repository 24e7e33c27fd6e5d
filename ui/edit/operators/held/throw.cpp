// Throws of held objects that are made (MakeThrow) and aimed (AimThrow).

#include "engine/makers/throws/throws.h"
#include "engine/project/enum_names.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

Result<makers::ThrowTarget> TargetOf(const Session& session, const Parameters& p) {
  std::vector<ProjectHeldObject> objects = session.project().held_objects;
  const Result<ProjectHeldObject*> object = EntryNamed(p.text("object"), "object", &objects);
  if (!object.ok()) return object.error();
  makers::ThrowTarget target;
  target.object = static_cast<int>(object.value() - objects.data());
  target.spot = {p.number("x"), p.number("y"), p.number("z")};
  target.height = p.maybe_number("height");
  if (!p.has("style")) return target;
  for (const auto& style : EnumNames<ThrowStyle>::kNames) {
    if (p.text("style") == style.name) target.style = style.value;
  }
  if (target.style) return target;
  return Refusal("style",
                 "no style \"" + p.text("style") + "\"; expected one of: " + WordsOf<ThrowStyle>());
}

void Tell(const makers::ThrowReport& report, Session* session) {
  session->Measured("release_frame", report.release);
  session->Measured("down_frame", report.down);
  session->Measured("speed_m_s", report.velocity.norm());
  session->Measured("muscle", report.muscle);
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
      {"style", kText, false,
       "not given: as the throw that is there, else as the arm is drawn back, else underarm",
       WordsOf<ThrowStyle>()},
      kDrag};
  return {
      {"held.throw_onto", "Throw onto",
       "Aims a throw: finds the swing of the arm with which the object comes down on a spot, "
       "where it lies then; once it has let go the dynamics region moves the arm. Not given how "
       "high: as slowly as it gets there past what stands in between.",
       parameters, ThrowOnto},
      {"throw.add", "Add throw",
       "Makes a throw of what a hand holds in the current frame onto a spot: the arm is drawn "
       "back, if it is not yet, and swings by keys; once it has let go a dynamics region moves "
       "it. Not given how high: as slowly as it gets there past what stands in between. A "
       "figure that only stands is turned to the spot.",
       parameters, AddThrow}};
}

}  // namespace hazumi::edit
