#include "ui/window/window_session.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFileDialog>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <fstream>

#include "tests/ui/answer_next.h"
#include "tests/ui/patience.h"
#include "tests/ui/run_fixture.h"
#include "tests/ui/trace_fixture.h"
#include "ui/annotations/annotations_view.h"
#include "ui/charts/charts_panel.h"
#include "ui/lessons/lesson_view.h"
#include "ui/session/session_json.h"
#include "ui/window/main_window.h"

namespace feedscope::ui {
namespace {

using test::answer_next;

struct Window {
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};

  Window() {
    window.resize(1280, 800);
    window.show();
  }
  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && model.shown() != nullptr; }, patience));
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model.traces().busy(); }, patience));
    QCoreApplication::processEvents();
  }
};

/// Gives a name without its suffix where a file is to be named next; an empty one: gives up.
void name_next_file(const QString& name) {
  QTimer::singleShot(0, [name] {
    if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
      dialog->selectFile(name);
      QMetaObject::invokeMethod(dialog, name.isEmpty() ? "reject" : "accept");
    } else {
      name_next_file(name);
    }
  });
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class WindowSessionTest : public testing::Test {
 protected:
  WindowSessionTest() {
    QLocale::setDefault(QLocale::c());
    std::ofstream(program_) << test::small_program;
  }

  /// As a user would set it up.
  void set_up(Window& w) {
    w.window.open(program_);
    w.wait();
    w.model.set_tolerance(0.02);
    w.model.runs().duplicate(0);
    w.model.set_tolerance(0.005);
    w.wait();
    const double duration = w.model.shown()->run.trajectory->duration();
    w.model.cursor().set_time(duration / 3);
    w.window.scene().scene().set_standard_view(StandardView::top);
    w.window.part<ChartsPanel>().range().show(duration / 4, duration / 2);
    w.window.part<AnnotationsView>()
        .panel_actions()[static_cast<qsizetype>(AnnotationKind::callout)]
        ->trigger();
  }

  /// With what was set up, as it is in file_.
  void open_saved(Window& w) {
    set_up(w);
    write_session(w.window.session().capture(), file_);
    w.model.annotations().replace({});
    w.model.runs().remove(1);
    w.window.open(file_);
    w.wait();
  }

  /// As another window saves it: without annotations. What the file holds then.
  static std::string save_elsewhere(Window& w, const std::filesystem::path& file) {
    Session session = w.window.session().capture();
    session.annotations.clear();
    write_session(session, file);
    return text_of(file);
  }

  QTemporaryDir folder_;
  /// Of a window that set it up, wrote it to file_ and closed.
  Session saved_by_another() {
    Window first;
    set_up(first);
    Session saved = first.window.session().capture();
    write_session(saved, file_);
    return saved;
  }

  std::filesystem::path program_ = std::filesystem::path(folder_.path().toStdString()) / "part.nc";
  std::filesystem::path file_ = std::filesystem::path(folder_.path().toStdString()) / "part.feedscope";
};

TEST_F(WindowSessionTest, TracesComeBackWithTheirNames) {
  const test::WrittenFiles files;
  {
    Window first;
    first.window.open(program_);
    first.wait();
    first.model.traces().add(files.write("scope.csv", test::trace_table(first.model.shown()->run)));
    first.model.traces().rename(0, "first part");
    first.model.traces().set_visible(0, false);
    first.wait();
    ASSERT_EQ(first.model.traces().status(0), TraceStatus::compared);
    write_session(first.window.session().capture(), file_);
    EXPECT_FALSE(first.window.session().changed());
  }
  Window second;
  second.window.open(file_);
  second.wait();
  ASSERT_EQ(second.model.traces().items().size(), 1U);
  EXPECT_EQ(second.model.traces().items()[0].name, QStringLiteral("first part"));
  EXPECT_FALSE(second.model.traces().items()[0].visible);
  EXPECT_EQ(second.model.traces().status(0), TraceStatus::compared);
  EXPECT_FALSE(second.window.session().changed());
  second.model.traces().remove(0);
  EXPECT_TRUE(second.window.session().changed());
}

TEST_F(WindowSessionTest, ATraceThatIsGoneStaysInTheListAndIsReported) {
  Session session = saved_by_another();
  session.traces = {{0, file_.parent_path() / "gone.csv", "", "gone", Qt::red, true}};
  write_session(session, file_);
  Window second;
  QSignalSpy failed(&second.model, &Workbench::failed);
  second.window.open(file_);
  second.wait();
  ASSERT_EQ(second.model.traces().items().size(), 1U);
  EXPECT_EQ(second.model.traces().status(0), TraceStatus::failed);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains("gone.csv"));
  EXPECT_EQ(second.window.session().capture().traces.size(), 1U);
}

TEST_F(WindowSessionTest, AnotherWindowShowsTheSame) {
  const Session saved = saved_by_another();
  Window second;
  second.window.open(file_);
  second.wait();
  Session again = second.window.session().capture();
  ASSERT_TRUE(again.charts.time);
  EXPECT_DOUBLE_EQ(again.charts.time->lower, saved.charts.time->lower);  // but for rounding
  EXPECT_DOUBLE_EQ(again.charts.time->upper, saved.charts.time->upper);
  again.charts.time = saved.charts.time;
  const std::filesystem::path folder = file_.parent_path();
  EXPECT_EQ(session_bytes(again, folder).toStdString(), session_bytes(saved, folder).toStdString());
  EXPECT_EQ(second.window.session().file(), file_);
  EXPECT_TRUE(second.window.windowTitle().startsWith("part.feedscope"));
}

TEST_F(WindowSessionTest, KnowsWhetherThereIsSomethingToSave) {
  Window w;
  EXPECT_FALSE(w.window.session().changed());
  w.window.open(program_);
  w.wait();
  EXPECT_FALSE(w.window.session().changed());
  set_up(w);
  EXPECT_TRUE(w.window.session().changed());
  write_session(w.window.session().capture(), file_);
  w.model.annotations().replace({});
  w.model.runs().remove(1);
  w.window.open(file_);
  w.wait();
  EXPECT_FALSE(w.window.session().changed());
  w.model.annotations().remove(w.model.annotations().items().at(0).id);
  EXPECT_TRUE(w.window.session().changed());
}

TEST_F(WindowSessionTest, ASessionThatCannotBeUsedChangesNothingAndIsReported) {
  Window w;
  w.window.open(program_);
  w.wait();
  std::ofstream(file_) << "{\"format\": \"feedscope-session\", \"version\": 99}";
  QSignalSpy failed(&w.window.session(), &WindowSession::failed);
  w.window.open(file_);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains("newer Feedscope"));
  EXPECT_NE(w.model.shown(), nullptr);
  EXPECT_EQ(w.model.file(), program_);
}

TEST_F(WindowSessionTest, AProgramOfANameThatTheSystemDoesNotTakeIsNotFound) {
  Window w;
  w.window.open(program_);
  w.wait();
  Session session = w.window.session().capture();
  session.program = folder_.filePath(QString(5000, 'x')).toStdString();
  write_session(session, file_);
  QSignalSpy failed(&w.window.session(), &WindowSession::failed);
  int asked = 0;
  answer_next(QMessageBox::AcceptRole, asked);
  name_next_file({});
  w.window.open(file_);
  EXPECT_EQ(asked, 1);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains("part.feedscope is not opened"));
  EXPECT_EQ(w.model.file(), program_);
}

TEST_F(WindowSessionTest, AProgramOpenedByItselfLeavesTheSession) {
  Window w;
  set_up(w);
  write_session(w.window.session().capture(), file_);
  w.model.annotations().replace({});
  w.model.runs().remove(1);
  w.window.open(file_);
  w.wait();
  w.window.open(program_);
  w.wait();
  EXPECT_TRUE(w.window.session().file().empty());
}

TEST_F(WindowSessionTest, WhatAnotherWindowSavedIsNotOverwrittenUnasked) {
  Window w;
  open_saved(w);
  WindowSession& session = w.window.session();
  int asked = 0;

  std::string of_another = save_elsewhere(w, file_);
  answer_next(QMessageBox::RejectRole, asked);
  EXPECT_FALSE(session.save());
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(text_of(file_), of_another);

  answer_next(QMessageBox::AcceptRole, asked);
  name_next_file("mine");
  EXPECT_TRUE(session.save());
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(text_of(file_), of_another);
  const std::filesystem::path mine = file_.parent_path() / "mine.feedscope";
  ASSERT_EQ(session.file(), mine);
  EXPECT_EQ(read_session_file(mine).session.annotations.size(), 1U);

  of_another = save_elsewhere(w, mine);
  answer_next(QMessageBox::DestructiveRole, asked);
  EXPECT_TRUE(session.save());
  EXPECT_EQ(asked, 3);
  EXPECT_NE(text_of(mine), of_another);
  EXPECT_EQ(read_session_file(mine).session.annotations.size(), 1U);
}

TEST_F(WindowSessionTest, WhatThisWindowReadOrWroteIsOverwrittenUnasked) {
  Window w;
  open_saved(w);
  int asked = 0;
  const auto saves_unasked = [&asked](WindowSession& session) {
    answer_next(QMessageBox::RejectRole, asked);
    const bool saved = session.save();
    QCoreApplication::processEvents();
    return saved && asked == 0;
  };
  EXPECT_TRUE(saves_unasked(w.window.session())) << "as it was read";
  w.model.annotations().replace({});
  EXPECT_TRUE(saves_unasked(w.window.session())) << "as it was written";
  std::filesystem::remove(file_);
  EXPECT_TRUE(saves_unasked(w.window.session())) << "nothing is there any more";
  MainWindow again(w.model, RenderBackend::software);
  again.take_over(w.window.hand_over());
  EXPECT_TRUE(saves_unasked(again.session())) << "in another language or other units";
}

/// The view of a session belongs to a simulated run; until that is there it is not on the screen.
TEST_F(WindowSessionTest, ASessionSavedBeforeItIsSimulatedKeepsItsView) {
  const Session saved = saved_by_another();
  Window w;
  w.window.open(file_);
  ASSERT_EQ(w.model.shown(), nullptr);
  const Session soon = w.window.session().capture();
  EXPECT_EQ(soon.cursor, saved.cursor);
  EXPECT_EQ(to_json(soon, {})["view"], to_json(saved, {})["view"]);
  EXPECT_EQ(to_json(soon, {})["charts"], to_json(saved, {})["charts"]);
  w.wait();
}

TEST_F(WindowSessionTest, WhatCannotBeKeptIsSaidOnce) {
  Window w;
  set_up(w);
  const QString data = qEnvironmentVariable("XDG_DATA_HOME");
  std::ofstream(data.toStdString()) << "a file where the folder is to be";
  QSignalSpy failed(&w.window.session(), &WindowSession::failed);
  w.window.session().begin_keeping(std::chrono::milliseconds(1));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains(Autosave::usual_folder())) << "names the folder";
  int turns = 0;
  QTimer each;
  QObject::connect(&each, &QTimer::timeout, [&turns] { ++turns; });
  each.start(1);
  ASSERT_TRUE(QTest::qWaitFor([&turns] { return turns > 10; }, patience));
  EXPECT_EQ(failed.count(), 1);
  ASSERT_TRUE(QFile::remove(data));
  const QDir kept(Autosave::usual_folder());
  ASSERT_TRUE(
      QTest::qWaitFor([&kept] { return !kept.entryList({"*.feedscope"}, QDir::Files).isEmpty(); }, patience));
  EXPECT_EQ(failed.count(), 1);
}

TEST_F(WindowSessionTest, WhatWasLeftBehindGoesWhenItIsKeptAgain) {
  const QDir kept(Autosave::usual_folder());
  const QString left = kept.filePath("left.feedscope");
  ASSERT_TRUE(kept.mkpath("."));
  const auto files = [&kept] { return kept.entryList({"*.feedscope"}, QDir::Files); };
  {
    Window first;
    set_up(first);
    write_session(first.window.session().capture(), left.toStdString());
  }
  Window w;
  w.window.session().begin_keeping(std::chrono::hours(1));
  int asked = 0;
  answer_next(QMessageBox::YesRole, asked);
  w.window.session().offer_left_behind();
  EXPECT_EQ(asked, 1);
  w.wait();
  EXPECT_EQ(w.model.annotations().items().size(), 1U);
  EXPECT_TRUE(w.window.session().file().empty()) << "the user names it";
  EXPECT_EQ(files(), QStringList("left.feedscope"));
  w.window.session().begin_keeping(std::chrono::hours(1));  // keeps it at once
  EXPECT_EQ(files().size(), 1);
  EXPECT_FALSE(QFile::exists(left));
}

TEST_F(WindowSessionTest, WhatWasLeftBehindAndCannotBeOpenedStays) {
  const QDir kept(Autosave::usual_folder());
  ASSERT_TRUE(kept.mkpath("."));
  std::ofstream(kept.filePath("left.feedscope").toStdString()) << "{";
  Window w;
  w.window.session().begin_keeping(std::chrono::hours(1));
  QSignalSpy failed(&w.window.session(), &WindowSession::failed);
  int asked = 0;
  answer_next(QMessageBox::YesRole, asked);
  w.window.session().offer_left_behind();
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(failed.count(), 1);
  EXPECT_TRUE(QFile::exists(kept.filePath("left.feedscope")));
}

/// What a lesson replaces comes back with one press, as often as wanted; the session file is safe meanwhile.
/// Where a fitted camera stands follows the size of the view, which panels change.
QJsonObject without_fitted_places(QJsonObject session) {
  QJsonObject view = session["view"].toObject();
  QJsonObject camera = view["camera"].toObject();
  if (camera["fitted"].toBool()) {
    camera.remove("focal_mm");
    camera.remove("height_mm");
  }
  view["camera"] = camera;
  session["view"] = view;
  return session;
}

TEST_F(WindowSessionTest, WhatALessonReplacesComesBackAnyNumberOfTimes) {
  Window w;
  open_saved(w);
  const Session own = w.window.session().capture();
  LessonView& lesson = w.window.part<LessonView>();
  QAction& back = *lesson.panel_actions().last();
  EXPECT_FALSE(back.isEnabled());
  for (int time = 0; time < 3; ++time) {
    w.window.part<LessonView>().desk().unlock(true);
    w.window.open_lesson(find_lesson("8"));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          return w.model.file().filename() == "tapie_circle_2_5.nc" && !lesson.desk().value().isEmpty();
        },
        patience));
    EXPECT_TRUE(w.window.session().file().empty()) << "else the lesson would be saved over it";
    lesson.desk().choose_question(1);
    lesson.desk().move_control("5");
    w.wait();
    lesson.desk().set_up_window();
    w.wait();
    ASSERT_TRUE(back.isEnabled());
    back.trigger();
    w.wait();
    EXPECT_FALSE(back.isEnabled());
    const Session again = w.window.session().capture();
    EXPECT_EQ(again.program, own.program);
    const QJsonObject shown = without_fitted_places(to_json(again, {}));
    const QJsonObject before = without_fitted_places(to_json(own, {}));
    for (const char* key : {"runs", "current_run", "reading", "view", "compare", "annotations"}) {
      EXPECT_EQ(shown[key], before[key])
          << key << ": " << QJsonDocument(shown[key].toObject()).toJson().data()
          << QJsonDocument(before[key].toObject()).toJson().data();
    }
    EXPECT_NEAR(again.cursor, own.cursor, 1e-9);
    ASSERT_TRUE(again.charts.time && own.charts.time);
    EXPECT_NEAR(again.charts.time->lower, own.charts.time->lower, 1e-9);
    EXPECT_NEAR(again.charts.time->upper, own.charts.time->upper, 1e-9);
    EXPECT_EQ(w.window.session().file(), file_);
    EXPECT_FALSE(w.window.session().changed());
  }
}

/// They are the learner's, whatever is shown: coming back to one's own program loses nothing of them.
TEST_F(WindowSessionTest, AnswersAndTriesOfALessonAreKeptWithTheSession) {
  {
    Window w;
    open_saved(w);
    LessonDesk& desk = w.window.part<LessonView>().desk();
    w.window.part<LessonView>().desk().unlock(true);
    w.window.open_lesson(find_lesson("8"));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return w.model.file().filename() == "tapie_circle_2_5.nc" && !desk.work().tries.empty(); },
        patience));
    EXPECT_FALSE(w.window.session().changed()) << "trying is no work that one is asked for";
    desk.set_answer("All the same.");
    EXPECT_TRUE(w.window.session().changed());
    w.window.part<LessonView>().panel_actions().last()->trigger();
    w.wait();
    EXPECT_EQ(desk.work().answer, "All the same.");
    EXPECT_FALSE(desk.work().tries.empty());
    EXPECT_TRUE(w.window.session().changed());
    EXPECT_TRUE(w.window.session().save());
    EXPECT_FALSE(w.window.session().changed());
  }
  Window again;
  ASSERT_TRUE(again.window.session().open(file_));
  again.wait();
  const LessonWork& work = again.window.part<LessonView>().desk().all_work();
  ASSERT_TRUE(work.contains({"08_small_circle", 0}));
  EXPECT_EQ(work.at({"08_small_circle", 0}).answer, "All the same.");
  EXPECT_EQ(work.at({"08_small_circle", 0}).tries.size(), 1U);
  EXPECT_FALSE(again.window.session().changed());
}

TEST_F(WindowSessionTest, WhatALessonReplacedUnsavedIsAskedFor) {
  Window w;
  set_up(w);
  w.window.part<LessonView>().desk().unlock(true);
  w.window.open_lesson(find_lesson("8"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return w.model.file() != program_ && !w.model.busy(); }, patience));
  int asked = 0;
  answer_next(QMessageBox::RejectRole, asked);
  EXPECT_FALSE(w.window.session().may_go());
  EXPECT_EQ(asked, 1);
  answer_next(QMessageBox::AcceptRole, asked);
  name_next_file(QString::fromStdString(file_.string()));
  EXPECT_TRUE(w.window.session().may_go());
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(read_session_file(file_).session.runs.size(), 2U);
}

}  // namespace
}  // namespace feedscope::ui
