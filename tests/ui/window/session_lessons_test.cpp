#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/lessons/lesson.h"
#include "tests/ui/answer_next.h"
#include "tests/ui/patience.h"
#include "tests/ui/window/small_session.h"
#include "ui/lessons/lesson_view.h"
#include "ui/session/session_file.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

using test::answer_next;

LessonWork work_with(const QString& third, const QString& fourth = {}) {
  LessonWork made;
  made[{"3", 0}].answer = third;
  if (!fourth.isEmpty()) {
    made[{"4", 1}].answer = fourth;
  }
  return made;
}

/// A window, and a session file of which lesson 3 has been worked on.
class SessionLessonsTest : public testing::Test {
 protected:
  SessionLessonsTest() { write(work_with("of the file")); }

  void write(LessonWork lessons) {
    Session session = test::small_session(folder_);
    session.lessons = std::move(lessons);
    write_session(session, file_);
  }
  WindowSession& session() { return window_.session(); }
  LessonDesk& desk() { return window_.part<LessonView>().desk(); }
  bool is_there() {
    return QTest::qWaitFor([this] { return !model_.busy() && model_.shown() != nullptr; }, patience);
  }

  QTemporaryDir folder_;
  std::filesystem::path file_ = folder_.filePath("part.feedscope").toStdString();
  Workbench model_{shipped_machines(), make_setup({})};
  MainWindow window_{model_, RenderBackend::software};
};

TEST_F(SessionLessonsTest, ALessonThatTheSessionHoldsIsTheSessionsWithoutAQuestion) {
  desk().set_all_work(work_with("of the window"));
  int asked = 0;
  answer_next(QMessageBox::YesRole, asked);
  ASSERT_TRUE(session().open(file_));
  QCoreApplication::processEvents();
  EXPECT_EQ(asked, 0);
  EXPECT_EQ(desk().all_work(), work_with("of the file"));
  EXPECT_FALSE(session().changed());
}

TEST_F(SessionLessonsTest, OfOtherLessonsItIsAskedWhetherToKeepThem) {
  desk().set_all_work(work_with("of the window", "kept"));
  int asked = 0;
  answer_next(QMessageBox::NoRole, asked);
  ASSERT_TRUE(session().open(file_));
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(desk().all_work(), work_with("of the file"));
  EXPECT_FALSE(session().changed());

  desk().set_all_work(work_with("of the window", "kept"));
  answer_next(QMessageBox::YesRole, asked);
  ASSERT_TRUE(session().open(file_));
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(desk().all_work(), work_with("of the file", "kept"));
  EXPECT_TRUE(session().changed()) << "no file holds the answer that was kept";
}

TEST_F(SessionLessonsTest, WhatIsKeptCountsAsSavedIfItWas) {
  write(work_with("of the file", "kept"));
  ASSERT_TRUE(session().open(file_));
  ASSERT_TRUE(is_there());
  write(work_with("of another file"));
  int asked = 0;
  answer_next(QMessageBox::YesRole, asked);
  ASSERT_TRUE(session().open(file_));
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(desk().all_work(), work_with("of another file", "kept"));
  EXPECT_FALSE(session().changed());
}

TEST_F(SessionLessonsTest, TheContentsOfALessonAreNotOnesOwn) {
  bool own = false;
  desk().unlock(true);
  QObject::connect(&session(), &WindowSession::aside_changed, [&](bool there) { own = there; });
  for (const char* lesson : {"4", "5"}) {
    QSignalSpy opened(&desk(), &LessonDesk::opened);
    desk().open(find_lesson(lesson), true);
    ASSERT_TRUE(opened.wait(patience)) << lesson;
    ASSERT_TRUE(QTest::qWaitFor([&] { return model_.of_lesson() && model_.program() != nullptr; }, patience));
    EXPECT_FALSE(own) << "after lesson " << lesson << " of an empty window";
  }
}

}  // namespace
}  // namespace feedscope::ui
