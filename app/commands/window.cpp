#include <fmt/format.h>

#include <QApplication>
#include <QScreen>
#include <QSettings>
#include <cstdlib>
#include <memory>
#include <string>

#include "app/commands/command.h"
#include "app/exit_codes.h"
#include "app/window_start.h"
#include "core/base/error.h"
#include "ui/language/language.h"
#include "ui/main_window.h"
#include "ui/models/recent_files.h"
#include "ui/panel_states.h"
#include "ui/theme/theme.h"

namespace feedscope {
namespace {

constexpr const char* picture_instead =
    "for a picture of it use: feedscope render FILE --view window --out FILE.png";

void check_display() {
  const auto set = [](const char* name) { return !qEnvironmentVariableIsEmpty(name); };
  if (!set("DISPLAY") && !set("WAYLAND_DISPLAY") && !set("QT_QPA_PLATFORM")) {
    throw InputError(fmt::format(
        "the window needs a display, and neither DISPLAY nor WAYLAND_DISPLAY is set; {}", picture_instead));
  }
}

/// Qt's fatal messages end in abort(); the one that happens is a display that cannot be reached.
void leave_on_fatal(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type == QtFatalMsg) {
    fmt::print(stderr, "feedscope: the window cannot be opened; {}\n", picture_instead);
    std::_Exit(exit_code::wrong_use);
  }
  fmt::print(stderr, "feedscope: {}\n", message.toStdString());
}

/// What a window may have of a screen, with a frame around it.
QSize room_on(const QScreen& screen) {
  constexpr QSize frame(16, 48);
  return screen.availableSize() - frame;
}

int show_window(const RunOptions& options, const std::string& lesson) {
  const WindowStart start(options, lesson);
  check_display();
  qInstallMessageHandler(leave_on_fatal);
  int count = 1;
  char name[] = "feedscope";
  char* arguments[] = {name, nullptr};
  QApplication application(count, arguments);
  QApplication::setApplicationName("Feedscope");
  QApplication::setOrganizationName("Feedscope");
  QApplication::setDesktopFileName("feedscope");
  ui::install_language(ui::chosen_language());
  ui::apply_theme(QSettings().value("dark", false).toBool() ? ui::ThemeKind::dark : ui::ThemeKind::light);

  ui::Workbench model(shipped_machines(), make_setup({}));
  ui::MainWindow window(model, ui::default_backend());
  QObject::connect(&model, &ui::Workbench::program_changed, [&model, &window] {
    if (model.program() != nullptr) {
      const auto& shown = window.session().file().empty() ? model.file() : window.session().file();
      ui::RecentFiles::add(QString::fromStdU16String(shown.u16string()));
    }
  });
  QSettings settings;
  window.resize(window.size().boundedTo(room_on(*window.screen())));
  window.restoreGeometry(settings.value("geometry").toByteArray());
  window.restore_layout(settings.value("layout").toByteArray());
  ui::restore_panel_states(window);
  window.show();
  window.session().begin_keeping();
  start.show(window, model);
  const int code = QApplication::exec();
  settings.setValue("geometry", window.saveGeometry());
  settings.setValue("layout", window.saveState());
  ui::keep_panel_states(window);
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
  app.add_option("--lesson", *lesson, "Open the window with a lesson, as 'feedscope lessons' lists them")
      ->type_name("ID|FILE")
      ->excludes(program);
  return {&app, [options, lesson] {
            move_tolerance(*options);
            return show_window(*options, *lesson);
          }};
}

}  // namespace feedscope
