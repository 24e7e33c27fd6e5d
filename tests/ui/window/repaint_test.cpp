// Only what changes is drawn anew: the picture is the same as if all of it were.

#include <string>
#include <utility>
#include <vector>

#include "render/gl/interface_changes.h"
#include "tests/ui/user.h"

namespace hazumi::test {
namespace {

using render::InterfaceChanges;
using render::InterfaceLayer;
using render::InterfacePart;
using render::InterfaceVertex;
using render::PixelRect;

// A square of 10 px at each place, seen through all of 100 x 100 px.
class Squares {
 public:
  explicit Squares(const std::vector<std::pair<float, float>>& places, unsigned texture = 1,
                   float edge = 10.0f) {
    for (const auto& [x, y] : places) {
      const auto first = static_cast<std::uint16_t>(vertices_.size());
      for (const auto& [u, v] : {std::pair(0.0f, 0.0f), {edge, 0.0f}, {edge, edge}, {0.0f, edge}}) {
        vertices_.push_back({x + u, y + v, 0.0f, 0.0f, 0xffffffff});
      }
      for (const int i : {0, 1, 2, 0, 2, 3}) {
        indices_.push_back(static_cast<std::uint16_t>(first + i));
      }
    }
    layer_.vertices = vertices_;
    layer_.indices = indices_;
    layer_.parts = {InterfacePart{0.0f, 0.0f, 100.0f, 100.0f, texture, 0,
                                  static_cast<std::uint32_t>(indices_.size()), 0}};
  }
  InterfaceLayer layer() const { return layer_; }

 private:
  std::vector<InterfaceVertex> vertices_;
  std::vector<std::uint16_t> indices_;
  InterfaceLayer layer_;
};

std::vector<PixelRect> Since(const std::vector<InterfaceLayer>& layers, InterfaceChanges* changes,
                             bool has_new_picture = false) {
  return changes->Since(layers, {100, 100}, has_new_picture,
                        [](unsigned texture) { return texture == 1; });
}

TEST(InterfaceChanges, AreWhereATriangleIsAndWhereItWas) {
  InterfaceChanges changes;
  const Squares before({{10.0f, 10.0f}, {70.0f, 70.0f}}), after({{10.0f, 10.0f}, {50.0f, 65.0f}});
  EXPECT_EQ(Since({before.layer()}, &changes), (std::vector<PixelRect>{{0, 0, 100, 100}}));
  EXPECT_TRUE(Since({before.layer()}, &changes).empty());
  EXPECT_EQ(Since({after.layer()}, &changes), (std::vector<PixelRect>{{50, 65, 80, 80}}));
}

// A line may lead to a point behind the viewer, which is anywhere.
TEST(InterfaceChanges, OfWhatIsFarOutsideAreWithinTheWindow) {
  InterfaceChanges changes;
  const Squares near({{10.0f, 10.0f}}), far({{10.0f, 10.0f}}, 1, 1e13f);
  (void)Since({near.layer()}, &changes);
  EXPECT_EQ(Since({far.layer()}, &changes), (std::vector<PixelRect>{{10, 10, 100, 100}}));
}

TEST(InterfaceChanges, OfOtherTrianglesAreAllThatIsSeenOfThem) {
  InterfaceChanges changes;
  const Squares one({{10.0f, 10.0f}}), two({{10.0f, 10.0f}, {70.0f, 70.0f}});
  (void)Since({one.layer()}, &changes);
  EXPECT_EQ(Since({two.layer()}, &changes), (std::vector<PixelRect>{{0, 0, 100, 100}}));
}

TEST(InterfaceChanges, APictureThatShowsSomethingElseIsOne) {
  InterfaceChanges changes;
  const Squares own({{10.0f, 10.0f}}, 1), picture({{60.0f, 60.0f}}, 2);
  (void)Since({own.layer(), picture.layer()}, &changes);
  EXPECT_EQ(Since({own.layer(), picture.layer()}, &changes, true),
            (std::vector<PixelRect>{{60, 60, 70, 70}}));
}

TEST(InterfaceChanges, ThatOverlapAreOne) {
  InterfaceChanges changes;
  const Squares a({{10.0f, 10.0f}}), b({{18.0f, 18.0f}}), a2({{11.0f, 10.0f}}),
      b2({{18.0f, 19.0f}});
  (void)Since({a.layer(), b.layer()}, &changes);
  EXPECT_EQ(Since({a2.layer(), b2.layer()}, &changes), (std::vector<PixelRect>{{10, 10, 28, 29}}));
}

// What was drawn by and by, and then all of it at once.
class Repaint : public testing::Test {
 protected:
  void ExpectWhole(const std::string& after) {
    user.Wait(20);  // until a dialog has darkened what is behind it
    user.Pass(0.0);
    const std::vector<uint8_t> by_and_by = user.picture();
    Image dot;
    dot.width = dot.height = 1;
    dot.rgba.assign(4, 255);
    user.editor().pictures.add(dot);  // another texture: all is drawn anew
    user.Pass(0.0);
    EXPECT_TRUE(by_and_by == user.picture()) << after;
  }
  User user{"throw.kfa", {1280, 800}};
};

TEST_F(Repaint, IsTheSameAsAllAtOnce) {
  ExpectWhole("the file was opened");
  user.Drag({307, 691}, {382, 691});
  ExpectWhole("a key was dragged");
  user.Pull({307, 691}, {332, 691});
  ExpectWhole("a key is being dragged");
  user.Press(ui::kEscape);
  user.Hold(0, false);
  ExpectWhole("it was taken back");
  user.Click({1075, 165});
  ExpectWhole("a joint was selected");
  user.editor().Do("time.frame", {{"frame", 12}});
  user.Wait(3);
  ExpectWhole("the frame was changed");
  user.Click({60, 10});
  ExpectWhole("a menu was opened");
  user.Press(ui::kEscape);
  ExpectWhole("it was closed");
  user.Press(ui::kF3);
  user.Type("bo");
  ExpectWhole("a dialog was typed into");
  user.Press(ui::kEscape);
  user.editor().Do("view.theme", {{"dark", false}});
  user.Wait(1);
  ExpectWhole("the theme was changed");
  user.editor().Do("view.sheet", {{"graph", true}});
  user.Wait(2);
  ExpectWhole("the graph was shown");
  user.MoveTo({600, 250});
  user.Turn(2.0f);
  ExpectWhole("the view came nearer");
}

}  // namespace
}  // namespace hazumi::test
