#include "ui/language/operation_title.h"

#include <gtest/gtest.h>

#include "ui/language/language.h"

namespace feedscope::ui {
namespace {

std::string shown(const std::string& title, std::uint32_t line, OperationSplit split) {
  return operation_title(title, line, split).toStdString();
}

TEST(OperationTitle, IsTheCommentOrTheToolAndInTheLanguageOfTheUserWhereThereIsNone) {
  EXPECT_EQ(shown("tool T4 R", 9, OperationSplit::tool), "Tool T4 R");
  EXPECT_EQ(shown("start", 1, OperationSplit::tool), "Before the first tool");
  EXPECT_EQ(shown("start", 1, OperationSplit::comment), "Before the first comment");
  EXPECT_EQ(shown("line 12", 12, OperationSplit::comment), "Line 12");
  EXPECT_EQ(shown("line 12", 40, OperationSplit::comment), "line 12") << "so the comment of line 40 says";
  speak(QStringLiteral("fr"));
  EXPECT_EQ(shown("start", 1, OperationSplit::comment), "Avant le premier commentaire");
  EXPECT_EQ(shown("line 12", 12, OperationSplit::comment), "Ligne 12");
  EXPECT_EQ(shown("FINISH", 12, OperationSplit::comment), "FINISH");
  speak(QStringLiteral("en"));
}

}  // namespace
}  // namespace feedscope::ui
