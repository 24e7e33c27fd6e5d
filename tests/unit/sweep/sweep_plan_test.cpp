// Cells of a sweep by their numbers, and what a sweep file is refused for.

#include "engine/sweep/sweep_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "engine/project/project_reader.h"
#include "tests/unit/project/sample.h"
#include "tests/unit/sweep/sweeps.h"

namespace hazumi {
namespace {

using test::GoodSweep, test::SweepText;

using Texts = std::vector<std::string>;

// The values of the first axis, cell by cell.
Texts FirstValues(const SweepPlan& plan) {
  Texts values;
  for (long cell = 0; cell < CellCount(plan); ++cell) values.push_back(ValuesOf(plan, cell)[0]);
  return values;
}

std::string Refusal(const std::string& fields) {
  const Result<SweepPlan> plan = ParseSweep(SweepText(fields), "s.json");
  return plan.ok() ? "" : plan.error().ToString();
}

TEST(SweepPlan, OfAGridIsEveryValueWithEveryOther) {
  const SweepPlan plan = GoodSweep(R"("vary": [
      {"field": "a", "values": [1, 2]}, {"field": "b", "values": ["x", [1, 0], null]},
      {"field": "c", "from": 0, "to": 1, "count": 2}])");
  EXPECT_EQ(CellCount(plan), 12);
  EXPECT_EQ(AxisSizes(plan), (std::vector<int>{2, 3, 2}));
  long cell = 0;
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 3; ++b) {
      for (int c = 0; c < 2; ++c, ++cell) {
        const Texts values = {Texts{"1", "2"}[a], Texts{"\"x\"", "[1, 0]", "null"}[b],
                              Texts{"0", "1"}[c]};
        EXPECT_EQ(ValuesOf(plan, cell), values) << cell;
        EXPECT_EQ(AxisNumbers(plan, cell), (std::vector<int>{a, b, c})) << cell;
      }
    }
  }
}

TEST(SweepPlan, OfAListIsTheValuesSideBySide) {
  const SweepPlan plan = GoodSweep(R"("combine": "list", "vary": [
      {"field": "a", "values": [3, 5, 7]}, {"field": "b", "from": 10, "to": 20, "count": 3}])");
  EXPECT_EQ(CellCount(plan), 3);
  EXPECT_EQ(AxisSizes(plan), (std::vector<int>{3, 3}));
  EXPECT_EQ(ValuesOf(plan, 0), (Texts{"3", "10"}));
  EXPECT_EQ(ValuesOf(plan, 1), (Texts{"5", "15"}));
  EXPECT_EQ(ValuesOf(plan, 2), (Texts{"7", "20"}));
}

constexpr const char* kRandomAxes =
    R"("combine": "random", "vary": [{"field": "a", "from": 2, "to": 3},
       {"field": "b", "values": [1, 2, 4]}, {"field": "c", "from": 0, "to": 9, "spacing": "whole"}],)";

TEST(SweepPlan, AtRandomStaysWithinTheRangesAndReachesAllOfThem) {
  const SweepPlan plan = GoodSweep(kRandomAxes + std::string(R"("count": 2000, "seed": 7)"));
  double least = 1e9, most = -1e9, sum = 0.0;
  std::set<std::string> words, whole;
  for (long cell = 0; cell < 2000; ++cell) {
    const Texts values = ValuesOf(plan, cell);
    const double a = std::stod(values[0]);
    least = std::min(least, a);
    most = std::max(most, a);
    sum += a;
    words.insert(values[1]);
    whole.insert(values[2]);
  }
  EXPECT_GE(least, 2.0);
  EXPECT_LT(most, 3.0);
  EXPECT_LT(least, 2.01);
  EXPECT_GT(most, 2.99);
  // The mean of 2000 is off by 1 / sqrt(12 * 2000) = 0.0065 as a rule.
  EXPECT_NEAR(sum / 2000.0, 2.5, 0.03);
  EXPECT_EQ(words, (std::set<std::string>{"1", "2", "4"}));
  EXPECT_EQ(whole.size(), 10u);
}

TEST(SweepPlan, AtRandomDependsOnSeedCellAndAxisAlone) {
  const auto sweep = [](const std::string& more) { return GoodSweep(kRandomAxes + more); };
  const SweepPlan plan = sweep(R"("count": 50, "seed": 7)");
  const SweepPlan longer = sweep(R"("count": 1000, "seed": 7)");
  const SweepPlan other = sweep(R"("count": 50, "seed": 8)");
  int same = 0;
  for (long cell = 0; cell < 50; ++cell) {
    EXPECT_EQ(ValuesOf(plan, cell), ValuesOf(longer, cell)) << cell;
    same += ValuesOf(plan, cell)[0] == ValuesOf(other, cell)[0] ? 1 : 0;
  }
  EXPECT_EQ(same, 0);
  EXPECT_EQ(FirstValues(sweep(R"("count": 50)")), FirstValues(sweep(R"("count": 50, "seed": 1)")));
  const SweepPlan twins = GoodSweep(R"("combine": "random", "count": 20, "vary": [
      {"field": "a", "from": 0, "to": 1}, {"field": "b", "from": 0, "to": 1}])");
  for (long cell = 0; cell < 20; ++cell) {
    EXPECT_NE(ValuesOf(twins, cell)[0], ValuesOf(twins, cell)[1]) << "axes are independent";
  }
}

// Backwards, as tasks might ask for them.
TEST(SweepPlan, GivesAnyCellAloneAsItIsInOrder) {
  for (const char* fields :
       {R"("vary": [{"field": "a", "from": 0, "to": 1, "count": 7},
                    {"field": "b", "values": [1, 2, 3]}])",
        R"("combine": "list", "vary": [{"field": "a", "from": 1, "to": 9, "count": 21,
                                        "spacing": "log"}])",
        R"("combine": "random", "count": 21, "vary": [{"field": "a", "from": 0, "to": 1}])"}) {
    const SweepPlan plan = GoodSweep(fields);
    std::vector<Texts> forward, backward;
    for (long cell = 0; cell < 21; ++cell) forward.push_back(ValuesOf(plan, cell));
    for (long cell = 21; cell-- > 0;) backward.push_back(ValuesOf(plan, cell));
    std::reverse(backward.begin(), backward.end());
    EXPECT_EQ(forward, backward);
  }
}

TEST(SweepPlan, SpacesNumbersAsItSays) {
  const auto values = [](const std::string& axis) {
    return FirstValues(GoodSweep(R"("vary": [{"field": "a", )" + axis + "}]"));
  };
  EXPECT_EQ(values(R"("from": 0, "to": 1, "count": 5)"), (Texts{"0", "0.25", "0.5", "0.75", "1"}));
  EXPECT_EQ(values(R"("from": 4, "to": 1, "count": 4)"), (Texts{"4", "3", "2", "1"}));
  EXPECT_EQ(values(R"("from": 1, "to": 1000, "count": 4, "spacing": "log")"),
            (Texts{"1", "10", "100", "1000"}));
  EXPECT_EQ(values(R"("from": 3, "to": 10, "count": 4, "spacing": "whole")"),
            (Texts{"3", "5", "8", "10"}));
  EXPECT_EQ(values(R"("from": 7.5, "to": 9, "count": 1)"), Texts{"7.5"});
  for (const std::string& value : values(R"("from": 0.1, "to": 7, "count": 9, "spacing": "log")")) {
    EXPECT_LE(value.size(), 14u) << value;
  }
}

// 0.3, not 0.30000000000000004; and no value is off by more than half of the twelfth digit.
TEST(SweepPlan, WritesNumbersAsAPersonWould) {
  const SweepPlan plan = GoodSweep(R"("vary": [{"field": "a", "from": 0, "to": 1, "count": 11}])");
  EXPECT_EQ(FirstValues(plan),
            (Texts{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"}));
  const SweepPlan thirds = GoodSweep(R"("vary": [{"field": "a", "from": 0, "to": 2, "count": 7}])");
  EXPECT_EQ(FirstValues(thirds)[1], "0.333333333333");
  const SweepPlan random = GoodSweep(
      R"("combine": "random", "count": 500, "vary": [{"field": "a", "from": -5, "to": 1e4}])");
  for (const std::string& value : FirstValues(random)) {
    const size_t digits = static_cast<size_t>(
        std::count_if(value.begin(), value.end(), [](char c) { return c >= '0' && c <= '9'; }));
    EXPECT_LE(digits, 13u) << value;  // with a zero before the point
  }
}

TEST(SweepPlan, GoesThroughAFileAndBack) {
  const SweepPlan plan = GoodSweep(R"("combine": "list", "seed": 3, "x": [1], "vary": [
      {"field": "a", "also": ["b", "c"], "values": [1, "two", [3, 4]], "note": "kept"},
      {"field": "d", "from": 1, "to": 4, "count": 3, "spacing": "log"}],
      "measure": [{"name": "far", "quantity": "landing_x_m", "of": "ball"},
                  {"quantity": "angle_deg", "of": "r_knee", "frame": 3}],
      "picture": {"frames": [1, 2], "options": ["--size", "64x48"]})");
  const std::string text = WriteSweep(plan);
  const Result<SweepPlan> again = ParseSweep(text, "s.json");
  ASSERT_TRUE(again.ok()) << again.error().ToString();
  EXPECT_EQ(WriteSweep(again.value()), text);
  EXPECT_TRUE(again.value() == plan);
  EXPECT_NE(text.find("\"note\": \"kept\""), text.npos);
}

TEST(SweepPlan, IsRefusedWithPlaceAndRemedy) {
  const std::string good = R"({"field": "a", "values": [1, 2]})";
  const std::vector<std::pair<std::string, std::string>> refusals = {
      {R"("vary": [])", "vary: is empty: name a field and its values"},
      {R"("combine": "grid")", "the field \"vary\" is missing; add it"},
      {R"("vary": [{"field": "a"}])",
       "vary[0]: has no values: give \"values\", or \"from\" and \"to\""},
      {R"("vary": [{"field": "a", "values": []}])",
       "vary[0]: has no values: give \"values\", or \"from\" and \"to\""},
      {R"("vary": [{"field": "a", "from": 1, "count": 3}])",
       "vary[0]: has no values: give \"values\", or \"from\" and \"to\""},
      {R"("vary": [{"field": "a", "values": [1], "to": 2}])",
       "vary[0]: give either \"values\" or \"from\", \"to\" and \"count\""},
      {R"("vary": [)" + good + R"(, {"field": "b", "from": 1, "to": 2}])",
       "vary[1]: \"count\" is missing: how many values there are from \"from\" to \"to\""},
      {R"("vary": [{"field": "a", "from": 1, "to": 2, "count": 0}])",
       "vary[0].count: must be greater than 0, is 0"},
      {R"("vary": [{"field": "a", "from": 0, "to": 2, "count": 3, "spacing": "log"}])",
       "vary[0]: with spacing \"log\" both ends must be greater than 0"},
      {R"("vary": [{"field": "a[", "values": [1]}])",
       "vary[0]: \"a[\" is no address of a field: a ] is missing"},
      {R"("vary": [{"field": "a", "also": ["b", "c..d"], "values": [1]}])",
       "vary[0]: \"c..d\" is no address of a field: a name is missing"},
      {R"("vary": [{"values": [1]}])", "vary[0]: the field \"field\" is missing; add it"},
      {R"("combine": "list", "vary": [)" + good + R"(, {"field": "b", "values": [1, 2, 3]}])",
       "vary[1]: has 3 values, vary[0] has 2: in a list all have as many"},
      {R"("combine": "random", "vary": [)" + good + "]",
       "count: is missing: how many cells are drawn"},
      {R"("combine": "random", "count": 5, "vary": [{"field": "a", "from": 0, "to": 1, "count": 3}])",
       "vary[0].count: belongs to the sweep as a whole where values are drawn at random"},
      {R"("count": 5, "vary": [)" + good + "]",
       "count: goes with \"combine\": \"random\" alone; each axis has its own"},
      {R"("combine": "randon", "vary": [)" + good + "]",
       "combine: there is no way to combine \"randon\"; did you mean \"random\"?"},
      {R"("seed": -1, "vary": [)" + good + "]", "seed: must not be negative, is -1"},
      {R"("vary": [)" + good + R"(], "picture": {})",
       "picture: say \"frames\": [16], or \"video\": true"},
      {R"("vary": [)" + good + R"(], "picture": {"frames": [1], "video": true})",
       "picture: either \"frames\" or \"video\""}};
  for (const auto& [fields, message] : refusals) {
    EXPECT_EQ(Refusal(fields), "s.json: " + message) << fields;
  }
}

TEST(SweepPlan, OfMoreThanAMillionCellsIsRefusedWithTheirNumber) {
  const std::string million = R"("from": 0, "to": 1, "count": 1000000})";
  EXPECT_EQ(
      Refusal(R"("vary": [{"field": "a", )" + million + R"(, {"field": "b", )" + million + "]"),
      "s.json: vary: 1000000000000 cells; 1000000 are the most: give fewer values, or split "
      "the sweep");
  EXPECT_EQ(
      Refusal(R"("vary": [{"field": "a", )" + million + R"(, {"field": "b", "values": [1, 2]}])"),
      "s.json: vary: 2000000 cells; 1000000 are the most: give fewer values, or split the "
      "sweep");
  EXPECT_EQ(Refusal(R"("combine": "random", "count": 1000001, "vary": [{"field": "a", "from": 0,
                       "to": 1}])"),
            "s.json: vary: 1000001 cells; 1000000 are the most: give fewer values, or split the "
            "sweep");
  EXPECT_EQ(CellCount(GoodSweep(R"("vary": [{"field": "a", )" + million + "]")), 1000000);
}

TEST(SweepPlan, ThatIsNoSweepFileIsRefused) {
  for (const char* text : {"", "[]", "{", R"({"format": "hazumi-project", "version": 1})",
                           R"({"format": "hazumi-sweep", "version": 9, "project": "a.kfa"})"}) {
    const Result<SweepPlan> plan = ParseSweep(text, "s.json");
    ASSERT_FALSE(plan.ok()) << text;
    EXPECT_EQ(plan.error().file, "s.json");
  }
  const Result<SweepPlan> missing = LoadSweep("no/such.json");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, ErrorCode::kNoInput);
}

Project Sample() { return testing::ParseGood(testing::SampleProject()); }

// What the sample says of these axes.
std::string FieldRefusal(const std::string& fields) {
  const Result<Done> checked = CheckFields(GoodSweep(fields), Sample());
  return checked.ok() ? "" : checked.error().ToString();
}

TEST(CheckFields, TriesEveryValueOnTheProject) {
  EXPECT_EQ(FieldRefusal(R"("vary": [{"field": "regions[arm].friction.default",
                                      "also": ["regions[leg].friction.default"],
                                      "values": [0, 0.5, 1]},
                                     {"field": "regions[arm].step_s", "values": [0.01, null]}])"),
            "");
  EXPECT_EQ(FieldRefusal(R"("vary": [{"field": "regions[arm].friction.default",
                                      "values": [0, 0.5, 1.5]}])"),
            "vary[0].values[2]: regions[arm].friction.default = 1.5: must lie between 0 and 1, "
            "is 1.5 (speed that is left after 1/30 s: 0 frozen, 1 no friction)");
  EXPECT_EQ(FieldRefusal(R"("vary": [{"field": "name", "values": ["a"]},
                                     {"field": "regions[arm].step_s", "from": 0, "to": 0.1,
                                      "count": 3}])")
                .substr(0, 39),
            "vary[1].from: regions[arm].step_s = 0: ");
  EXPECT_EQ(FieldRefusal(R"("vary": [{"field": "regions[arm].frictoin.default", "values": [1]}])"),
            "vary[0].values[0]: regions[arm].frictoin.default = 1: there is no field \"frictoin\" "
            "here; did you mean \"friction\"?");
  // Between whole frames, where only whole ones go.
  EXPECT_EQ(FieldRefusal(R"("vary": [{"field": "regions[leg].last_frame", "from": 18, "to": 20,
                                      "count": 4}])")
                .substr(0, 44),
            "vary[0].count: regions[leg].last_frame = 18.");
}

TEST(CheckFields, TriesTheEndsOfWhatIsDrawnAtRandom) {
  EXPECT_EQ(FieldRefusal(R"("combine": "random", "count": 3, "vary": [
                {"field": "regions[arm].friction.default", "from": 0.5, "to": 2}])")
                .substr(0, 55),
            "vary[0].to: regions[arm].friction.default = 2: must lie");
}

TEST(ApplyCell, GivesAllFieldsOfAnAxisTheValue) {
  const SweepPlan plan = GoodSweep(R"("vary": [
      {"field": "regions[arm].friction.default", "also": ["regions[leg].friction.default"],
       "values": [0.25, 0.75]}, {"field": "scene.gravity_m_s2", "values": [1.62, 3.7]}])");
  Project project = Sample();
  ASSERT_TRUE(ApplyCell(plan, 3, &project).ok());
  Project expected = Sample();
  for (ProjectRegion& region : expected.regions) region.friction.default_factor = 0.75;
  expected.scene.gravity_m_s2 = 3.7;
  EXPECT_TRUE(project == expected);
}

}  // namespace
}  // namespace hazumi
