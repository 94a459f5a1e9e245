#include "ui/session/autosave.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

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
