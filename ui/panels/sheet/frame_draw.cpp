// The ruler, what is marked on it, and the playhead.

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/dope_sheet/bar_tools.h"
#include "ui/panels/sheet/drag.h"
#include "ui/panels/sheet/drawing.h"
#include "ui/panels/sheet/popups.h"
#include "ui/panels/text/quantity_text.h"

namespace hazumi::ui {

namespace {

constexpr double kNumberPx = 46.0;    // between numbers, at scale 1
constexpr int kFramesToLookAt = 256;  // in a redraw, for marks of the ground

void Shade(ImDrawList* list, const Rect& tracks, float from, float to, float strength) {
  const float left = std::max(tracks.x, from), right = std::min(tracks.right(), to);
  if (left >= right) return;
  const auto alpha = static_cast<int>(255.0f * strength);
  list->AddRectFilled({left, tracks.y}, {right, tracks.bottom()}, IM_COL32(0, 0, 0, alpha));
}

void DrawEvent(ImDrawList* list, const EventMark& mark, float r, ImU32 color) {
  const ImVec2 c = ToIm(mark.at);
  switch (mark.kind) {
    case EventKind::kTakeOff:
      return list->AddTriangleFilled({c.x, c.y - r}, {c.x + r, c.y + r}, {c.x - r, c.y + r}, color);
    case EventKind::kLanding:
      return list->AddTriangleFilled({c.x, c.y + r}, {c.x - r, c.y - r}, {c.x + r, c.y - r}, color);
    case EventKind::kApex:
      return list->AddCircle(c, r, color, 12, 1.5f);
    case EventKind::kTouchDown:
      return list->AddRectFilled({c.x - r, c.y + r - 2.0f}, {c.x + r, c.y + r}, color);
    case EventKind::kLimit:
      return list->AddRectFilled({c.x - 1.0f, c.y - r}, {c.x + 1.0f, c.y + r}, color);
    case EventKind::kPinChange:
    case EventKind::kRelease:
    case EventKind::kBreak:
      return list->AddCircleFilled(c, 0.8f * r, color, 12);
  }
}

// A row of teeth that point down, about as wide as they are high.
void DrawTeeth(ImDrawList* list, const Rect& rect, ImU32 color) {
  const int num = std::max(1, static_cast<int>(rect.w / (1.3f * rect.h)));
  const float step = rect.w / static_cast<float>(num);
  for (int i = 0; i < num; ++i) {
    const float x = rect.x + step * static_cast<float>(i);
    list->AddTriangleFilled({x, rect.y}, {x + step, rect.y}, {x + 0.5f * step, rect.bottom()},
                            color);
  }
}

const char* Describe(EventKind kind) {
  switch (kind) {
    case EventKind::kTakeOff:
      return "Take-off";
    case EventKind::kApex:
      return "Apex";
    case EventKind::kLanding:
      return "Landing";
    case EventKind::kPinChange:
      return "Pin changes";
    case EventKind::kLimit:
      return "Joint hits its limit";
    case EventKind::kRelease:
      return "Object is let go";
    case EventKind::kBreak:
      return "Constraint breaks";
    case EventKind::kTouchDown:
      return "Touches down";
  }
  return "";
}

std::string TextOf(const EventMark& mark) {
  std::string text = Tr(Describe(mark.kind));
  const std::string& name = mark.link.empty() ? mark.joint : mark.link;
  if (!name.empty()) text += "  " + name;
  if (!mark.on.empty()) text += " - " + mark.on;
  text += std::string("\n") + Tr("frame") + " " + FormatShort(mark.frame);
  if (mark.count == 1) return text;
  return text + " - " + FormatShort(mark.last_frame) + "\n" + Tr("times in a row:") + " " +
         std::to_string(mark.count);
}

std::string TextOf(const Sinking& sinking, const Figure& figure) {
  const std::string joint = sinking.joint.is_valid() ? figure.group(sinking.joint).name : "";
  return std::string(Tr("In the ground")) + "  " + joint + "  " +
         FormatShort(std::round(1000.0 * sinking.depth) / 10.0) + " cm\n" + Tr("frames") + " " +
         SpanText(sinking.first, sinking.last) + ", " + Tr("deepest on") + " " +
         std::to_string(sinking.deepest);
}

// The parabola of its centre of mass, a foot at either end.
void DrawFlightMark(ImDrawList* list, const FlightMark& mark, double scale, ImU32 color) {
  const Rect& rect = mark.rect;
  const auto line = static_cast<float>(1.5 * scale), r = static_cast<float>(2.0 * scale);
  const float base = rect.bottom() - r, high = rect.h - r;
  list->PathClear();
  constexpr int kPoints = 24;
  for (int i = 0; i <= kPoints; ++i) {
    const float s = 2.0f * static_cast<float>(i) / kPoints - 1.0f;
    list->PathLineTo({rect.x + 0.5f * (s + 1.0f) * rect.w, base - high * (1.0f - s * s)});
  }
  list->PathStroke(color, 0, line);
  list->AddCircleFilled({rect.x, base}, r, color, 8);
  list->AddCircleFilled({rect.right(), base}, r, color, 8);
}

std::string TextOf(const Flight& flight, const TimeScale& time) {
  const std::string alarm = AlarmText(time);
  char frames[96];
  std::snprintf(frames, sizeof frames, "%.1f – %.1f, %s %.1f", flight.take_off, flight.landing,
                Tr("apex"), flight.apex);
  return std::string(Tr("Flight")) + "  " + FlightText(flight, time.frame_time) + "\n" +
         Tr("frames") + " " + frames + "\n" + (alarm.empty() ? "" : alarm + "\n") +
         Tr("What can be done is in the list of problems.");
}

// Frames in the ground, flights, then what happens, and what is under the mouse of it.
void DrawEvents(ImDrawList* list, Editor* editor, const SheetFrame& frame) {
  edit::Session& session = editor->session();
  editor->flights.Look(&session);
  const Result<const Motion*> motion = session.ShownMotionTo(editor->last_frame());
  if (!motion.ok()) return;
  editor->ground.Look(&session, kFramesToLookAt);
  const std::vector<SinkingMark> sinkings = SinkingMarks(editor->ground.sinkings(), frame);
  for (const SinkingMark& mark : sinkings) {
    DrawTeeth(list, mark.rect, ToIm(colors::kSinking));
  }
  const TimeScale& time = editor->flights.analysis().time;
  if (editor->flights.TakeAlarm()) editor->Say(AlarmText(time));
  const std::vector<FlightMark> flights = FlightMarks(editor->flights.analysis().flights, frame);
  for (const FlightMark& mark : flights) {
    DrawFlightMark(list, mark, frame.scale, ToIm(colors::kChanged));
  }
  const std::vector<EventMark> marks = EventMarks(*motion.value(), frame);
  const auto radius = static_cast<float>(3.5 * frame.scale);
  for (const EventMark& mark : marks) {
    DrawEvent(list, mark, radius, ToIm(colors::kChanged));
  }
  if (editor->has_tool()) return;
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  if (const EventMark* hovered = EventMarkAt(marks, mouse, frame.scale)) {
    ImGui::SetTooltip("%s", TextOf(*hovered).c_str());
  } else if (const SinkingMark* deep = SinkingMarkAt(sinkings, mouse, frame.scale)) {
    ImGui::SetTooltip("%s", TextOf(deep->sinking, session.figure()).c_str());
  } else if (const FlightMark* flight = FlightMarkAt(flights, mouse, frame.scale)) {
    ImGui::SetTooltip("%s", TextOf(flight->flight, time).c_str());
  }
}

void DrawMarkers(ImDrawList* list, const Editor& editor, const SheetFrame& frame) {
  const Theme& theme = editor.theme();
  if (frame.markers.h <= 0.0f) return;
  list->AddRectFilled(UpperLeft(frame.markers), LowerRight(frame.markers), ToIm(theme.window));
  const auto s = static_cast<float>(frame.scale);
  for (const ProjectMarker& marker : editor.session().project().markers) {
    const bool is_now = marker.frame == editor.session().frame();
    const ImU32 color = ToIm(is_now ? colors::kSelected : theme.text);
    const ImVec2 c = {frame.axis.XOf(marker.frame), frame.markers.y + 0.5f * frame.markers.h};
    list->AddTriangleFilled({c.x, c.y - 4.5f * s}, {c.x + 4.5f * s, c.y + 4.0f * s},
                            {c.x - 4.5f * s, c.y + 4.0f * s}, color);
    DrawLabel(list, MarkerName(marker, frame), marker.name, color);
  }
}

void DrawPlayhead(ImDrawList* list, const Editor& editor, const SheetFrame& frame) {
  const Theme& theme = editor.theme();
  const double now = editor.session().frame();
  const float x = std::round(frame.axis.XOf(now));
  const auto s = static_cast<float>(frame.scale);
  list->PushClipRect({frame.ruler.x, frame.ruler.y}, LowerRight(frame.rect), true);
  list->AddLine({x + 0.5f, frame.ruler.bottom()}, {x + 0.5f, frame.rect.bottom()},
                ToIm(theme.playhead), std::max(1.0f, std::round(1.5f * s)));
  const std::string text = FormatShort(now);
  const float half = 0.5f * ImGui::CalcTextSize(text.c_str()).x + 5.0f * s;
  const Rect box = {x - half, frame.ruler.y + 2.0f * s, 2.0f * half, 18.0f * s};
  list->AddRectFilled(UpperLeft(box), LowerRight(box), ToIm(theme.playhead), 3.0f * s);
  DrawLabel(list, {box.x + 5.0f * s, box.y, box.w, box.h}, text, IM_COL32_WHITE);
  list->PopClipRect();
}

void DrawNumbers(ImDrawList* list, const Editor& editor, const SheetFrame& frame) {
  const Theme& theme = editor.theme();
  for (const Tick& tick : FrameTicks(frame.axis, kNumberPx * frame.scale)) {
    const float x = std::round(frame.axis.XOf(tick.value)) + 0.5f;
    const float high = static_cast<float>((tick.is_major ? 6.0 : 3.0) * frame.scale);
    list->AddLine({x, frame.ruler.bottom() - high}, {x, frame.ruler.bottom()},
                  ToIm(theme.faint_text, 0.7f));
    if (!tick.is_major) continue;
    const std::string text = std::to_string(std::lround(tick.value));
    const float half = 0.5f * ImGui::CalcTextSize(text.c_str()).x;
    list->AddText({std::round(x - half), frame.ruler.y + static_cast<float>(2.0 * frame.scale)},
                  ToIm(theme.faint_text), text.c_str());
  }
}

}  // namespace

void DrawTimeGrid(ImDrawList* list, const Editor& editor, const SheetFrame& frame) {
  const Project& project = editor.session().project();
  const Theme& theme = editor.theme();
  const Rect& tracks = frame.tracks;
  list->PushClipRect(UpperLeft(tracks), LowerRight(tracks), true);
  for (const Tick& tick : FrameTicks(frame.axis, kNumberPx * frame.scale)) {
    const float x = std::round(frame.axis.XOf(tick.value)) + 0.5f;
    list->AddLine({x, tracks.y}, {x, tracks.bottom()},
                  ToIm(theme.line, tick.is_major ? 0.55f : 0.22f));
  }
  const ProjectFrames& all = project.frames;
  Shade(list, tracks, tracks.x, frame.axis.XOf(all.first), 0.28f);
  Shade(list, tracks, frame.axis.XOf(all.last), tracks.right(), 0.28f);
  if (project.preview) {
    const float first = frame.axis.XOf(project.preview->first);
    const float last = frame.axis.XOf(project.preview->last);
    Shade(list, tracks, frame.axis.XOf(all.first), first, 0.16f);
    Shade(list, tracks, last, frame.axis.XOf(all.last), 0.16f);
    for (const float x : {first, last}) {
      list->AddLine({x, tracks.y}, {x, tracks.bottom()}, ToIm(colors::kChanged, 0.8f));
    }
  }
  list->PopClipRect();
}

void DrawRuler(ImDrawList* list, Editor* editor, const SheetFrame& frame) {
  const Rect& ruler = frame.ruler;
  list->AddRectFilled(UpperLeft(ruler), LowerRight(ruler), ToIm(editor->theme().header));
  list->PushClipRect(UpperLeft(ruler), {ruler.right(), frame.tracks.y}, true);
  DrawNumbers(list, *editor, frame);
  if (const auto& preview = editor->session().project().preview) {
    const float y = ruler.bottom() - 2.0f;
    list->AddRectFilled({frame.axis.XOf(preview->first), y},
                        {frame.axis.XOf(preview->last), ruler.bottom()}, ToIm(colors::kChanged));
  }
  DrawEvents(list, editor, frame);
  DrawMarkers(list, *editor, frame);
  list->PopClipRect();
  DrawSoundRow(list, editor, frame);
  DrawPlayhead(list, *editor, frame);
}

void NavigateTime(Editor* editor, const SheetFrame& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  SheetState& sheet = editor->sheet;
  TimeAxis axis = frame.axis;
  const bool drags = ImGui::IsMouseDragging(ImGuiMouseButton_Middle, 0.0f);
  if (io.MouseWheel != 0.0f && io.KeyCtrl) {
    axis = Zoomed(axis, io.MousePos.x, std::pow(1.2, io.MouseWheel));
  }
  if (drags && io.KeyCtrl) {
    axis = Zoomed(axis, io.MouseClickedPos[ImGuiMouseButton_Middle].x,
                  std::exp(0.006 * io.MouseDelta.x));
  } else if (drags) {
    const double by = io.MouseDelta.x / axis.px_per_frame();
    axis.first -= by;
    axis.last -= by;
  }
  sheet.first = axis.first;
  sheet.last = axis.last;
}

bool ClickRuler(Editor* editor, const SheetFrame& frame, Point mouse) {
  if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return false;
  const int marker = MarkerUnder(*editor, frame, mouse);
  if (marker >= 0 && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    OpenMarker(editor, marker);
  } else if (marker >= 0) {
    editor->Take(MakeMoveMarker(editor, mouse, marker));
  } else if (frame.ruler.Contains(mouse) || frame.markers.Contains(mouse) ||
             frame.sound.Contains(mouse)) {
    editor->Take(MakeScrub(editor, mouse));
  } else {
    return false;
  }
  return true;
}

void RightClickSheet(Editor* editor, const SheetFrame& frame, Point mouse) {
  const int marker = MarkerUnder(*editor, frame, mouse);
  if (marker >= 0) return OpenMarker(editor, marker);
  if (frame.tracks.Contains(mouse)) editor->sheet.popup = SheetPopup::kKeys;
}

}  // namespace hazumi::ui
