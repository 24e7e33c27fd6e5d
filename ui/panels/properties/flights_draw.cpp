// Flights that were found in the motion: how they fly, and what can be done about it.

#include <cmath>
#include <cstdio>

#include "engine/base/text.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/properties/fields.h"
#include "ui/panels/properties/sections.h"
#include "ui/panels/text/quantity_text.h"

namespace hazumi::ui {

namespace {

void DrawAlarm(Editor* editor, const TimeScale& time) {
  const std::string alarm = AlarmText(time), repair = RepairText(time);
  if (const std::string undecided = UndecidedText(time); !undecided.empty()) {
    ImGui::TextWrapped("%s", undecided.c_str());
  }
  if (alarm.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, ToIm4(colors::kChanged));
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(alarm.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  if (repair.empty()) return;
  if (DrawButton(repair.c_str(), Tr("Keys stay on their frames; the motion gets as fast as gravity "
                                    "says that it was."))) {
    editor->Do("time.rate", {{"num", *time.frame_rate}, {"den", 1}, {"keep_shape", true}});
    editor->Say("");  // what was said of it is no longer so
  }
}

// A copy: the button changes the motion.
void DrawFlight(Editor* editor, const Flight flight, double frame_time) {
  const int first = FirstFrameOf(flight), last = LastFrameOf(flight);
  ImGui::PushID(first);
  char frames[64];
  std::snprintf(frames, sizeof frames, "%.1f – %.1f", flight.take_off, flight.landing);
  DrawFact(editor, frames, FlightText(flight, frame_time));
  if (DrawButton(LabelOf("placement.flight"), HelpOf("placement.flight"))) {
    editor->Do("placement.flight", {{"first", first}, {"last", last}});
  }
  ImGui::PopID();
}

void DrawSkate(Editor* editor, const FootSkate& skate) {
  if (skate.frames == 0) return;
  char text[96];
  std::snprintf(text, sizeof text, Tr("%.2f m in %.2f s on the ground"), skate.distance,
                skate.time_low);
  DrawFact(editor, skate.foot, text);
}

}  // namespace

void DrawFlights(Editor* editor) {
  const FlightAnalysis analysis = editor->flights.analysis();
  if (!analysis.flights.empty() && DrawHeading(Tr("Flights"))) {
    DrawAlarm(editor, analysis.time);
    for (const Flight& flight : analysis.flights) {
      DrawFlight(editor, flight, analysis.time.frame_time);
    }
  }
  if (!analysis.skates.empty() && DrawHeading(Tr("Feet that slide"), false)) {
    for (const FootSkate& skate : analysis.skates) DrawSkate(editor, skate);
  }
}

}  // namespace hazumi::ui
