// Jumps that are made (MakeJump) and aimed (AimJump).

#include "engine/makers/jumps/jumps.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

makers::JumpTarget TargetOf(const Parameters& p) {
  return {p.maybe_number("x"), p.maybe_number("y"), p.maybe_number("height")};
}

void Tell(const makers::JumpReport& report, Session* session) {
  session->Measured("take_off_frame", report.take_off);
  session->Measured("landing_frame", report.landing);
  session->Measured("last_frame", report.last);
  session->Measured("height_m", report.height);
}

Result<Done> AddJump(Session* session, const Parameters& p) {
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!now.ok()) return now.error();
  Result<makers::MadeJump> made =
      makers::MakeJump(TargetOf(p), *now.value(), *session->animation(), session->project());
  if (!made.ok()) return made.error();
  Tell(made.value().report, session);
  return Put(session, "Add jump", std::move(made.value().project), p.text("drag"));
}

Result<Done> AimJump(Session* session, const Parameters& p) {
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return motion.error();
  Result<makers::MadeJump> made = makers::AimJump(
      TargetOf(p), session->frame(), *session->animation(), *motion.value(), session->project());
  if (!made.ok()) return made.error();
  Tell(made.value().report, session);
  return Put(session, "Aim jump", std::move(made.value().project), p.text("drag"));
}

}  // namespace

std::vector<Operator> JumpOperators() {
  const std::vector<ParameterInfo> parameters = {
      {"x", kNumber, false, "where its toes land, metres"},
      {"y", kNumber, false, "where its toes land, metres"},
      {"height", kNumber, false, "how far its centre of mass rises, metres"},
      kDrag};
  return {{"jump.add", "Add jump",
           "Keys a jump from where the figure stands in the current frame onto a spot: crouch, "
           "take-off, apex and landing. Not given: 80 cm ahead, and as high as it has to be.",
           parameters, AddJump},
          {"jump.aim", "Aim jump",
           "Aims the jump of the current frame, a flight by gravity between two pins, at another "
           "spot: its poses stay, earlier or later. Not given: where its keys have it land, and "
           "as high as it has to be.",
           parameters, AimJump}};
}

}  // namespace hazumi::edit
