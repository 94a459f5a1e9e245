// Draws the window with one of its panels in front, without a display, and compares it with a baseline.
//   window_case PROGRAM MODEL PANEL THEME WxH BASELINE RESULTS
// PANEL is the name of a dock; THEME light or dark. Leaves with 77 where PROGRAM is absent.
#include <QDockWidget>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "core/base/error.h"
#include "tests/render/baseline.h"
#include "ui/main_window.h"
#include "ui/window_picture.h"

namespace feedscope::test {
namespace {

constexpr int skipped = 77;

/// Two more runs with other tolerances, and a bound on the contour error.
void add_runs(ui::Workbench& model) {
  for (const double tolerance : {0.02, 0.005}) {
    ui::SetupState setup = model.setup().state();
    setup.set("contour_tolerance_mm", tolerance);
    model.runs().duplicate_as(model.runs().current(), setup);
  }
}

void raise(ui::MainWindow& window, const std::string& panel) {
  auto* dock = window.findChild<QDockWidget*>(QString::fromStdString(panel));
  if (dock == nullptr) {
    throw InputError("no panel '" + panel + "'");
  }
  dock->show();
  dock->raise();
}

ui::Picture draw(const std::string& program, const std::string& model, const std::string& panel,
                 ui::ThemeKind theme, ui::PictureSize size) {
  const Run run = simulate_run(load_program(std::filesystem::path(program)), make_setup({"", model, {}, {}}));
  ui::WindowLook look{.theme = theme};
  look.prepare = [&panel](ui::MainWindow& window, ui::Workbench& bench) {
    if (panel == "runs") {
      add_runs(bench);
    }
    raise(window, "machine");
    raise(window, panel);
    const auto shown = bench.shown();
    bench.cursor().set_time(0.4 * shown->run.trajectory->duration());
  };
  return ui::draw_window(run, size, look);
}

}  // namespace
}  // namespace feedscope::test

int main(int argc, char** argv) {
  using namespace feedscope;
  if (argc != 8) {
    std::puts("window_case PROGRAM MODEL PANEL THEME WxH BASELINE RESULTS");
    return 2;
  }
  ui::PictureSize size;
  if (std::sscanf(argv[5], "%dx%d", &size.width, &size.height) != 2) {
    std::puts("size: WxH");
    return 2;
  }
  if (!std::filesystem::exists(argv[1])) {
    std::printf("%s is absent; skipped\n", argv[1]);
    return test::skipped;
  }
  try {
    const auto theme = std::string(argv[4]) == "dark" ? ui::ThemeKind::dark : ui::ThemeKind::light;
    return test::compare_with_baseline(test::draw(argv[1], argv[2], argv[3], theme, size), argv[6], argv[7]);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
