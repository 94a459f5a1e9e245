#include "ui/program_text/caret.h"

#include <gtest/gtest.h>

#include "tests/ui/program_fixture.h"

namespace feedscope::ui {
namespace {

class CaretTest : public testing::Test {
 protected:
  TextPlace after(CaretStep step, bool selects = false) {
    caret.move(text, {step, selects}, 2);
    return caret.place();
  }

  ProgramText text{feedscope::test::program_of("G1 X10 Y20\nX5\n\nG1 X100 Y200\n")};
  Caret caret;
};

TEST_F(CaretTest, GoesToTheNearestPlaceThatThereIs) {
  caret.put(text, {2, 99}, false);
  EXPECT_EQ(caret.place(), (TextPlace{2, 2}));
  caret.put(text, {99, 0}, false);
  EXPECT_EQ(caret.place().line, text.line_count());
}

TEST_F(CaretTest, KeepsItsColumnAcrossShorterLines) {
  caret.put(text, {1, 8}, false);
  EXPECT_EQ(after(CaretStep::line_down), (TextPlace{2, 2}));
  EXPECT_EQ(after(CaretStep::line_down), (TextPlace{3, 0}));
  EXPECT_EQ(after(CaretStep::line_down), (TextPlace{4, 8}));
  EXPECT_EQ(after(CaretStep::page_up), (TextPlace{2, 2}));
  EXPECT_EQ(after(CaretStep::line_end), (TextPlace{2, 2}));
  EXPECT_EQ(after(CaretStep::line_up), (TextPlace{1, 2})) << "the end of the line is another column";
}

TEST_F(CaretTest, SelectsFromWhereItWasAndEndsTheSelectionWithAStepWithoutIt) {
  caret.put(text, {1, 3}, false);
  after(CaretStep::line_down, true);
  EXPECT_EQ(caret.selection(), (TextRange{{1, 3}, {2, 2}}));
  after(CaretStep::program_start, true);
  EXPECT_EQ(caret.selection(), (TextRange{{1, 0}, {1, 3}}));
  after(CaretStep::character_after);
  EXPECT_TRUE(caret.selection().empty());
  EXPECT_EQ(caret.place(), (TextPlace{1, 1}));
}

TEST_F(CaretTest, ASelectionEndsWhereItStands) {
  caret.select(text, {{1, 3}, {1, 6}});
  EXPECT_EQ(caret.place(), (TextPlace{1, 6}));
  EXPECT_EQ(text.text(caret.selection()), "X10");
}

}  // namespace
}  // namespace feedscope::ui
