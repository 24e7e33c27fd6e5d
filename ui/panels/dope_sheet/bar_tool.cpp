#include <algorithm>
#include <cmath>

#include "ui/panels/dope_sheet/bar_tools.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/sheet/drag.h"

namespace hazumi::ui {

namespace {

// Returns the frames of a bar whose part was dragged by `by` frames.
ProjectFrames Dragged(ProjectFrames bar, SheetPart part, int by, const ProjectFrames& all) {
  if (part == SheetPart::kBarStart) {
    bar.first = std::clamp(bar.first + by, std::min(all.first, bar.first), bar.last - 1);
  } else if (part == SheetPart::kBarEnd) {
    bar.last = std::clamp(bar.last + by, bar.first + 1, std::max(all.last, bar.last));
  } else {
    by = std::clamp(by, std::min(0, all.first - bar.first), std::max(0, all.last - bar.last));
    bar.first += by;
    bar.last += by;
  }
  return bar;
}

class DragBarTool : public SheetDrag {
 public:
  DragBarTool(Editor* editor, Point start, const BarRef& bar, SheetPart part)
      : SheetDrag(editor, start, true),
        bar_(bar),
        part_(part),
        title_(TitleOf(editor->session().project(), bar)),
        before_(FramesOf(editor->session().project(), bar)),
        wanted_(before_) {}

  std::string hint() const override {
    const BarTexts& texts = TypeOf(bar_.kind).texts;
    const std::string text =
        std::string(Tr(part_ == SheetPart::kBar ? texts.move : texts.stretch)) + "  " + title_ +
        "  " + SpanText(wanted_.first, wanted_.last);
    return text + "   " + (trouble_.empty() ? DragKeys(false) : "! " + trouble_);
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    if (!has_moved()) return;
    const double by = (input.mouse.x - start().x) / SheetAxis(*editor).px_per_frame();
    const ProjectFrames wanted = Dragged(before_, part_, static_cast<int>(std::lround(by)),
                                         editor->session().project().frames);
    if (wanted != wanted_) {
      wanted_ = wanted;
      const Result<Done> done =
          EditChosenBar(editor, {{"first", wanted.first}, {"last", wanted.last}, {"drag", drag()}});
      refusal_ = done.ok() ? "" : done.error().message;
    }
    // The picture asks for the motion; what it finds is said from the next frame on.
    const std::optional<Error> error = editor->session().KnownError();
    trouble_ = !refusal_.empty() ? refusal_ : error ? error->message : "";
  }

  void Cancel(Editor* editor) override {
    SheetDrag::Cancel(editor);
    ChooseBar(editor, bar_);
  }

 private:
  BarRef bar_;  // as it was when the drag began
  SheetPart part_;
  std::string title_;
  ProjectFrames before_, wanted_;
  std::string refusal_;  // why it stays where it could be last
  std::string trouble_;  // that, or why there is no motion, e.g. because a hold is out of reach
};

}  // namespace

std::unique_ptr<Tool> MakeDragBar(Editor* editor, Point start, SheetPart part) {
  const std::optional<BarRef> bar = ChosenBar(editor->session().project(), editor->sheet);
  return bar ? std::make_unique<DragBarTool>(editor, start, *bar, part) : nullptr;
}

}  // namespace hazumi::ui
