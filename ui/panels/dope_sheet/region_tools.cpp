#include <algorithm>
#include <cmath>

#include "ui/panels/dope_sheet/bar_tools.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/sheet/drag.h"

namespace hazumi::ui {

namespace {

int FrameUnder(const Editor& editor, Point mouse) {
  return static_cast<int>(std::lround(SheetAxis(editor).FrameAt(mouse.x)));
}

class ScrubTool : public SheetDrag {
 public:
  ScrubTool(Editor* editor, Point start)
      : SheetDrag(editor, start, true), frame_before_(editor->session().frame()) {
    editor->playback.Stop();
    GoTo(editor, start);
  }
  std::string hint() const override { return Tr("Scrub   Esc: back to where it was"); }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override { GoTo(editor, input.mouse); }
  void Finish(Editor*) override {}
  void Cancel(Editor* editor) override { editor->Do("time.frame", {{"frame", frame_before_}}); }

 private:
  static void GoTo(Editor* editor, Point mouse) {
    const ProjectFrames& all = editor->session().project().frames;
    const int frame = std::clamp(FrameUnder(*editor, mouse), all.first, all.last);
    if (frame != editor->session().frame()) editor->Do("time.frame", {{"frame", frame}});
  }
  double frame_before_;
};

class PaintRegionTool : public SheetDrag {
 public:
  PaintRegionTool(Editor* editor, Point start, bool by_button)
      : SheetDrag(editor, start, by_button),
        is_held_(by_button),
        touches_(TouchesWhenMade(editor->session().project())) {
    const edit::Session& session = editor->session();
    if (session.selected_joints().empty()) return;
    const ProjectFrames frames = FramesToMark(session);
    marks_ = SpanText(frames.first, frames.last);
  }

  std::string hint() const override {
    std::string text = Tr("Dynamics region: drag over rows and frames");
    if (!painted_.empty()) text += "  " + painted_;
    if (!is_held_ && !marks_.empty()) {
      text += std::string("   ") + Tr("Enter: the selected joints, frames") + " " + marks_;
    }
    return text + "   " + (trouble_.empty() ? Tr("Esc: cancel") : "! " + trouble_);
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    has_clicked_ = input.is_pressed;
    where_ = input.mouse;
    if (!is_held_) return;
    const DopeSheetLayout layout = LayOutDopeSheet(editor->session(), editor->sheet,
                                                   editor->sheet.rect, editor->settings.scale);
    SheetState::Paint paint;
    paint.first_row = NearestRow(layout, std::min(start().y, where_.y));
    paint.last_row = NearestRow(layout, std::max(start().y, where_.y));
    const ProjectFrames& all = editor->session().project().frames;
    const int a = std::clamp(FrameUnder(*editor, start()), all.first, all.last);
    const int b = std::clamp(FrameUnder(*editor, where_), all.first, all.last);
    paint.first_frame = std::min(a, b);
    paint.last_frame = std::max(a, b);
    painted_ = SpanText(paint.first_frame, paint.last_frame);
    Show(editor, paint, Painted(editor->session(), layout, paint));
    // As soon as the region is there its own bar shows it.
    editor->sheet.paint.reset();
    if (!is_there_) editor->sheet.paint = paint;
  }

  void Finish(Editor* editor) override {
    if (!is_held_ && has_clicked_) {
      return editor->Take(std::make_unique<PaintRegionTool>(editor, where_, true));
    }
    editor->sheet.paint.reset();
    if (!is_held_) return MarkSelected(editor);
    SheetDrag::Finish(editor);
    if (is_there_) return;
    if (!trouble_.empty()) return editor->Say(trouble_, true);
    editor->Say(Tr("No region: drag over the rows of limbs and at least one frame"));
  }

  void Cancel(Editor* editor) override {
    editor->sheet.paint.reset();
    SheetDrag::Cancel(editor);
  }

 private:
  // Region of the painted rows. The method "paper" does not move the root.
  static RegionOnRows Painted(const edit::Session& session, const DopeSheetLayout& layout,
                              const SheetState::Paint& paint) {
    RegionOnRows on = RegionOn(layout, paint.first_row, paint.last_row);
    if (session.project().solver.method != Method::kExact) return on;
    return WithRootOfWhole(std::move(on), session.figure());
  }

  // While it is painted the region is there already, and what it moves swings.
  void Show(Editor* editor, const SheetState::Paint& paint, const RegionOnRows& on) {
    const bool is_one = paint.first_frame < paint.last_frame && !on.joints.empty();
    const Json region =
        !is_one
            ? Json()
            : Json{{"name", on.name},     {"first", paint.first_frame}, {"last", paint.last_frame},
                   {"joints", on.joints}, {"key_start", true},          {"contacts", touches_},
                   {"drag", drag()}};
    if (region == shown_) return;
    shown_ = region;
    const bool was_there = is_there_;
    const Result<Done> added = is_one ? editor->Invoke("region.add", region) : Done();
    trouble_ = added.ok() ? "" : added.error().ToString();
    is_there_ = is_one && added.ok();
    if (is_there_) ChooseLast(editor);
    if (was_there && !is_there_) editor->Do("edit.cancel_drag");
  }

  static void ChooseLast(Editor* editor) {
    const int last = static_cast<int>(editor->session().project().regions.size()) - 1;
    ChooseBar(editor, {BarKind::kRegion, last});
  }

  static void MarkSelected(Editor* editor) {
    if (editor->session().selected_joints().empty()) {
      return editor->Say(Tr("No joint is selected: select some, or drag over rows and frames"));
    }
    const ProjectFrames frames = FramesToMark(editor->session());
    if (editor->Do("region.add", {{"first", frames.first},
                                  {"last", frames.last},
                                  {"key_start", true},
                                  {"contacts", TouchesWhenMade(editor->session().project())}})) {
      ChooseLast(editor);
    }
  }

  bool is_held_, touches_;
  bool has_clicked_ = false;
  Point where_;
  std::string marks_, painted_;
  Json shown_;  // the region as it was added last
  bool is_there_ = false;
  std::string trouble_;  // why it was refused
};

class MoveMarkerTool : public SheetDrag {
 public:
  MoveMarkerTool(Editor* editor, Point start, int marker)
      : SheetDrag(editor, start, true), marker_(marker) {
    frame_ = editor->session().project().markers[marker].frame;
  }
  std::string hint() const override {
    return std::string(Tr("Move marker")) + "  " + std::to_string(frame_) + "   " + DragKeys(false);
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    const int frame = FrameUnder(*editor, input.mouse);
    if (!has_moved() || frame == frame_) return;
    frame_ = frame;
    editor->Do("marker.move", {{"index", marker_}, {"to", frame}, {"drag", drag()}});
  }

 private:
  int marker_, frame_;
};

class PreviewRangeTool : public SheetDrag {
 public:
  PreviewRangeTool(Editor* editor, Point start, bool by_button)
      : SheetDrag(editor, start, by_button), is_held_(by_button) {}
  std::string hint() const override {
    return std::string(Tr("Preview range: drag over frames")) + "  " + range_ + "   " +
           Tr("Esc: cancel");
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    where_ = input.mouse;
    if (!is_held_ || !has_moved()) return;
    const ProjectFrames& all = editor->session().project().frames;
    const int a = std::clamp(FrameUnder(*editor, start()), all.first, all.last);
    const int b = std::clamp(FrameUnder(*editor, where_), all.first, all.last);
    const std::string range = SpanText(std::min(a, b), std::max(a, b));
    if (range == range_) return;
    range_ = range;
    editor->Do("time.preview",
               {{"first", std::min(a, b)}, {"last", std::max(a, b)}, {"drag", drag()}});
  }

  void Finish(Editor* editor) override {
    if (is_held_) return SheetDrag::Finish(editor);
    editor->Take(std::make_unique<PreviewRangeTool>(editor, where_, true));
  }

 private:
  bool is_held_;
  Point where_;
  std::string range_;
};

}  // namespace

std::unique_ptr<Tool> MakePreviewRange(Editor* editor, Point start) {
  return std::make_unique<PreviewRangeTool>(editor, start, false);
}

std::unique_ptr<Tool> MakeScrub(Editor* editor, Point start) {
  return std::make_unique<ScrubTool>(editor, start);
}

std::unique_ptr<Tool> MakePaintRegion(Editor* editor, Point start) {
  return std::make_unique<PaintRegionTool>(editor, start, false);
}

std::unique_ptr<Tool> MakeMoveMarker(Editor* editor, Point start, int marker) {
  return std::make_unique<MoveMarkerTool>(editor, start, marker);
}

bool TouchesWhenMade(const Project& project) { return project.solver.method == Method::kExact; }

ProjectFrames FramesToMark(const edit::Session& session) {
  const Project& project = session.project();
  std::set<double> frames;
  for (const auto& [curve, keys] : session.selected_keys()) frames.insert(keys.begin(), keys.end());
  if (frames.size() > 1) {
    return {static_cast<int>(std::floor(*frames.begin())),
            static_cast<int>(std::ceil(*frames.rbegin())),
            {}};
  }
  if (project.preview) return *project.preview;
  constexpr int kLength = 10;
  const int last = project.frames.last, now = static_cast<int>(std::lround(session.frame()));
  const int end = std::clamp(now + kLength, project.frames.first + 1, std::max(last, 1));
  return {std::clamp(now, project.frames.first, end - 1), end, {}};
}

}  // namespace hazumi::ui
