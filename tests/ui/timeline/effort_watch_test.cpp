// What the motion asks of muscles, found beside the interface.

#include "ui/panels/timeline/effort_watch.h"

#include <chrono>
#include <thread>

#include "engine/bake/bake.h"
#include "tests/ui/user.h"

namespace hazumi::test {
namespace {

Effort EffortAnew(edit::Session* session) {
  BakeOptions options;
  options.accelerations = true;
  const Motion motion = Bake(*session->animation(), options).value();
  return EffortOf(*session->animation(), motion);
}

TEST(EffortWatch, IsThatOfTheMotionAndFollowsItsEdits) {
  User user("throw.kfa");
  ui::EffortWatch watch;
  EXPECT_EQ(watch.At(7), nullptr);
  watch.Look(&user.session());
  const long number = watch.number();
  ASSERT_NE(watch.At(7), nullptr);
  EXPECT_EQ(watch.At(7)->tau, EffortAnew(&user.session()).frames[7].tau);
  watch.Look(&user.session());
  EXPECT_EQ(watch.number(), number);
  user.editor().Do("key.set", {{"curve", "r_elbow_flexion"}, {"frame", 0}, {"value", 40}});
  watch.Look(&user.session());
  EXPECT_GT(watch.number(), number);
  EXPECT_EQ(watch.At(1)->tau, EffortAnew(&user.session()).frames[1].tau);
  EXPECT_EQ(watch.At(-1), nullptr);
  EXPECT_EQ(watch.At(user.project().frames.last + 1), nullptr);
}

TEST(EffortWatch, ForgetsADocumentThatIsNoLongerThere) {
  User user("throw.kfa");
  ui::EffortWatch watch;
  watch.Look(&user.session());
  user.editor().Do("file.open", {{"path", HAZUMI_SOURCE_DIR "/assets/examples/jump.kfa"}});
  user.session().StopBaking();
  watch.Look(&user.session());
  user.session().ResumeBaking();
  watch.Look(&user.session());
  ASSERT_NE(watch.At(7), nullptr);
  EXPECT_EQ(watch.At(7)->tau, EffortAnew(&user.session()).frames[7].tau);
}

// What is still at work for a motion that is no more leaves nothing behind.
TEST(EffortWatch, GoesOnBesideWhoeverDoesNotWait) {
  User user("throw.kfa");
  ASSERT_TRUE(user.session().WholeMotion().ok());
  ui::EffortWatch watch;
  user.session().set_patience(10.0);
  watch.Look(&user.session());
  EXPECT_TRUE(watch.is_busy());
  user.editor().Do("key.set", {{"curve", "r_elbow_flexion"}, {"frame", 0}, {"value", 40}});
  ASSERT_TRUE(user.session().WholeMotion().ok());
  const Effort expected = EffortAnew(&user.session());
  const auto is_there = [&] {
    watch.Look(&user.session());
    return !watch.is_busy() && watch.At(1) && watch.At(1)->tau == expected.frames[1].tau;
  };
  while (!is_there()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_NE(watch.At(1), nullptr);
  EXPECT_EQ(watch.At(1)->tau, expected.frames[1].tau);
}

TEST(EffortWatch, IsAskedForOnlyWhileItIsSeen) {
  User user("throw.kfa");
  user.Wait();
  EXPECT_FALSE(user.editor().effort.is_there());
  user.editor().Do("view.overlay", {{"name", "effort"}});
  user.Wait();
  EXPECT_TRUE(user.editor().effort.is_there());
}

}  // namespace
}  // namespace hazumi::test
