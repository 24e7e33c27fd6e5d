#pragma once

#include "tests/ui/user.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/camera.h"

namespace hazumi::test {

// Somebody who has boxes and held objects before them.
class Objects : public testing::Test {
 protected:
  Objects() : user("", {1280, 800}) {}

  ui::Point InWindow(const Vec3& p) {
    const ui::ViewportState& state = user.editor().viewport;
    return ui::ViewOf(state, user.project(), state.rect).ToWindow(p).value();
  }
  Vec3 BallNow() { return user.session().ShownFrame().value()->objects[0].X_WO.p; }
  void Do(const char* id, const edit::Json& parameters) {
    ASSERT_TRUE(user.editor().Do(id, parameters)) << user.editor().message.text;
    user.Wait(1);
  }
  // A thin bar across, before the right hand.
  void AddBar(double x) {
    Do("object.add_box", {{"name", "bar"},
                          {"x", x},
                          {"y", -0.2},
                          {"z", 1.25},
                          {"size_x", 0.05},
                          {"size_y", 1.0},
                          {"size_z", 0.05}});
  }
  std::string Selected() { return ui::NameOfSelectedObject(user.editor()); }

  User user;
};

}  // namespace hazumi::test
