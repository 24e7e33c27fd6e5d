// Flights that keys have are given to gravity.

#include "engine/makers/flights/flights.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

Result<Done> Fly(Session* session, const Parameters& p) {
  const Result<const Motion*> motion = session->WholeMotion();
  if (!motion.ok()) return motion.error();
  Result<makers::MadeFlight> made =
      makers::MakeFlight({p.integer("first"), p.integer("last")}, session->project(),
                         *session->animation(), *motion.value());
  if (!made.ok()) return made.error();
  session->Measured("gravity_from_frame", made.value().report.by_gravity);
  session->Measured("root_speed_m_s", made.value().report.root_velocity.norm());
  return Put(session, "Place flight by gravity", std::move(made.value().project));
}

}  // namespace

std::vector<Operator> FlightOperators() {
  return {{"placement.flight",
           "Place flight by gravity",
           "Gives a flight that keys have to gravity: it takes off so fast that it lands where the "
           "keys have it.",
           {{"first", kInteger, true, "first frame in the air, or the last on which it stands"},
            {"last", kInteger, true, "last frame in the air, or the first on which it stands"}},
           Fly}};
}

}  // namespace hazumi::edit
