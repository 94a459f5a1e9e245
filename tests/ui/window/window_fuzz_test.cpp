#include <gtest/gtest.h>
#include <unistd.h>

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <csignal>
#include <ctime>
#include <deque>
#include <fstream>
#include <random>

#include "tests/support/memory.h"
#include "tests/support/random_cases.h"
#include "tests/support/sanitized.h"
#include "tests/ui/run_fixture.h"
#include "ui/charts/charts_panel.h"
#include "ui/program_text/program_panel.h"
#include "ui/runs/runs_view.h"
#include "ui/shared/panel_action.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/help_menu.h"

namespace feedscope::ui {
namespace {

const int max_actions = test::random_cases(1000);
constexpr std::size_t last_actions = 25;
constexpr double max_seconds = 10;  // of processor time that one action may take, what it starts included
constexpr std::size_t max_bytes = 600 * test::megabyte;
constexpr std::size_t max_runs = 5;

/// What was done last, for who has to do it again; a crash says it too.
class Diary {
 public:
  explicit Diary(unsigned seed) : seed_(seed) {
    open_ = this;
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
      std::signal(signal, [](int number) {
        const std::string text = open_ == nullptr ? "" : open_->text();
        [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
        std::signal(number, SIG_DFL);
        std::raise(number);
      });
    }
  }
  ~Diary() {
    open_ = nullptr;
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
      std::signal(signal, SIG_DFL);
    }
  }
  void add(const std::string& action) {
    ++count_;
    actions_.push_back(action);
    if (actions_.size() > last_actions) {
      actions_.pop_front();
    }
  }
  std::string text() const {
    std::string text = "FEEDSCOPE_FUZZ_SEED=" + std::to_string(seed_) + ", action " + std::to_string(count_) +
                       ", the last ones:\n";
    for (const std::string& action : actions_) {
      text += "  " + action + "\n";
    }
    return text;
  }

 private:
  inline static const Diary* open_ = nullptr;
  unsigned seed_;
  int count_ = 0;
  std::deque<std::string> actions_;
};

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Keys, mouse and commands at random, on the whole window with programs and several runs in it. Memory and
/// time are watched; what comes of it must only not fail.
class WindowFuzz : public testing::Test {
 protected:
  WindowFuzz() {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName("feedscope_test");
    QDir::setCurrent(folder.path());  // what a dialog saves by chance
    write("corners.nc", test::small_program);
    write("wrong.nc", "G21 G90 F1000\nG1 X10\nG1 X Y5 QQ\nG77 X3\nG2 X20 Y20 I1\nG1 X30\nM30\n");
    write("empty.nc", "");
    write("rapids.h",
          "BEGIN PGM A MM\nL X+0 Y+0 Z+5 R0 FMAX\nL X+50 F800\nL Y+40\nL Z+90 FMAX\nEND PGM A MM\n");
    std::string zigzag = "G21 G90 F4000\n";
    for (int i = 0; i < 400; ++i) {
      zigzag += "G1 X" + std::to_string(i % 7) + " Y" + std::to_string(0.3 * i) + "\n";
    }
    write("zigzag.nc", zigzag);
    window.resize(800, 600);
    window.show();
    answer_dialogs();
  }
  ~WindowFuzz() override {
    QDir::setCurrent(QDir::tempPath());
    QCoreApplication::setOrganizationName({});
  }

  void write(const char* name, const std::string& text) {
    std::ofstream(folder.filePath(name).toStdString()) << text;
    programs.push_back(folder.filePath(name).toStdString());
  }

  /// Begins anew before it answers, since an answer may open a further dialog.
  void answer_dialogs() {
    QTimer::singleShot(0, &window, [this] {
      answer_dialogs();
      close_dialogs();
    });
  }

  /// A menu or a dialog waits for an answer: any.
  void close_dialogs() {
    if (QWidget* popup = QApplication::activePopupWidget()) {
      popup->close();
    }
    if (QWidget* dialog = QApplication::activeModalWidget()) {
      if (auto* files = qobject_cast<QFileDialog*>(dialog)) {
        files->setDirectory(folder.path());  // not beside a sample that was opened from the start page
      }
      if (!dialog->isVisible() || any(3) > 0) {
        dialog->close();
      } else {
        QWidget* focus = dialog->focusWidget() != nullptr ? dialog->focusWidget() : dialog;
        QTest::keyClick(focus, any(2) == 0 ? Qt::Key_Return : Qt::Key_Tab);
      }
    }
  }

  std::size_t any(std::size_t count) { return random() % std::max<std::size_t>(count, 1); }

  QWidget* any_widget() {
    QList<QWidget*> shown;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
      if (widget->isVisible() && widget->isEnabled() && !widget->size().isEmpty()) {
        shown.append(widget);
      }
    }
    // Half of all on what has most of the window.
    QList<QWidget*> large{&window.scene().canvas(), &window.part<ChartsPanel>().chart(any(3)),
                          &window.part<ProgramPanel>().view(), window.part<RunsView>().table()->viewport()};
    QWidget* chosen = any(2) == 0
                          ? large[static_cast<qsizetype>(any(4))]
                          : shown[static_cast<qsizetype>(any(static_cast<std::size_t>(shown.size())))];
    return chosen->isVisible() ? chosen : &window;
  }
  static std::string name_of(const QWidget& widget) {
    return std::string(widget.metaObject()->className()) + " \"" + widget.objectName().toStdString() + "\"";
  }
  QPoint any_place(const QWidget& widget) {
    return {static_cast<int>(any(static_cast<std::size_t>(widget.width()))),
            static_cast<int>(any(static_cast<std::size_t>(widget.height())))};
  }
  Qt::KeyboardModifiers any_modifiers() {
    constexpr std::array modifiers{Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::ControlModifier,
                                   Qt::ShiftModifier};
    return modifiers[any(modifiers.size())];
  }

  std::string click() {
    QPointer<QWidget> widget = any_widget();
    const QPoint place = any_place(*widget);
    const std::string name = name_of(*widget);
    const Qt::MouseButton button = any(5) == 0 ? Qt::RightButton : Qt::LeftButton;
    switch (any(4)) {
      case 0:
        QTest::mouseDClick(widget, button, any_modifiers(), place);
        break;
      default:
        QTest::mouseClick(widget, button, any_modifiers(), place);
    }
    return "click on " + name + " at " + std::to_string(place.x()) + " " + std::to_string(place.y());
  }

  std::string drag() {
    QPointer<QWidget> widget = any_widget();
    const std::string name = name_of(*widget);
    const Qt::MouseButton button = any(3) == 0 ? Qt::RightButton : Qt::LeftButton;
    const Qt::KeyboardModifiers modifiers = any_modifiers();
    QTest::mousePress(widget, button, modifiers, any_place(*widget));
    for (int i = 0; i < 3 && widget != nullptr; ++i) {
      const QPoint place = any_place(*widget);
      QMouseEvent move(QEvent::MouseMove, place, widget->mapToGlobal(place), Qt::NoButton, button, modifiers);
      QApplication::sendEvent(widget, &move);
    }
    if (widget != nullptr) {
      QTest::mouseRelease(widget, button, modifiers, any_place(*widget));
    }
    return "drag on " + name;
  }

  std::string wheel() {
    QWidget* widget = any_widget();
    const int clicks = any(6) == 0 ? 60 : 1 + static_cast<int>(any(4));
    const int delta = any(3) == 0 ? -120 : 120;
    const QPoint place = any_place(*widget);
    const Qt::KeyboardModifiers modifiers = any_modifiers();
    for (int i = 0; i < clicks; ++i) {
      QWheelEvent event(place, widget->mapToGlobal(place), {}, {0, delta}, Qt::NoButton, modifiers,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(widget, &event);
    }
    return std::to_string(clicks) + " clicks of the wheel by " + std::to_string(delta) + " on " +
           name_of(*widget);
  }

  std::string key() {
    static const std::vector<int> keys{
        Qt::Key_Escape, Qt::Key_Return, Qt::Key_Tab, Qt::Key_Left,   Qt::Key_Right,  Qt::Key_Up,
        Qt::Key_Down,   Qt::Key_Home,   Qt::Key_End, Qt::Key_PageUp, Qt::Key_Delete, Qt::Key_Space,
        Qt::Key_B,      Qt::Key_C,      Qt::Key_G,   Qt::Key_M,      Qt::Key_P,      Qt::Key_T,
        Qt::Key_Z,      Qt::Key_0,      Qt::Key_1,   Qt::Key_2,      Qt::Key_8,      Qt::Key_9,
        Qt::Key_Comma,  Qt::Key_Period, Qt::Key_F3,  Qt::Key_F6,     Qt::Key_F7,     Qt::Key_F8,
        Qt::Key_F9};
    QWidget* widget =
        QApplication::focusWidget() != nullptr && any(2) == 0 ? QApplication::focusWidget() : any_widget();
    const int pressed = keys[any(keys.size())];
    const Qt::KeyboardModifiers modifiers = any_modifiers();
    const std::string text = QKeySequence(pressed | static_cast<int>(modifiers)).toString().toStdString();
    const std::string name = name_of(*widget);
    QTest::keyClick(widget, static_cast<Qt::Key>(pressed), modifiers);
    return "key " + text + " on " + name;
  }

  std::string typing() {
    static const std::vector<const char*> texts{"0.02", "0,05", "-1", "1e9",         "abc",
                                                "",     "17",   "0",  "999999999999"};
    QList<QWidget*> fields;
    for (QWidget* field : window.findChildren<QWidget*>()) {
      if (field->isVisible() && field->isEnabled() && field->inherits("QLineEdit")) {
        fields.append(field);
      }
    }
    if (fields.isEmpty()) {
      return "no field to type into";
    }
    QPointer<QWidget> field = fields[static_cast<qsizetype>(any(static_cast<std::size_t>(fields.size())))];
    const std::string name = name_of(*field->parentWidget());
    const char* text = texts[any(texts.size())];
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    if (field != nullptr) {
      QTest::keyClick(field, Qt::Key_Return);
    }
    return std::string("type \"") + text + "\" into " + name;
  }

  std::string command() {
    const QList<ListedAction> commands = window.part<HelpMenu>().commands();
    const ListedAction& listed =
        commands[static_cast<qsizetype>(any(static_cast<std::size_t>(commands.size())))];
    const std::string text = plain_text(listed.action->text()).toStdString();
    if (text == "Quit" || !listed.action->isEnabled()) {
      return "no command";
    }
    listed.action->trigger();
    return "command " + text;
  }

  std::string runs() {
    RunList& list = model.runs();
    while (list.items().size() > max_runs) {
      list.remove(any(list.items().size()));
    }
    switch (any(6)) {
      case 0:
        list.duplicate(any(list.items().size()));
        return "duplicate";
      case 1:
        list.select(any(list.items().size()));
        return "select";
      case 2:
        model.set_tolerance(0.01 * static_cast<double>(1 + any(5)));
        return "tolerance";
      case 3:
        window.open(programs[any(programs.size())]);
        return "open";
      case 4:
        model.choose_model(QString::fromStdString(all_models()[any(all_models().size())]->info().id));
        return "model";
      default:
        window.resize(400 + static_cast<int>(any(600)), 300 + static_cast<int>(any(400)));
        return "resize";
    }
  }

  std::string act() {
    switch (any(12)) {
      case 0:
      case 1:
      case 2:
        return click();
      case 3:
      case 4:
        return drag();
      case 5:
        return wheel();
      case 6:
      case 7:
        return key();
      case 8:
        return typing();
      case 9:
        return command();
      default:
        return runs();
    }
  }

  std::minstd_rand random;
  const QTemporaryDir folder;
  std::vector<std::filesystem::path> programs;
  Workbench model{shipped_machines(), make_setup({})};
  MainWindow window{model, RenderBackend::software};
};

TEST_F(WindowFuzz, RandomActionsNeitherFailNorGrow) {
  const QByteArray asked = qgetenv("FEEDSCOPE_FUZZ_SEED");
  const unsigned seed = asked.isEmpty() ? 1U : asked.toUInt();
  random.seed(seed);
  Diary diary(seed);
  model.open(programs.front());
  for (int i = 0; i < max_actions && !HasFailure(); ++i) {
    const double before = processor_seconds();
    diary.add(act());
    if (!window.isVisible()) {
      window.show();
    }
    QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
    const double used = processor_seconds() - before;
    EXPECT_LT(used, max_seconds) << diary.text();
    EXPECT_TRUE(test::sanitized || test::resident_bytes() < max_bytes) << diary.text();
    const auto shown = model.shown();
    EXPECT_TRUE(shown == nullptr || shown->run.setup == model.runs().setup(model.runs().current_item()))
        << diary.text();
  }
  model.cancel();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !model.busy() && !window.busy(); }, 60000)) << diary.text();
}

}  // namespace
}  // namespace feedscope::ui
