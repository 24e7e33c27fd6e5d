// Undo steps, drags, the saved state and the memory bound.

#include "ui/edit/document/document.h"

#include <gtest/gtest.h>

#include "ui/edit/new_project.h"

namespace hazumi::test {
namespace {

using edit::Document;
using edit::GiveIds;
using edit::Transaction;

void Rename(Document* document, const std::string& name, const std::string& merge = "") {
  Transaction transaction(document);
  transaction.project().name = name;
  transaction.Commit("Rename", merge);
}

// Whatever stands before it in the project, and even if `next` has come back to its id.
TEST(GiveIds, AnItemKeepsTheIdThatItHas) {
  Project project;
  project.regions.resize(2);
  project.holds.resize(2);
  project.holds[0].identity.id = ItemId(7);
  project.holds[1].identity.id = ItemId(7);  // a copy
  int next = 7;
  GiveIds(&project, &next);
  EXPECT_EQ(project.holds[0].identity.id, ItemId(7));
  EXPECT_EQ(project.regions[0].identity.id, ItemId(8));
  EXPECT_EQ(project.regions[1].identity.id, ItemId(9));
  EXPECT_EQ(project.holds[1].identity.id, ItemId(10));
  EXPECT_EQ(next, 11);
}

TEST(Document, UndoesAndRedoesStepByStep) {
  Document document(edit::NewProject());
  for (const char* name : {"a", "b", "c"}) Rename(&document, name);
  EXPECT_EQ(document.undo_label(), "Rename");
  EXPECT_TRUE(document.Undo());
  EXPECT_TRUE(document.Undo());
  EXPECT_EQ(document.project().name, "a");
  EXPECT_TRUE(document.Redo());
  EXPECT_EQ(document.project().name, "b");
  Rename(&document, "other");
  EXPECT_FALSE(document.Redo());
  EXPECT_EQ(document.num_steps(), 3u);
}

TEST(Document, RollsBackWhatIsNotCommitted) {
  Document document(edit::NewProject());
  { Transaction(&document).project().name = "lost"; }
  EXPECT_EQ(document.project().name, "Untitled");
  EXPECT_FALSE(document.Undo());
}

TEST(Document, TakesADragAsOneStep) {
  Document document(edit::NewProject());
  for (const char* name : {"d", "dr", "drag"}) Rename(&document, name, "one");
  Rename(&document, "dragged again", "two");
  EXPECT_EQ(document.num_steps(), 2u);
  document.Undo();
  EXPECT_EQ(document.project().name, "drag");
  document.Undo();
  EXPECT_EQ(document.project().name, "Untitled");
  EXPECT_FALSE(document.Undo());
}

TEST(Document, EndsADragWhenTold) {
  Document document(edit::NewProject());
  Rename(&document, "first", "key");
  document.EndMerge();
  Rename(&document, "second", "key");
  EXPECT_EQ(document.num_steps(), 2u);
}

// What is refused is in no journal, so a replay would go on with the drag.
TEST(Document, RefusedToUndoOrRedoADragGoesOn) {
  Document document(edit::NewProject());
  Rename(&document, "a", "drag");
  EXPECT_FALSE(document.Redo());
  Rename(&document, "b", "drag");
  EXPECT_EQ(document.num_steps(), 1u);
  Rename(&document, "Untitled", "drag");
  EXPECT_FALSE(document.Undo());
  Rename(&document, "c", "drag");
  EXPECT_EQ(document.num_steps(), 1u);
  EXPECT_TRUE(document.Undo());
  EXPECT_EQ(document.project().name, "Untitled");
}

TEST(Document, ForgetsADragThatCameBack) {
  Document document(edit::NewProject());
  Rename(&document, "away", "drag");
  Rename(&document, "Untitled", "drag");
  document.EndMerge();
  EXPECT_EQ(document.num_steps(), 0u);
  EXPECT_TRUE(document.is_saved());
}

TEST(Document, KnowsWhetherItIsSaved) {
  Document document(edit::NewProject());
  EXPECT_TRUE(document.is_saved());
  Rename(&document, "a");
  EXPECT_FALSE(document.is_saved());
  document.MarkSaved("a.kfa");
  EXPECT_TRUE(document.is_saved());
  document.Undo();
  EXPECT_FALSE(document.is_saved());
  document.Redo();
  EXPECT_TRUE(document.is_saved());
  document.Undo();
  Rename(&document, "b");  // the saved state can no longer be reached
  EXPECT_FALSE(document.is_saved());
  document.Undo();
  EXPECT_FALSE(document.is_saved());
}

TEST(Document, KeepsToItsMemoryBound) {
  Document document(edit::NewProject());
  constexpr size_t kLimit = 20000;
  document.set_history_limit(kLimit);
  for (int i = 0; i < 1000; ++i) {
    Rename(&document,
           "a name that is a hundred characters long" + std::string(60, '.') + std::to_string(i));
    EXPECT_LE(document.history_bytes(), kLimit);
  }
  EXPECT_GT(document.num_steps(), 5u);
  const size_t steps = document.num_steps();
  for (size_t i = 0; i < steps; ++i) EXPECT_TRUE(document.Undo());
  EXPECT_FALSE(document.Undo());
  EXPECT_FALSE(document.is_saved());
  for (size_t i = 0; i < steps; ++i) EXPECT_TRUE(document.Redo());
  EXPECT_TRUE(document.project().name.ends_with(".999"));
}

}  // namespace
}  // namespace hazumi::test
