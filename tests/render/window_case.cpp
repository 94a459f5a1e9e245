// Draws the window with one of its panels in front, without a display, and compares it with a baseline.
//   window_case PROGRAM MODEL PANEL THEME WxH BASELINE RESULTS
// PANEL is the name of a dock, film for a strip of playback, split or beside for two runs in the 3D view;
// THEME light or dark. Leaves with 77 where PROGRAM is absent.
#include <fmt/format.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QTreeWidget>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/analysis/agreement/agreement.h"
#include "core/base/error.h"
#include "core/lessons/lesson.h"
#include "tests/render/baseline.h"
#include "ui/annotations/annotations_view.h"
#include "ui/identification/fit_choice.h"
#include "ui/identification/identification_view.h"
#include "ui/lessons/lesson_view.h"
#include "ui/study/study_view.h"
#include "ui/trace/trace_view.h"
#include "ui/why/why_view.h"
#include "ui/window/main_window.h"
#include "ui/window/panels/pictures_of_panels.h"

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

/// A run with 10 um and one with 50 um in one view or in two, coloured by what either loses against the
/// other.
void compare_runs(ui::MainWindow& window, ui::Workbench& model, ui::ScenesMode mode) {
  model.set_tolerance(0.05);
  ui::SetupState setup = model.setup().state();
  setup.set("contour_tolerance_mm", 0.01);
  model.runs().duplicate_as(model.runs().current(), setup);
  window.scene().scene().set_colouring(ui::Colouring::time_lost);
  window.scene().scene().set_standard_view(ui::StandardView::top);
  window.scenes().set_mode(mode);
}

void raise(ui::MainWindow& window, const std::string& panel) {
  auto* dock = window.findChild<QDockWidget*>(QString::fromStdString(panel));
  if (dock == nullptr) {
    throw InputError("no panel '" + panel + "'");
  }
  dock->show();
  dock->raise();
}

/// A callout at the cursor, and a marked stretch of `duration` before it [s].
void add_annotations(ui::MainWindow& window, ui::Workbench& bench, double duration) {
  const double time = bench.cursor().state().time;
  window.part<ui::AnnotationsView>().set_stretch([=] {
    return std::array<double, 2>{time - duration, time};
  });
  for (const ui::AnnotationKind kind : {ui::AnnotationKind::region, ui::AnnotationKind::callout}) {
    window.part<ui::AnnotationsView>().panel_actions()[static_cast<int>(kind)]->trigger();
  }
}

/// Runs show results only once they have their own.
void wait_for_runs(const ui::MainWindow& window, const ui::Workbench& bench) {
  while (bench.busy() || window.busy()) {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
}

/// What a machine with a tolerance of 0.02 mm would record: a table, one row each millisecond, moved in X.
void lay_trace_beside(ui::MainWindow& window, const ui::Workbench& bench) {
  Run recorded = bench.shown()->run;
  set_tolerance(recorded.setup, 0.02);
  recorded = simulate_run(recorded.input, recorded.setup);
  constexpr double period = 1e-3;  // [s]
  constexpr double moved = 25;     // [mm]
  const MotionRecord record = record_of(*recorded.trajectory, period);
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "machine.csv";
  {
    std::ofstream out(file);
    out << "time [s],x [mm],y [mm],z [mm]\n";
    for (std::size_t i = 0; i < record.time.size(); ++i) {
      const Vec3& at = record.place[i];
      out << fmt::format("{:.4f},{:.4f},{:.4f},{:.4f}\n", record.time[i], at.x() + moved, at.y(), at.z());
    }
  }
  window.part<ui::TraceView>().open(file);
  wait_for_runs(window, bench);
  std::filesystem::remove(file);
}

/// The tolerance of that machine, found from its trace.
void identify_tolerance(ui::MainWindow& window, const ui::Workbench& bench) {
  lay_trace_beside(window, bench);
  auto& panel = window.part<ui::IdentificationView>();
  panel.choice().tick_none();
  QTreeWidget& numbers = panel.choice().parameters();
  for (int row = 0; row < numbers.topLevelItemCount(); ++row) {
    QTreeWidgetItem* number = numbers.topLevelItem(row);
    if (number->toolTip(0) == "contour_tolerance_mm") {
      number->setCheckState(0, Qt::Checked);
    }
  }
  QApplication::processEvents();
  panel.identify();
  wait_for_runs(window, bench);
}

/// Does with a panel what it is for.
void use(const std::string& panel, ui::MainWindow& window, ui::Workbench& bench) {
  constexpr double marked = 0.1;  // of the cycle time
  if (panel == "why") {
    window.part<ui::WhyView>().try_remedies();  // not only once the cursor has rested
  } else if (panel == "study") {
    window.part<ui::StudyView>().run();
  } else if (panel == "annotations") {
    add_annotations(window, bench, marked * bench.shown()->run.trajectory->duration());
  } else if (panel == "trace") {
    lay_trace_beside(window, bench);
  } else if (panel == "identification") {
    identify_tolerance(window, bench);
  } else if (panel == "lesson") {
    window.part<ui::LessonView>().desk().unlock(true);
    window.open_lesson(find_lesson("small_circle"));
  }
}

/// The window with the cursor at a share of the cycle time.
ui::Picture draw_at(const Run& run, const std::string& panel, ui::ThemeKind theme, ui::PictureSize size,
                    double share) {
  ui::WindowLook look{.theme = theme};
  look.prepare = [&](ui::MainWindow& window, ui::Workbench& bench) {
    if (panel == "runs") {
      add_runs(bench);
    }
    raise(window, "machine");
    if (panel == "split" || panel == "beside") {
      compare_runs(window, bench, panel == "split" ? ui::ScenesMode::split : ui::ScenesMode::side_by_side);
    } else {
      raise(window, panel);
    }
    wait_for_runs(window, bench);
    bench.cursor().set_time(share * bench.shown()->run.trajectory->duration());
    use(panel, window, bench);
  };
  return ui::draw_window(run, size, look);
}

/// Half as wide and high, each pixel the mean of four.
ui::Picture halved(const ui::Picture& picture) {
  const auto width = static_cast<std::size_t>(picture.size.width);
  ui::Picture half{{picture.size.width / 2, picture.size.height / 2}, {}};
  for (std::size_t y = 0; y + 1 < static_cast<std::size_t>(picture.size.height); y += 2) {
    for (std::size_t x = 0; x + 1 < width; x += 2) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto at = [&](std::size_t dx, std::size_t dy) {
          return int{picture.rgb[3 * ((y + dy) * width + x + dx) + c]};
        };
        half.rgb.push_back(static_cast<unsigned char>((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4));
      }
    }
  }
  return half;
}

/// `right` beside `left`, which is as high.
ui::Picture beside(const ui::Picture& left, const ui::Picture& right) {
  ui::Picture both{{left.size.width + right.size.width, left.size.height}, {}};
  for (std::ptrdiff_t y = 0; y < left.size.height; ++y) {
    for (const ui::Picture* part : {&left, &right}) {
      const std::ptrdiff_t row = std::ptrdiff_t{3} * part->size.width;
      both.rgb.insert(both.rgb.end(), part->rgb.begin() + y * row, part->rgb.begin() + (y + 1) * row);
    }
  }
  return both;
}

/// Six instants of playback, equally far apart, in rows of two.
ui::Picture draw_film(const Run& run, ui::ThemeKind theme, ui::PictureSize size) {
  constexpr int frames = 6;
  ui::Picture film{{size.width / 2 * 2, 0}, {}};
  for (int frame = 0; frame < frames; frame += 2) {
    const auto draw = [&](int i) {
      return halved(draw_at(run, "charts", theme, size, static_cast<double>(i) / (frames - 1)));
    };
    const ui::Picture row = beside(draw(frame), draw(frame + 1));
    film.rgb.insert(film.rgb.end(), row.rgb.begin(), row.rgb.end());
    film.size.height += row.size.height;
  }
  return film;
}

ui::Picture draw(const std::string& program, const std::string& model, const std::string& panel,
                 ui::ThemeKind theme, ui::PictureSize size) {
  const Run run = simulate_run(load_program(std::filesystem::path(program)), make_setup({"", model, {}, {}}));
  constexpr double somewhere = 0.4;
  return panel == "film" ? draw_film(run, theme, size) : draw_at(run, panel, theme, size, somewhere);
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
    return test::compare_with_baseline(test::draw(argv[1], argv[2], argv[3], theme, size), argv[6], argv[7],
                                       test::PictureOf::window);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
