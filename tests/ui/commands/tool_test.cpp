#include "ui/panels/commands/tool.h"

#include <gtest/gtest.h>

#include "ui/panels/window/editor.h"

namespace hazumi::test {
namespace {

using namespace ui;

TEST(TypedNumber, IsWhatWasTyped) {
  TypedNumber number;
  EXPECT_TRUE(number.is_empty());
  for (const int key : {int{'4'}, int{'5'}, int{kPeriod}, int{kPad0 + 2}}) {
    EXPECT_TRUE(number.Take({key}));
  }
  EXPECT_EQ(number.value(), 45.2);
  EXPECT_TRUE(number.Take({'-'}));
  EXPECT_EQ(number.value(), -45.2);
  EXPECT_TRUE(number.Take({kBackspace}));
  EXPECT_EQ(number.value(), -45.0);
  EXPECT_FALSE(number.Take({'X'}));
  EXPECT_FALSE(number.Take({'1', true}));
}

// Says what became of it.
class Probe : public Tool {
 public:
  explicit Probe(std::string* log) : log_(log) {}
  std::string hint() const override { return "probe"; }
  bool Update(Editor*, const ToolInput& input) override {
    *log_ += input.cancel ? "cancelled " : input.confirm ? "confirmed " : "moved ";
    return !input.cancel && !input.confirm;
  }

 private:
  std::string* log_;
};

TEST(Tool, StaysInHandUntilItIsConfirmed) {
  std::string log;
  Editor editor;
  editor.Take(std::make_unique<Probe>(&log));
  editor.UpdateTool({});
  EXPECT_TRUE(editor.has_tool());
  EXPECT_EQ(editor.tool_hint(), "probe");
  ToolInput confirm;
  confirm.confirm = true;
  editor.UpdateTool(confirm);
  EXPECT_FALSE(editor.has_tool());
  EXPECT_EQ(log, "moved confirmed ");
}

TEST(Tool, AnotherOneInHandCancelsIt) {
  std::string log;
  Editor editor;
  editor.Take(std::make_unique<Probe>(&log));
  editor.Take(std::make_unique<Probe>(&log));
  EXPECT_EQ(log, "cancelled ");
  EXPECT_TRUE(editor.has_tool());
}

}  // namespace
}  // namespace hazumi::test
