#include "ui/panels/region_tools.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/panels/sheet_drag.h"

namespace hazumi::ui {

namespace {

std::string Span(int first, int last) {
  return std::to_string(first) + " - " + std::to_string(last);
}

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

class DragRegionTool : public SheetDrag {
 public:
  DragRegionTool(Editor* editor, Point start, const ProjectRegion& region, SheetPart part)
      : SheetDrag(editor, start, true),
        name_(region.name),
        part_(part),
        first_before_(region.first_frame),
        last_before_(region.last_frame),
        first_(first_before_),
        last_(last_before_) {}

  std::string hint() const override {
    const char* what = part_ == SheetPart::kBar ? "Move region" : "Stretch region";
    const std::string text = std::string(Tr(what)) + "  " + name_ + "  " + Span(first_, last_);
    return text + "   " + (trouble_.empty() ? DragKeys(false) : "! " + trouble_);
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    if (!has_moved()) return;
    const ProjectFrames& all = editor->session().project().frames;
    const double px = SheetAxis(*editor).px_per_frame();
    int by = static_cast<int>(std::lround((input.mouse.x - start().x) / px));
    int first = first_before_, last = last_before_;
    if (part_ == SheetPart::kBarStart) {
      first = std::clamp(first + by, std::min(all.first, first), last - 1);
    } else if (part_ == SheetPart::kBarEnd) {
      last = std::clamp(last + by, first + 1, std::max(all.last, last));
    } else {
      by = std::clamp(by, std::min(0, all.first - first), std::max(0, all.last - last));
      first += by;
      last += by;
    }
    if (first == first_ && last == last_) return;
    first_ = first;
    last_ = last;
    const Result<Done> done = editor->Invoke(
        "region.set", {{"region", name_}, {"first", first}, {"last", last}, {"drag", drag()}});
    trouble_ = done.ok() ? "" : done.error().message;
  }

 private:
  std::string name_;
  SheetPart part_;
  int first_before_, last_before_;
  int first_, last_;     // asked for
  std::string trouble_;  // why they were refused; the region stays where it could be last
};

class PaintRegionTool : public SheetDrag {
 public:
  PaintRegionTool(Editor* editor, Point start, bool by_button)
      : SheetDrag(editor, start, by_button), is_held_(by_button) {
    const edit::Session& session = editor->session();
    if (session.selected_joints().empty()) return;
    const ProjectFrames frames = FramesToMark(session);
    marks_ = Span(frames.first, frames.last);
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
    has_clicked_ = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
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
    painted_ = Span(paint.first_frame, paint.last_frame);
    Show(editor, paint, RegionOn(layout, paint.first_row, paint.last_row));
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
  // While it is painted the region is there already, and what it moves swings.
  void Show(Editor* editor, const SheetState::Paint& paint, const RegionOnRows& on) {
    const bool is_one = paint.first_frame < paint.last_frame && !on.joints.empty();
    const Json region = !is_one ? Json()
                                : Json{{"name", on.name},
                                       {"first", paint.first_frame},
                                       {"last", paint.last_frame},
                                       {"joints", on.joints},
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
    editor->sheet.region = editor->session().project().regions.back().name;
  }

  static void MarkSelected(Editor* editor) {
    if (editor->session().selected_joints().empty()) {
      return editor->Say(Tr("No joint is selected: select some, or drag over rows and frames"));
    }
    const ProjectFrames frames = FramesToMark(editor->session());
    if (editor->Do("region.add", {{"first", frames.first}, {"last", frames.last}})) {
      ChooseLast(editor);
    }
  }

  bool is_held_;
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
    const std::string range = Span(std::min(a, b), std::max(a, b));
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

std::unique_ptr<Tool> MakeDragRegion(Editor* editor, Point start, const std::string& region,
                                     SheetPart part) {
  for (const ProjectRegion& each : editor->session().project().regions) {
    if (each.name == region) return std::make_unique<DragRegionTool>(editor, start, each, part);
  }
  return nullptr;
}

std::unique_ptr<Tool> MakePaintRegion(Editor* editor, Point start) {
  return std::make_unique<PaintRegionTool>(editor, start, false);
}

std::unique_ptr<Tool> MakeMoveMarker(Editor* editor, Point start, int marker) {
  return std::make_unique<MoveMarkerTool>(editor, start, marker);
}

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
