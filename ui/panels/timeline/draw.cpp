// The row of buttons and fields between the viewport and the sheets.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "engine/base/filled.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/timeline/layout.h"
#include "ui/panels/window/panels.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

enum class Icon { kToFirst, kPreviousKey, kPlay, kPause, kNextKey, kToLast };

// `s`: half the icon's height [px]; `d`: 1 to the right, -1 to the left.
void Triangle(ImDrawList* list, ImVec2 c, float s, float d, ImU32 color) {
  const ImVec2 tip = {c.x + d * s, c.y}, up = {c.x - 0.6f * d * s, c.y - s};
  const ImVec2 down = {c.x - 0.6f * d * s, c.y + s};
  d > 0.0f ? list->AddTriangleFilled(up, tip, down, color)
           : list->AddTriangleFilled(up, down, tip, color);
}

void Bar(ImDrawList* list, float x, float y, float w, float s, ImU32 color) {
  list->AddRectFilled({x - 0.5f * w, y - s}, {x + 0.5f * w, y + s}, color);
}

void DrawIcon(ImDrawList* list, Icon icon, const Rect& rect, float scale, ImU32 color) {
  const ImVec2 c = {rect.x + 0.5f * rect.w, rect.y + 0.5f * rect.h};
  const float s = 5.5f * scale,
              d = icon == Icon::kToFirst || icon == Icon::kPreviousKey ? -1.0f : 1.0f;
  switch (icon) {
    case Icon::kPlay:
      return Triangle(list, {c.x - 0.1f * s, c.y}, 1.15f * s, 1.0f, color);
    case Icon::kPause:
      Bar(list, c.x - 0.6f * s, c.y, 0.6f * s, s, color);
      return Bar(list, c.x + 0.6f * s, c.y, 0.6f * s, s, color);
    case Icon::kToFirst:
    case Icon::kToLast:
      Triangle(list, {c.x - 0.2f * d * s, c.y}, s, d, color);
      return Bar(list, c.x + 1.1f * d * s, c.y, 0.4f * s, s, color);
    case Icon::kPreviousKey:
    case Icon::kNextKey: {
      Triangle(list, {c.x - 0.5f * d * s, c.y}, 0.8f * s, d, color);
      const float x = c.x + 0.95f * d * s, r = 0.65f * s;
      return list->AddQuadFilled({x, c.y - r}, {x + r, c.y}, {x, c.y + r}, {x - r, c.y}, color);
    }
  }
}

void Button(Editor* editor, const Rect& rect, Icon icon, const char* id, const Json& parameters,
            const char* text) {
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::PushID(static_cast<int>(icon == Icon::kPause ? Icon::kPlay : icon));
  if (ImGui::InvisibleButton("##button", {rect.w, rect.h})) editor->Do(id, parameters);
  const Theme& theme = editor->theme();
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    list->AddRectFilled({rect.x + 1.0f, rect.y}, {rect.right() - 1.0f, rect.bottom()},
                        ToIm(ImGui::IsItemActive() ? theme.accent : theme.field), 4.0f);
  }
  DrawIcon(list, icon, rect, static_cast<float>(editor->settings.scale), ToIm(theme.text));
  Tooltip(Tr(text), KeyOf(id, parameters));
  ImGui::PopID();
}

void SheetChoice(Editor* editor, const Rect& rect) {
  const char* names[] = {Tr("Dope sheet"), Tr("Graph editor")};
  int now = editor->sheet.kind == SheetKind::kGraph ? 1 : 0;
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::SetNextItemWidth(rect.w);
  if (ImGui::Combo("##sheet", &now, names, 2)) {
    editor->Do("view.sheet", {{"graph", now == 1}});
  }
  Tooltip(HelpOf("view.sheet"), KeyOf("view.sheet"));
}

// A whole number that is dragged, or typed after a click. True when it was changed, at the
// end of a drag if `at_end`.
bool Number(const char* id, const Rect& rect, const std::string& format, int* value, bool at_end) {
  if (rect.w <= 0.0f) return false;
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::SetNextItemWidth(rect.w);
  const bool is_changed = ImGui::DragInt(id, value, 0.2f, 0, 0, format.c_str());
  return at_end ? ImGui::IsItemDeactivatedAfterEdit() : is_changed;
}

void FrameField(Editor* editor, const Rect& rect) {
  int frame = static_cast<int>(std::lround(editor->session().frame()));
  if (Number("##frame", rect, "%d", &frame, false)) {
    editor->playback.Stop();
    const ProjectFrames& all = editor->session().project().frames;
    const int shown = std::clamp(frame, all.first, all.last);
    editor->Do("time.frame", {{"frame", shown}});
    const bool is_typed = !ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (is_typed) {
      editor->Say(shown == frame ? ""
                                 : Filled(Tr("Frame %d is outside of the animation, %d to %d."),
                                          frame, all.first, all.last));
    }
  }
  if (rect.w > 0.0f) Tooltip(Tr("Current frame: drag, or click and type"));
}

// ImGui keeps what is dragged only while it is: the document takes it at the end, as one step.
void RangeField(Editor* editor, const Rect& rect, const char* name, const char* label) {
  if (rect.w <= 0.0f) return;
  const ProjectFrames& frames = editor->session().project().frames;
  SheetState::EditedRange& edited = editor->sheet.edited_range;
  const bool is_first = std::string(name) == "first";
  const bool is_edited = edited.frame && edited.is_first == is_first;
  int value = is_edited ? *edited.frame : is_first ? frames.first : frames.last;
  const bool is_done = Number((std::string("##") + name).c_str(), rect,
                              std::string(Tr(label)) + " %d", &value, true);
  if (ImGui::IsItemActive()) {
    edited = {value, is_first};
  } else if (is_edited) {
    edited.frame.reset();
  }
  if (is_done) editor->Do("time.range", {{name, value}});
  Tooltip(Tr(is_first ? "First frame of the animation" : "Last frame of the animation"));
}

std::string RateText(int num, int den) {
  if (den == 1) return std::to_string(num) + " fps";
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.2f fps", static_cast<double>(num) / den);
  return text.data();
}

void RateField(Editor* editor, const Rect& rect) {
  if (rect.w <= 0.0f) return;
  constexpr std::pair<int, int> kRates[] = {{24000, 1001}, {24, 1},  {25, 1}, {30000, 1001},
                                            {30, 1},       {48, 1},  {50, 1}, {60000, 1001},
                                            {60, 1},       {100, 1}, {120, 1}};
  const ProjectRate now = editor->session().project().fps;
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::SetNextItemWidth(rect.w);
  if (ImGui::BeginCombo("##fps", RateText(now.num, now.den).c_str())) {
    for (const auto& [num, den] : kRates) {
      const bool is_now = num == now.num && den == now.den;
      if (ImGui::Selectable(RateText(num, den).c_str(), is_now) && !is_now) {
        editor->Do("time.rate", {{"num", num}, {"den", den}});
      }
    }
    ImGui::EndCombo();
  }
  Tooltip(HelpOf("time.rate"));
}

// How fast it really plays, and what was passed over.
void ShownRate(Editor* editor, const Rect& rect) {
  const Playback& playback = editor->playback;
  if (!playback.is_on() || playback.shown_rate() <= 0.0) return;
  std::array<char, 96> text;
  if (playback.dropped() > 0) {
    std::snprintf(text.data(), text.size(), "%.1f fps  %s %d", playback.shown_rate(), Tr("dropped"),
                  playback.dropped());
  } else {
    std::snprintf(text.data(), text.size(), "%.1f fps", playback.shown_rate());
  }
  if (ImGui::CalcTextSize(text.data()).x > rect.w) {
    std::snprintf(text.data(), text.size(), "-%d", playback.dropped());
  }
  const ImVec2 size = ImGui::CalcTextSize(text.data());
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect({rect.x, rect.y}, {rect.right(), rect.bottom()}, true);
  list->AddText({rect.x, std::round(rect.y + 0.5f * (rect.h - size.y))},
                playback.dropped() > 0 ? ToIm(colors::kChanged) : ToIm(editor->theme().faint_text),
                text.data());
  list->PopClipRect();
}

}  // namespace

void DrawTimeline(Editor* editor, const Rect& rect) {
  if (editor->playback.is_on()) {
    editor->playback.CountFrame(editor->now(),
                                static_cast<int>(std::lround(editor->session().frame())));
  }
  BeginPanel("##timeline", rect, editor->theme().header);
  const TimelineLayout layout = LayOutTimeline(rect, editor->settings.scale);
  SheetChoice(editor, layout.sheet);
  const bool plays = editor->playback.is_on();
  Button(editor, layout.to_first, Icon::kToFirst, "time.to_end", {{"last", false}},
         "To the first frame");
  Button(editor, layout.previous_key, Icon::kPreviousKey, "time.to_key", {{"next", false}},
         "To the previous key");
  Button(editor, layout.play, plays ? Icon::kPause : Icon::kPlay, "time.play", Json::object(),
         "Play or stop");
  Button(editor, layout.next_key, Icon::kNextKey, "time.to_key", {{"next", true}},
         "To the next key");
  Button(editor, layout.to_last, Icon::kToLast, "time.to_end", {{"last", true}},
         "To the last frame");
  ShownRate(editor, layout.rate);
  FrameField(editor, layout.frame);
  RangeField(editor, layout.first, "first", "First");
  RangeField(editor, layout.last, "last", "Last");
  RateField(editor, layout.fps);
  EndPanel();
}

}  // namespace hazumi::ui
