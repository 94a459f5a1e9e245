#include <benchmark/benchmark.h>

#include <QApplication>
#include <QLocale>
#include <QPixmap>
#include <memory>
#include <string>

#include "tests/benchmark/programs.h"
#include "tests/ui/run_fixture.h"
#include "ui/charts/charts_panel.h"
#include "ui/theme/theme.h"

namespace feedscope::benchmark {
namespace {

using State = ::benchmark::State;

struct Shown {
  Run run;
  std::shared_ptr<const Envelope> envelope;
};

/// A run of so many short lines, made once.
const Shown& shown_run(std::size_t blocks) {
  static std::size_t made = 0;
  static Shown shown;
  if (made != blocks) {
    shown = {};
    shown.run = test::simulate_text(surface_program(blocks));
    shown.envelope = std::make_shared<const Envelope>(shown.run.trajectory);
    made = blocks;
  }
  return shown;
}

/// One frame of panning: a step of the range, curves made and all charts painted. Arguments: blocks, width
/// and height [px], abscissa, share of the run that is shown in percent.
void pan_frame(State& state) {
  const Shown& shown = shown_run(static_cast<std::size_t>(state.range(0)));
  ui::Cursor cursor;
  ui::ViewRange range;
  ui::ChartsPanel panel(cursor, range);
  panel.setAttribute(Qt::WA_DontShowOnScreen);
  panel.resize(static_cast<int>(state.range(1)), static_cast<int>(state.range(2)));
  panel.show();
  panel.set_limits(shown.run.setup);
  cursor.set_trajectory(shown.run.trajectory);
  panel.set_run(shown.run.trajectory, shown.envelope, false);
  panel.range().set_abscissa(state.range(3) == 0 ? ui::Abscissa::time : ui::Abscissa::path_length);
  panel.range().zoom(static_cast<double>(state.range(4)) / 100, panel.range().upper() / 2);
  QApplication::processEvents();
  QPixmap screen(panel.size());
  double way = panel.chart(0).position_at(3) - panel.chart(0).position_at(0);  // [px], as the mouse drags
  int steps = 0;
  for (auto _ : state) {
    if (++steps % 50 == 0) {
      way = -way;
    }
    panel.range().pan(way);
    panel.refresh();
    QApplication::processEvents();
    panel.render(&screen);
  }
  state.counters["pieces"] = static_cast<double>(shown.run.trajectory->pieces().size());
}

BENCHMARK(pan_frame)
    ->ArgNames({"blocks", "width", "height", "path", "percent"})
    ->ArgsProduct({{1000, 1000000}, {940}, {360}, {0, 1}, {90, 10, 1}})
    ->ArgsProduct({{1000000}, {1880}, {500}, {0}, {90}})
    ->Unit(::benchmark::kMillisecond);

}  // namespace
}  // namespace feedscope::benchmark

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QLocale::setDefault(QLocale::c());
  const QApplication application(argc, argv);
  feedscope::ui::apply_theme();
  ::benchmark::Initialize(&argc, argv);
  ::benchmark::RunSpecifiedBenchmarks();
}
