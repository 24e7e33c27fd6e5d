#include "ui/panels/forms/parameter_form.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/user.h"
#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/forms/offers.h"

namespace hazumi::ui {
namespace {

FormField* Find(const std::string& name, FormState* form) {
  for (FormField& field : form->fields) {
    if (name == field.info.name) return &field;
  }
  ADD_FAILURE() << name;
  return nullptr;
}

std::vector<std::string> LabelsOf(FormState form) {
  std::vector<std::string> labels;
  for (const FormRow& row : RowsOf(&form)) labels.push_back(row.label);
  return labels;
}

std::vector<FormOption> OptionsFor(const char* id, const std::string& name,
                                   edit::Session* session) {
  FormState form = MakeForm(id, Json::object(), session);
  return OptionsOf(Find(name, &form)->info, *session);
}

TEST(ParameterForm, PlacesTheFigureOnTheSelectedJointToTheEnd) {
  edit::Session session;
  session.set_frame(4.0);
  session.set_selected_joints({"l_toe"});
  FormState form = MakeForm("placement.set", Json::object(), &session);
  const Result<Json> values = ValuesOf(form);
  ASSERT_TRUE(values.ok());
  EXPECT_EQ(values.value(),
            (Json{{"kind", "pinned"}, {"first", 4.0}, {"last", 30.0}, {"pin", "l_toe"}}));
}

TEST(ParameterForm, PinsTheLowestFootWhenNothingIsSelected) {
  edit::Session session;
  // The right leg is lifted.
  ASSERT_TRUE(session.Run("pose.rotate", {{"joint", "r_hip_flexion"}, {"to", 60}}).ok());
  FormState form = MakeForm("placement.set", Json::object(), &session);
  EXPECT_EQ(Find("pin", &form)->text, "l_toe");
}

TEST(ParameterForm, AsksForAPinOnlyWhereThereIsOne) {
  edit::Session session;
  FormState form = MakeForm("placement.set", Json::object(), &session);
  FormField* kind = Find("kind", &form);
  EXPECT_EQ(LabelsOf(form), (std::vector<std::string>{"Kind", "Frames", "Pinned joint"}));
  kind->text = "gravity";
  EXPECT_EQ(LabelsOf(form),
            (std::vector<std::string>{"Kind", "Frames", "Pinned joint", "Landing joint"}));
  kind->text = "keyed";
  EXPECT_EQ(LabelsOf(form), (std::vector<std::string>{"Kind", "Frames"}));
  EXPECT_FALSE(ValuesOf(form).value().contains("pin"));
}

TEST(ParameterForm, PutsWhatMustBeGivenFirstAndAxesIntoOneRow) {
  edit::Session session;
  EXPECT_EQ(
      LabelsOf(MakeForm("object.add_box", Json::object(), &session)),
      (std::vector<std::string>{"Name", "Position", "Size", "Rotation", "Color", "Friction"}));
  FormState key = MakeForm("key.set", Json::object(), &session);
  EXPECT_EQ(Find("interpolation", &key)->text, "");  // as it is
  std::vector<std::string> region = LabelsOf(MakeForm("region.add", Json::object(), &session));
  ASSERT_GT(region.size(), 4u);
  region.resize(4);  // what may be left out comes behind, in the order of its description
  EXPECT_EQ(region, (std::vector<std::string>{"Frames", "Joints", "Friction", "Name"}));
}

TEST(ParameterForm, OffersWhatTheProjectHas) {
  edit::Session session;
  const std::vector<FormOption> joints = OptionsFor("hold.add", "joint", &session);
  const auto has = [&](const FormOption& option) {
    return std::find(joints.begin(), joints.end(), option) != joints.end();
  };
  EXPECT_TRUE(has({"r_elbow", "r_elbow", "Right arm"}));
  EXPECT_FALSE(has({"r_elbow_flexion", "r_elbow_flexion", "Right arm"}));
  EXPECT_TRUE(OptionsFor("region.remove", "region", &session).empty());
  ASSERT_TRUE(session
                  .Run("region.add",
                       {{"name", "throw"}, {"first", 5}, {"last", 15}, {"joints", {"r_elbow"}}})
                  .ok());
  EXPECT_EQ(OptionsFor("region.remove", "region", &session),
            (std::vector<FormOption>{{"throw", "throw", ""}}));
  EXPECT_EQ(OptionsFor("solver.set", "method", &session),
            (std::vector<FormOption>{{"exact", "Exact", ""}, {"paper", "Paper", ""}}));
}

TEST(ParameterForm, EveryOfferIsTakenByItsOperator) {
  for (const edit::Operator& op : edit::AllOperators()) {
    for (const edit::ParameterInfo& info : op.parameters) {
      const bool is_offered = info.offer.thing != Thing::kAny || *info.offer.words;
      const bool is_text =
          info.kind == edit::ParameterKind::kText || info.kind == edit::ParameterKind::kNames;
      const bool is_number = info.offer.thing == Thing::kMarker ||
                             info.offer.thing == Thing::kPlacement ||
                             info.offer.thing == Thing::kHold;
      EXPECT_TRUE(!is_offered || is_text || is_number) << op.id << " " << info.name;
    }
  }
}

TEST(ParameterForm, ShowsWhatARegionHasWhereNothingIsTyped) {
  edit::Session session;
  ASSERT_TRUE(
      session.Run("region.add", {{"first", 5}, {"last", 15}, {"joints", {"r_elbow"}}}).ok());
  FormState form = MakeForm("region.set", Json::object(), &session);
  EXPECT_EQ(PresentValue(form, "last", session), "15");
  EXPECT_EQ(Find("last", &form)->text, "");  // it stays as it is
  FormState limits = MakeForm("figure.joint_limits", {{"joint", "r_knee"}}, &session);
  EXPECT_EQ(PresentValue(limits, "upper", session), "130");
}

TEST(ParameterForm, SuggestsAHingeOfTheRegionToBeStarted) {
  edit::Session session;
  ASSERT_TRUE(
      session.Run("region.add", {{"first", 5}, {"last", 15}, {"joints", {"r_elbow+"}}}).ok());
  const auto suggested = [&] {
    FormState form = MakeForm("region.start_rate", Json::object(), &session);
    return Find("joint", &form)->text;
  };
  for (const char* selected : {"", "l_knee"}) {
    ASSERT_TRUE(
        session
            .Run("select.joints", {{"joints", *selected ? Json::array({selected}) : Json::array()}})
            .ok());
    EXPECT_EQ(suggested(), "r_elbow_flexion") << selected;
  }
  ASSERT_TRUE(session.Run("select.joints", {{"joints", {"l_knee", "r_wrist"}}}).ok());
  EXPECT_EQ(suggested(), "r_wrist_flexion");
}

TEST(ParameterForm, SuggestsTheLastObjectToHoldOnToAndNoneToAnEnd) {
  edit::Session session;
  const auto suggested = [&](const char* id, const char* name) {
    FormState form = MakeForm(id, Json::object(), &session);
    return Find(name, &form)->text;
  };
  EXPECT_EQ(suggested("constraint.hold_on", "object"), "floor");
  ASSERT_TRUE(session.Run("object.add_box", {{"name", "bar"}}).ok());
  EXPECT_EQ(suggested("constraint.hold_on", "object"), "bar");
  EXPECT_EQ(suggested("constraint.hold_on", "x"), "");
  EXPECT_EQ(suggested("constraint.add", "b_object"), "");
}

TEST(ParameterForm, SuggestsABoxOnTheGroundAheadOfTheFigure) {
  edit::Session session;
  edit::Json given = ValuesOf(MakeForm("object.add_box", {{"name", "box"}}, &session)).value();
  ASSERT_TRUE(session.Run("object.add_box", given).ok()) << given;
  const auto& box = std::get<ProjectBox>(session.project().scene.objects.back().shape);
  EXPECT_EQ(box.center_m, Vec3(1.2, 0.0, 0.25));
  EXPECT_EQ(box.size_m, Vec3(0.5, 0.5, 0.5));
}

TEST(ParameterForm, SuggestsTheProjectsNumbersUnrounded) {
  edit::Session session;
  ASSERT_TRUE(session.Run("scene.gravity", {{"gravity", 9.80665}}).ok());
  FormState form = MakeForm("scene.gravity", Json::object(), &session);
  EXPECT_EQ(ValuesOf(form).value(), (Json{{"gravity", 9.80665}}));
}

TEST(ParameterForm, FiltersALongListByAnyPartOfAName) {
  const std::vector<FormOption> all = {{"r_elbow", "r_elbow", ""}, {"l_knee", "l_knee", ""}};
  EXPECT_EQ(Filtered(all, "ELB").size(), 1u);
  EXPECT_EQ(Filtered(all, "").size(), 2u);
}

TEST(ParameterForm, ATickThatIsAsWithoutItIsNotGiven) {
  edit::Session session;
  FormState form = MakeForm("pose.rotate", {{"joint", "r_knee"}, {"to", 20}}, &session);
  FormField* within = Find("within_limits", &form);
  EXPECT_TRUE(within->yes);
  EXPECT_FALSE(ValuesOf(form).value().contains("within_limits"));
  within->yes = false;
  EXPECT_EQ(ValuesOf(form).value()["within_limits"], false);
}

TEST(ParameterForm, AsksWhatTheRangeShallBeAndShowsWhatItIs) {
  edit::Session session;
  EXPECT_TRUE(NeedsForm("time.range", Json::object()));
  EXPECT_FALSE(NeedsForm("time.range", {{"last", 40}}));
  FormState form = MakeForm("time.range", Json::object(), &session);
  EXPECT_EQ(Find("last", &form)->text, "30");
}

TEST(ParameterForm, StandsBesideTheFirstStepsWhereThereIsRoom) {
  const Rect window = {0, 0, 1280, 800};
  EXPECT_EQ(MiddleOfDialog(580, window, {}), 640.0f);
  EXPECT_EQ(MiddleOfDialog(580, window, {668, 300, 300, 200}), 334.0f);
  EXPECT_EQ(MiddleOfDialog(580, window, {400, 300, 300, 200}), 640.0f);
  EXPECT_EQ(MiddleOfDialog(580, window, {960, 300, 300, 200}), 640.0f);
}

TEST(ParameterForm, EnterPlacesTheFigureAsItIsSuggested) {
  test::User user;
  user.session().set_frame(2.0);
  ASSERT_TRUE(RunOrAsk(&user.editor(), "placement.set", Json::object()).ok());
  user.Wait();
  user.Press(kEnter);
  EXPECT_EQ(user.editor().dialogs.modal, Modal::kNone) << user.editor().dialogs.form.error;
  ASSERT_EQ(user.project().placements.size(), 1u);
  const ProjectPlacement& placed = user.project().placements[0];
  EXPECT_EQ(placed.kind, PlacementKind::kPinned);
  EXPECT_EQ(placed.first_frame, 2);
}

TEST(ParameterForm, TypesIntoALongListToFindAJoint) {
  test::User user("", {900, 560});
  Editor& editor = user.editor();
  ASSERT_TRUE(RunOrAsk(&editor, "hold.add", {{"first", 0}, {"last", 9}}).ok());
  user.Wait();
  const auto open_list = [&] {
    for (float y = 200.0f; y < 400.0f && !editor.dialogs.has_list; y += 8.0f) {
      user.Click({600.0f, y});
    }
    return editor.dialogs.has_list;
  };
  ASSERT_TRUE(open_list());
  user.Press(kEscape);  // closes the list alone
  user.Wait();
  EXPECT_FALSE(editor.dialogs.has_list);
  EXPECT_EQ(editor.dialogs.modal, Modal::kForm);
  ASSERT_TRUE(open_list());
  user.Type("l_wri");
  user.Press(kEnter);
  user.Wait();
  EXPECT_EQ(Find("joint", &editor.dialogs.form)->text, "l_wrist");
  EXPECT_EQ(editor.dialogs.modal, Modal::kForm);
  user.Press(kEnter);
  EXPECT_EQ(editor.dialogs.modal, Modal::kNone) << editor.dialogs.form.error;
  EXPECT_EQ(user.project().holds.at(0).joint, "l_wrist");
}

// A form in a window that is large enough for all of it.
class KeysInForms : public testing::Test {
 protected:
  void Open(const char* id, const Json& given = Json::object()) {
    ASSERT_TRUE(RunOrAsk(&user_.editor(), id, given).ok());
    user_.Wait(3);
  }
  void Press(int key, int modifier = kNoKey) {
    user_.Press(key, modifier);
    user_.Wait();
  }
  std::string text(const char* field) { return Find(field, &user_.editor().dialogs.form)->text; }
  Modal modal() { return user_.editor().dialogs.modal; }

  test::User user_{"", {900, 700}};
};

TEST_F(KeysInForms, TabGoesFromFieldToFieldAndShiftTabBack) {
  Open("object.add_box");
  user_.Type("crate");  // the first field has the keyboard
  Press(kTab);
  user_.Type("1");
  Press(kTab);
  user_.Type("2");
  Press(kTab, kLeftShift);
  user_.Type("3");
  EXPECT_EQ(text("name"), "crate");
  EXPECT_EQ(text("y"), "2");
  EXPECT_EQ(text("x"), "3");  // what was there is taken to be typed over
  Press(kEnter);
  EXPECT_EQ(modal(), Modal::kNone) << user_.editor().dialogs.form.error;
  EXPECT_EQ(user_.project().scene.objects.back().name, "crate");
}

TEST_F(KeysInForms, AListIsOpenedBySpaceLedThroughByArrowsAndChosenFromByEnter) {
  Open("hold.add", {{"first", 0}, {"last", 9}});
  Press(kSpace);  // the list of joints is the first field
  ASSERT_TRUE(user_.editor().dialogs.has_list);
  const std::vector<FormOption> joints = OptionsFor("hold.add", "joint", &user_.session());
  for (const int key : {int{kDown}, int{kDown}, int{kUp}, int{kDown}}) Press(key);
  Press(kEnter);
  EXPECT_FALSE(user_.editor().dialogs.has_list);
  EXPECT_EQ(text("joint"), joints[2].value);
  EXPECT_EQ(modal(), Modal::kForm);
  Press(kEnter);
  EXPECT_EQ(modal(), Modal::kNone) << user_.editor().dialogs.form.error;
  EXPECT_EQ(user_.project().holds.at(0).joint, joints[2].value);
}

TEST_F(KeysInForms, AShortListIsLedThroughByArrowsToo) {
  for (const char* name : {"a", "b", "c"}) {
    ASSERT_TRUE(user_.session()
                    .Run("object.add_box", {{"name", name},
                                            {"x", 0},
                                            {"y", 0},
                                            {"z", 1},
                                            {"size_x", 1},
                                            {"size_y", 1},
                                            {"size_z", 1}})
                    .ok());
  }
  Open("object.remove");
  Press(kSpace);
  ASSERT_TRUE(user_.editor().dialogs.has_list);
  const std::string before = text("object");
  Press(kDown);
  Press(kEnter);
  EXPECT_FALSE(user_.editor().dialogs.has_list);
  EXPECT_EQ(modal(), Modal::kForm);
  EXPECT_NE(text("object"), before);
}

TEST_F(KeysInForms, TicksAreSetBySpaceWhereArrowsLead) {
  Open("region.add");
  for (int i = 0; i < 3; ++i) Press(kTab);  // over both frames and the buttons above the ticks
  const std::string before = text("joints");
  Press(kDown);
  Press(kSpace);
  EXPECT_NE(text("joints"), before);
  EXPECT_EQ(modal(), Modal::kForm);
}

}  // namespace
}  // namespace hazumi::ui
