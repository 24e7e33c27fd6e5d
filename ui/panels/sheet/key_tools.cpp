#include "ui/panels/sheet/key_tools.h"

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "ui/panels/sheet/drag.h"

namespace hazumi::ui {

namespace {

class MoveKeysTool : public SheetDrag {
 public:
  MoveKeysTool(Editor* editor, Point start, MoveKeysOptions options)
      : SheetDrag(editor, start, options.by_button), options_(std::move(options)) {}

  std::string hint() const override {
    std::string text = Tr(options_.duplicates ? "Duplicate keys" : "Move keys");
    text += "  " + (typed_.is_empty() || is_up_ ? Signed(frames_) : typed_.shown()) + " " +
            Tr("frames");
    if (options_.value_per_px != 0.0) {
      text += "  " + (typed_.is_empty() || !is_up_ ? Signed(value_) : typed_.shown());
    }
    text += "   " + DragKeys(true);
    return options_.value_per_px == 0.0 ? text : text + "   " + Tr("X: time only   Y: value only");
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    for (const Chord& chord : input.keys) TakeKey(chord);
    if (!has_moved()) return;
    double frames = 0.0, value = 0.0;
    if (!typed_.is_empty()) {
      (is_up_ ? value : frames) = typed_.value();
    } else {
      frames = std::round((input.mouse.x - start().x) / SheetAxis(*editor).px_per_frame());
      value = (start().y - input.mouse.y) * options_.value_per_px;
      if (is_up_) frames = 0.0;
      if (is_along_ || std::abs(start().y - input.mouse.y) <= 3.0) value = 0.0;
      if (input.snap) value = std::round(value);
    }
    if (has_run_ && frames == frames_ && value == value_) return;
    frames_ = frames;
    value_ = value;
    Json to = {{"frames", frames}, {"value", value}, {"drag", drag()}};
    if (frames != std::round(frames)) to["subframe"] = true;
    has_run_ |= editor->Do(options_.duplicates ? "keys.duplicate" : "keys.move", to);
  }

  void Finish(Editor* editor) override {
    SheetDrag::Finish(editor);
    if (!has_moved() && options_.click) SelectKeys(editor, *options_.click, "replace");
  }

 private:
  void TakeKey(const Chord& chord) {
    const bool has_values = options_.value_per_px != 0.0;
    if (typed_.Take(chord) || !has_values) return;
    if (chord.key == 'X') is_up_ = false, is_along_ = !is_along_;
    if (chord.key == 'Y') is_along_ = false, is_up_ = !is_up_;
  }

  MoveKeysOptions options_;
  TypedNumber typed_;
  bool is_up_ = false, is_along_ = false;  // value only, time only
  bool has_run_ = false;
  double frames_ = 0.0, value_ = 0.0;
};

class ScaleKeysTool : public SheetDrag {
 public:
  ScaleKeysTool(Editor* editor, Point start)
      : SheetDrag(editor, start, false), has_values_(editor->sheet.kind == SheetKind::kGraph) {}

  std::string hint() const override {
    std::string text = Tr(is_up_ ? "Scale values" : "Scale keys");
    text += "  " + (typed_.is_empty() ? FormatShort(factor_) : typed_.shown());
    text += "   " + DragKeys(true);
    return has_values_ ? text + "   " + Tr("X: time   Y: values") : text;
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    const bool was_up = is_up_;
    for (const Chord& chord : input.keys) TakeKey(chord);
    const double by = is_up_ ? Above(input) : Beside(*editor, input);
    double factor = std::max(0.01, std::round(100.0 * (1.0 + by)) / 100.0);
    if (!typed_.is_empty()) factor = typed_.value();
    if ((factor == factor_ && is_up_ == was_up) || (factor <= 0.0 && !is_up_)) return;
    factor_ = factor;
    editor->Do("keys.scale", {{is_up_ ? "values" : "factor", factor}, {"drag", drag()}});
  }

 private:
  void TakeKey(const Chord& chord) {
    if (typed_.Take(chord) || !has_values_) return;
    if (chord.key == 'X') is_up_ = false;
    if (chord.key == 'Y') is_up_ = true;
  }
  // How much greater, by the distance from the playhead. Beside it the least motion would mean the
  // world.
  double Beside(const Editor& editor, const ToolInput& input) const {
    const float about = SheetAxis(editor).XOf(editor.session().frame());
    const double reach = std::max(20.0f, std::abs(start().x - about));
    return (start().x < about ? -1.0 : 1.0) * (input.mouse.x - start().x) / reach;
  }
  double Above(const ToolInput& input) const {
    constexpr double kTwice = 100.0;  // px
    return (start().y - input.mouse.y) / kTwice;
  }

  bool has_values_, is_up_ = false;  // values, not time
  TypedNumber typed_;
  double factor_ = 1.0;
};

Rect Between(Point a, Point b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x), std::abs(a.y - b.y)};
}

class BoxSelectTool : public SheetDrag {
 public:
  BoxSelectTool(Editor* editor, Point start, bool by_button)
      : SheetDrag(editor, start, by_button), is_held_(by_button) {
    if (by_button) from_ = start;
  }

  std::string hint() const override {
    return std::string(Tr("Box select")) + "   " + Tr("Shift: add   Ctrl: remove   Esc: cancel");
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    mode_ = input.precise ? "add" : input.snap ? "remove" : "replace";
    if (!from_ && input.confirm) from_ = input.mouse;
    if (from_) editor->sheet.box = Between(*from_, input.mouse);
  }

  void Finish(Editor* editor) override {
    if (!is_held_ && from_) return editor->Take(MakeBoxSelect(editor, *from_, true));
    const Rect box = editor->sheet.box.value_or(Rect());
    editor->sheet.box.reset();
    if (has_moved() || std::string(mode_) == "replace") {
      SelectKeys(editor, has_moved() ? ShownKeysIn(editor, box) : KeyList(), mode_);
    }
  }

  void Cancel(Editor* editor) override { editor->sheet.box.reset(); }

 private:
  bool is_held_;
  std::optional<Point> from_;
  const char* mode_ = "replace";
};

class DragHandleTool : public SheetDrag {
 public:
  DragHandleTool(Editor* editor, Point start, const GraphKey& key, int side, std::string curve)
      : SheetDrag(editor, start, true), key_(key), side_(side), curve_(std::move(curve)) {
    rate_ = side == 0 ? key.rate_before : key.rate;
    length_ = key.lengths[side];
  }

  std::string hint() const override {
    return std::string(Tr("Rate of key")) + "  " + curve_ + "  " + FormatShort(rate_) + Tr("°/s") +
           "   " + Tr("Ctrl: whole tens") + "   " + DragKeys(false);
  }

 protected:
  void Follow(Editor* editor, const ToolInput& input) override {
    if (!has_moved()) return;
    double rate = RateTowards(CurrentGraph(editor), key_, side_, input.mouse);
    rate = input.snap ? 10.0 * std::round(rate / 10.0) : std::round(10.0 * rate) / 10.0;
    std::optional<double> length = LengthTowards(CurrentGraph(editor), key_, side_, input.mouse);
    if (length) length = std::round(100.0 * *length) / 100.0;
    if (rate == rate_ && length == length_) return;
    rate_ = rate;
    length_ = length;
    Json to = {{"curve", curve_}, {"frame", key_.frame}, {"rate", rate}, {"drag", drag()}};
    if (key_.is_broken || length) to["side"] = side_ == 0 ? "before" : "after";
    if (length) to["length"] = *length;
    editor->Do("key.rate", to);
  }

 private:
  GraphKey key_;
  int side_;
  std::string curve_;
  double rate_;
  std::optional<double> length_;
};

}  // namespace

std::unique_ptr<Tool> MakeMoveKeys(Editor* editor, Point start, MoveKeysOptions options) {
  return std::make_unique<MoveKeysTool>(editor, start, std::move(options));
}

std::unique_ptr<Tool> MakeScaleKeys(Editor* editor, Point start) {
  return std::make_unique<ScaleKeysTool>(editor, start);
}

std::unique_ptr<Tool> MakeBoxSelect(Editor* editor, Point start, bool by_button) {
  return std::make_unique<BoxSelectTool>(editor, start, by_button);
}

std::unique_ptr<Tool> MakeDragHandle(Editor* editor, Point start, const GraphKey& key, int side,
                                     const std::string& curve) {
  return std::make_unique<DragHandleTool>(editor, start, key, side, curve);
}

void SelectKeys(Editor* editor, const KeyList& keys, const char* mode) {
  editor->Do("keys.select", {{"curves", keys.curves}, {"frames", keys.frames}, {"mode", mode}});
}

KeyList ShownKeysIn(Editor* editor, const Rect& box) {
  const SheetState& sheet = editor->sheet;
  if (sheet.kind == SheetKind::kGraph) return GraphKeysIn(CurrentGraph(editor), box);
  const DopeSheetLayout layout =
      LayOutDopeSheet(editor->session(), sheet, sheet.rect, editor->settings.scale);
  return KeysIn(layout, box, editor->session().project());
}

}  // namespace hazumi::ui
