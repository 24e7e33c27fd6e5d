#pragma once

#include <optional>
#include <string>

#include "ui/panels/viewport/tools/drag_tool.h"
#include "ui/panels/viewport/tools/tools.h"

namespace hazumi::ui {

// Moves a point, in a plane or along an axis of the world.
class PointMoveTool : public DragTool {
 public:
  // `from`: where the point is [m].
  PointMoveTool(Editor* editor, std::string name, const Vec3& from, std::optional<HeldFrom> held);

  std::string hint() const override;

 protected:
  // To where it was plus `offset` [m].
  virtual bool Place(Editor* editor, const Vec3& offset) = 0;
  // The normal of that plane: by default towards the eye.
  virtual Vec3 PlaneOf(const View& view) const { return view.back(); }
  // What is moved, for who reads it.
  virtual std::string moved() const { return name_; }
  // A key that is no number and no axis. True if it changes what Place does.
  virtual bool TakeKey(const Chord&) { return false; }
  // What such keys do.
  virtual std::string MoreHint() const { return ""; }

  bool Follow(Editor* editor, const ToolInput& input) override;

  // 'X' to 'Z': moves along this axis of the world.
  void KeepToAxis(char axis) { axis_ = axis; }
  const std::string& name() const { return name_; }
  const Vec3& from() const { return from_; }

 private:
  Vec3 OffsetOf(const View& view, bool snap) const;

  std::string name_;
  Vec3 from_;
  char axis_ = 0;  // 'X' to 'Z' once it was typed
  std::optional<Point> start_;
  Point mouse_;  // moves as the mouse does, slower with Shift
  Vec3 offset_ = Vec3::Zero();
  TypedNumber typed_;
};

}  // namespace hazumi::ui
