#include <fmt/format.h>

#include <QApplication>
#include <QScreen>
#include <QSettings>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "app/desktop.h"
#include "app/exit_codes.h"
#include "app/window_start.h"
#include "core/base/error.h"
#include "ui/language/language.h"
#include "ui/language/shown_numbers.h"
#include "ui/shared/paths.h"
#include "ui/theme/theme.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/presentation.h"
#include "ui/window/panels/panel_states.h"
#include "ui/workbench/recent_files.h"

namespace feedscope {
namespace {

constexpr const char* picture_instead =
    "for a picture of it use: feedscope render FILE --view window --out FILE.png";

/// Qt ends fatal messages with abort(); in practice the cause is an unreachable display.
void leave_on_fatal(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtFatalMsg) {
    fmt::print(stderr, "feedscope: the window cannot be opened; {}\n", picture_instead);
    std::_Exit(exit_code::wrong_use);
  }
  fmt::print(stderr, "feedscope: {}\n", message.toStdString());
}

/// Space for a window on a screen, less the window frame.
QSize room_on(const QScreen& screen) {
  constexpr QSize frame(16, 48);
  return screen.availableSize() - frame;
}

/// Exit code of a window that is to be rebuilt.
constexpr int made_again = 0x52454d;

/// Shows the window until it is closed or to be rebuilt in another language or other units; `before`: state
/// of the previous window.
int show_window(ui::Workbench& model, const WindowStart& start,
                std::optional<ui::MainWindow::Handover>& before) {
  ui::MainWindow window(model, ui::default_backend());
  QObject::connect(&model, &ui::Workbench::program_changed, &window, [&model, &window] {
    if (model.program() != nullptr) {
      const auto& shown = window.session().file().empty() ? model.file() : window.session().file();
      ui::RecentFiles::add(ui::to_qstring(shown));
    }
  });
  QObject::connect(
      &window, &ui::MainWindow::remake_wanted, &window, [] { QApplication::exit(made_again); },
      Qt::QueuedConnection);
  QSettings settings;
  window.resize(window.size().boundedTo(room_on(*window.screen())));
  window.restoreGeometry(settings.value("geometry").toByteArray());
  window.restore_layout(settings.value("layout").toByteArray());
  ui::restore_panel_states(window);
  if (before) {
    window.take_over(*before);
  }
  window.show();
  window.session().begin_keeping();
  if (!before) {
    start.show(window, model);
  }
  const int code = QApplication::exec();
  settings.setValue("geometry", window.saveGeometry());
  settings.setValue("layout", window.layout_to_keep());
  ui::keep_panel_states(window);
  before = window.hand_over();
  return code;
}

int show_window(const RunOptions& options, const std::string& lesson, const std::vector<std::string>& traces,
                bool unlocked) {
  const WindowStart start(options, lesson, traces, unlocked);
  check_display(picture_instead);
  close_own_console();
  qInstallMessageHandler(leave_on_fatal);
  int count = 1;
  char name[] = "feedscope";
  char* arguments[] = {name, nullptr};
  QApplication application(count, arguments);
  QApplication::setApplicationName("Feedscope");
  QApplication::setOrganizationName("Feedscope");
  QApplication::setDesktopFileName("feedscope");
  ui::install_language(ui::chosen_language());
  ui::use_unit_system(ui::chosen_unit_system());
  ui::apply_theme(QSettings().value("dark", false).toBool() ? ui::ThemeKind::dark : ui::ThemeKind::light);

  ui::Workbench model(shipped_machines(), make_setup({}));
  std::optional<ui::MainWindow::Handover> before;
  int code = made_again;
  while (code == made_again) {
    code = show_window(model, start, before);
    ui::install_language(ui::chosen_language());
    ui::use_unit_system(ui::chosen_unit_system());
  }
  return code;
}

}  // namespace

Command add_window_command(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  const auto lesson = std::make_shared<std::string>();
  CLI::Option* program =
      add_run_options(app, *options)
          ->required(false)
          ->description("Without a command: open the window, with this NC program or session")
          ->type_name("");
  CLI::Option* of_lesson =
      app.add_option("--lesson", *lesson, "Open the window with a lesson, as 'feedscope lessons' lists them")
          ->type_name("ID|FILE")
          ->excludes(program);
  const auto unlocked = std::make_shared<bool>(false);
  app.add_flag("--without-prediction", *unlocked,
               "For teachers: show the run of the lesson before a prediction is written")
      ->needs(of_lesson);
  const auto traces = std::make_shared<std::vector<std::string>>();
  app.add_option("--trace", *traces, "Lay what a control recorded beside the program; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  return {&app, [options, lesson, traces, unlocked] {
            move_tolerance(*options);
            return show_window(*options, *lesson, *traces, *unlocked);
          }};
}

}  // namespace feedscope
