#include "ui/session/autosave.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "core/base/this_process.h"

namespace feedscope::ui {
namespace {

class AutosaveTest : public testing::Test {
 protected:
  QString file(const QString& name) const { return folder_.filePath(name); }
  /// As a process that was killed leaves it.
  void leave(const QString& name) const {
    QFile session(file(name));
    ASSERT_TRUE(session.open(QIODevice::WriteOnly));
    session.write("{}");
  }
  int files() const { return static_cast<int>(QDir(folder_.path()).entryList(QDir::Files).size()); }

  QTemporaryDir folder_;
};

TEST_F(AutosaveTest, WhatIsKeptGoesWithAnOrderlyEnd) {
  {
    Autosave autosave(folder_.path());
    EXPECT_TRUE(autosave.keep("one"));
    EXPECT_TRUE(autosave.keep("two"));
    EXPECT_GT(files(), 0);
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveTest, AnothersIsFoundOnceItIsGone) {
  leave("12345.feedscope");
  const Autosave autosave(folder_.path());
  const auto left = autosave.left_behind();
  ASSERT_TRUE(left);
  EXPECT_EQ(left->file.filename(), "12345.feedscope");
  Autosave::discard(*left);
  EXPECT_FALSE(autosave.left_behind());
  EXPECT_EQ(files(), 0);
}

/// Of several that start together one restores it.
TEST_F(AutosaveTest, WhatOneHasFoundNoOtherFinds) {
  leave("older.feedscope");
  const Autosave first(folder_.path());
  const Autosave second(folder_.path());
  auto found = first.left_behind();
  ASSERT_TRUE(found);
  EXPECT_FALSE(second.left_behind());
  found.reset();
  auto given_back = second.left_behind();
  ASSERT_TRUE(given_back);
  EXPECT_FALSE(first.left_behind());
  Autosave::discard(*given_back);
  EXPECT_FALSE(first.left_behind());
  given_back.reset();
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveTest, WhatAProcessOfTheSameNumberLeftIsNotOverwritten) {
  const QString name = QStringLiteral("%1.feedscope").arg(process_id());
  leave(name);
  Autosave autosave(folder_.path());
  ASSERT_TRUE(autosave.keep("mine"));
  const auto left = autosave.left_behind();
  ASSERT_TRUE(left);
  EXPECT_EQ(left->file.filename(), name.toStdString());
}

TEST_F(AutosaveTest, ItsOwnIsNotLeftBehind) {
  Autosave autosave(folder_.path());
  ASSERT_TRUE(autosave.keep("mine"));
  EXPECT_FALSE(autosave.left_behind());
}

TEST_F(AutosaveTest, AFolderThatCannotBeMadeKeepsNothing) {
  leave("file");
  Autosave autosave(file("file/below"));
  EXPECT_FALSE(autosave.keep("x"));
  EXPECT_FALSE(autosave.left_behind());
}

}  // namespace
}  // namespace feedscope::ui
