#include "ui/panels/commands/search.h"

#include <gtest/gtest.h>

#include "ui/panels/commands/actions.h"
#include "ui/panels/commands/menus.h"
#include "ui/panels/forms/parameter_form.h"

namespace hazumi::ui {
namespace {

std::string FirstFor(const std::string& query) {
  const std::vector<Command> found = Search(AllCommands(), query);
  return found.empty() ? "" : found[0].id;
}

TEST(Search, FindsByTheWordsOfALabelInAnyOrder) {
  SetLanguage(Language::kEnglish);
  EXPECT_EQ(FirstFor("undo"), "edit.undo");
  EXPECT_EQ(FirstFor("region dyn add"), "region.add");
  EXPECT_EQ(FirstFor("BAKE"), "region.to_keys");
  EXPECT_EQ(FirstFor("xyzzy"), "");
}

TEST(Search, FindsInJapaneseAndStillInEnglish) {
  SetLanguage(Language::kJapanese);
  EXPECT_EQ(FirstFor("元に戻す"), "edit.undo");
  EXPECT_EQ(FirstFor("undo"), "edit.undo");
  SetLanguage(Language::kEnglish);
}

TEST(Search, OffersWhatItsKeysDoWithTheirParameters) {
  const std::vector<Command> found = Search(AllCommands(), "paste flipped");
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].parameters, (Json{{"flipped", true}}));
}

TEST(Menus, EveryEntryIsSomethingThatCanBeDoneAndHasATooltip) {
  for (const MenuEntry& entry : FlatMenus()) {
    const std::string id = entry.id;
    EXPECT_TRUE(FindAction(id) || edit::FindOperator(id)) << id;
    EXPECT_NE(std::string(HelpOf(id)), "") << id;
    Json given = entry.parameters;
    std::vector<edit::ParameterInfo> infos = ParametersOf(id);
    for (edit::ParameterInfo& info : infos) info.is_required = false;
    EXPECT_TRUE(edit::Parameters::Check(infos, given).ok()) << id << given.dump();
  }
}

TEST(Menus, UndoSaysWhatAndIsGreyWhereThereIsNothing) {
  Editor editor;
  const MenuEntry undo = {"edit.undo"};
  EXPECT_FALSE(CanDo(editor, "edit.undo"));
  ASSERT_TRUE(editor.Do("pose.rotate", {{"joint", "l_elbow_flexion"}, {"to", 30}}));
  EXPECT_TRUE(CanDo(editor, "edit.undo"));
  EXPECT_EQ(LabelOf(undo, editor), "Undo: Rotate joint");
}

TEST(Menus, NothingIsMutedWhereThereIsNoRegion) {
  Editor editor;
  EXPECT_FALSE(CanDo(editor, "sheet.mute"));
  ASSERT_TRUE(editor.Do("region.add", {{"first", 2}, {"last", 9}, {"joints", {"r_elbow"}}}));
  EXPECT_TRUE(CanDo(editor, "sheet.mute"));
}

TEST(ParameterForm, AsksForWhatIsMissingAndSuggestsTheFrame) {
  edit::Session session;
  session.set_frame(7.0);
  EXPECT_TRUE(NeedsForm("region.add", Json::object()));
  EXPECT_FALSE(NeedsForm("region.add", {{"first", 1}, {"last", 2}}));
  FormState form = MakeForm("region.add", Json::object(), &session);
  ASSERT_EQ(std::string(form.fields[0].info.name), "first");
  EXPECT_EQ(form.fields[0].text, "7");
  EXPECT_EQ(form.fields[1].text, "30");
  for (FormField& field : form.fields) {
    if (std::string(field.info.name) == "joints") field.text = "l_shoulder+, r_wrist";
  }
  const Result<Json> values = ValuesOf(form);
  ASSERT_TRUE(values.ok());
  EXPECT_EQ(values.value(), (Json{{"first", 7.0},
                                  {"last", 30.0},
                                  {"joints", {"l_shoulder+", "r_wrist"}},
                                  {"friction", 0.8}}));
}

TEST(ParameterForm, SaysWhichNumberIsNone) {
  edit::Session session;
  FormState form = MakeForm("scene.gravity", Json::object(), &session);
  form.fields[0].text = "9,81";
  const Result<Json> values = ValuesOf(form);
  ASSERT_FALSE(values.ok());
  EXPECT_EQ(values.error().ToString(), "gravity: \"9,81\" must be a number");
}

}  // namespace
}  // namespace hazumi::ui
