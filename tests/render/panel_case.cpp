// Draws the panel of the contour error on its own, without a display, and compares it with a baseline.
//   panel_case PROGRAM MODEL RUNS THEME WxH BASELINE RESULTS
// RUNS: 1, or 3 for two more with tolerances of 0.02 and 0.005 mm. Leaves with 77 where PROGRAM is absent.
#include <QApplication>
#include <QImage>
#include <QTreeView>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "tests/render/baseline.h"
#include "ui/contour/contour_view.h"
#include "ui/paper/picture_file.h"
#include "ui/theme/offscreen_application.h"

namespace feedscope::test {
namespace {

constexpr int skipped = 77;

void add_runs(ui::Workbench& bench) {
  for (const double tolerance : {0.02, 0.005}) {
    ui::SetupState setup = bench.setup().state();
    setup.set("contour_tolerance_mm", tolerance);
    bench.runs().duplicate_as(0, setup);
  }
  bench.runs().select(0);
}

ui::Picture draw(const std::string& program, const std::string& model, bool more_runs, ui::ThemeKind theme,
                 ui::PictureSize size) {
  const ui::OffscreenApplication application(theme);
  const Run run = simulate_run(load_program(std::filesystem::path(program)), make_setup({"", model, {}, {}}));
  ui::Workbench bench(shipped_machines(), run.setup);
  ui::ContourView panel(bench);
  panel.setAttribute(Qt::WA_DontShowOnScreen);
  panel.resize(size.width, size.height);
  panel.show();
  bench.show(run);
  if (more_runs) {
    add_runs(bench);
  }
  while (bench.busy() || panel.busy()) {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  panel.list().setCurrentIndex(panel.places().index(0, 0));
  constexpr int enough = 20;  // for scroll bars to come and go
  for (int i = 0; i < enough; ++i) {
    QApplication::processEvents();
  }
  return ui::picture_of(panel.grab().toImage());
}

}  // namespace
}  // namespace feedscope::test

int main(int argc, char** argv) {
  using namespace feedscope;
  if (argc != 8) {
    std::puts("panel_case PROGRAM MODEL RUNS THEME WxH BASELINE RESULTS");
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
    const bool more_runs = std::string(argv[3]) == "3";
    return test::compare_with_baseline(test::draw(argv[1], argv[2], more_runs, theme, size), argv[6],
                                       argv[7]);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
