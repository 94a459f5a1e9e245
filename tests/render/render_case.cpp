// Draws one case without a display and compares it with its baseline.
//   render_case FOLDER MODEL PICTURE WxH RESULTS
// FOLDER holds program.nc and baseline_PICTURE.png (a camera, charts, dark_charts, comparison, sheet or
// window);
// RESULTS is where the pictures of a failure are left.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>

#include "tests/render/baseline.h"
#include "tests/render/charts_picture.h"
#include "tests/ui/comparison_fixture.h"
#include "tests/ui/run_fixture.h"
#include "ui/report/pictures.h"
#include "ui/scene/picture.h"
#include "ui/scene_view/scene_texts.h"
#include "ui/theme/offscreen_application.h"
#include "ui/window/panels/pictures_of_panels.h"

namespace feedscope::test {
namespace {

namespace fs = std::filesystem;

using Draw = std::function<ui::Picture(const Run&, ui::PictureSize)>;

Draw scene_from(ui::StandardView view) {
  return [view](const Run& run, ui::PictureSize size) { return ui::draw_run(run, size, view); };
}

/// The scene from above after `change`.
Draw scene_with(const std::function<void(ui::PathScene&, const Run&)>& change,
                ui::StandardView view = ui::StandardView::top) {
  return [change, view](const Run& run, ui::PictureSize size) {
    ui::PathScene scene;
    scene.set_programmed(run.path.toolpath);
    scene.set_executed(run.trajectory);
    scene.set_standard_view(view);
    change(scene, run);
    return ui::draw_picture(scene, size);
  };
}

Draw coloured_by(ui::Colouring colouring) {
  return scene_with([colouring](ui::PathScene& scene, const Run&) { scene.set_colouring(colouring); });
}

void add_measurement(ui::PathScene& scene, const Run& run) {
  const State from = run.trajectory->state(0.2 * run.trajectory->duration());
  const State to = run.trajectory->state(0.7 * run.trajectory->duration());
  scene.set_dimension(ui::SceneDimension{from.position, to.position, ui::measurement_lines(from, to)});
}

void make_dark(ui::PathScene& scene, const Run& run) {
  scene.set_background(ui::Background::dark);
  scene.set_colouring(ui::Colouring::cause);
  scene.set_cursor(run.trajectory->state(0.4 * run.trajectory->duration()));
}

void add_overlays(ui::PathScene& scene, const Run& run) {
  const Run other = simulate_text(std::string(run.input.program->source->utf8_text()), "msaddek");
  scene.set_colouring(ui::Colouring::run);
  scene.set_overlays({{std::make_shared<const ui::SampledPath>(ui::sample_executed(other.trajectory)),
                       {0.84, 0.37, 0.0},
                       "Msaddek 2011"}});
  scene.set_exaggeration(20);
  scene.set_highlight(std::array{0.3 * run.trajectory->duration(), 0.5 * run.trajectory->duration()});
}

void look_from_near(ui::PathScene& scene, const Run& run) {
  scene.set_perspective(true);
  scene.set_tool({ui::ToolKind::bull, 8, 2});
  scene.set_cursor(run.trajectory->state(0.6 * run.trajectory->duration()));
}

/// Coloured against a run with a wider tolerance.
Draw compared_by(ui::Colouring colouring, ui::Background background) {
  return scene_with([colouring, background](ui::PathScene& scene, const Run& run) {
    Setup loose = run.setup;
    loose.settings.set("contour_tolerance_mm", 0.5);
    const Run other = simulate_run(run.input, loose);
    scene.set_executed(run.trajectory,
                       std::make_shared<const ui::SampledPath>(ui::sample_compared(
                           run.trajectory, *other.trajectory, ui::sample_executed(other.trajectory).times)));
    scene.set_comparison("essid, 0.5 mm", nullptr);
    scene.set_colouring(colouring);
    scene.set_background(background);
  });
}

ui::Picture draw_comparison(const Run& run, ui::PictureSize size) {
  return ui::draw_comparison(run.input, usual_compared_runs(), compared_settings, size);
}

/// Two tolerances on one page to hand out.
ui::Picture draw_sheet(const Run& run, ui::PictureSize size) {
  const ui::OffscreenApplication application;
  std::vector<std::shared_ptr<const ui::ShownRun>> runs{ui::make_shown(run)};
  Setup loose = run.setup;
  loose.settings.set("contour_tolerance_mm", 0.5);
  runs.push_back(ui::make_shown(simulate_run(run.input, loose)));
  ui::ReportInput input;
  input.runs = ui::report_runs(runs);
  input.title = QStringLiteral("A sheet of two runs");
  input.author = QStringLiteral("Feedscope's tests");
  ui::Annotation note;
  note.place = {1, 0.5};
  note.text = QStringLiteral("{feed}\n{cause}");
  note.offset = QPointF(70, -40);
  input.annotations = {note};
  input.commands = {QStringLiteral("feedscope render test.nc --view sheet")};
  ui::PictureRequest request;
  request.size = QSizeF(size.width, size.height);
  return ui::picture_of(QImage::fromData(QByteArray::fromStdString(ui::sheet_file(input, request))));
}

const std::map<std::string, Draw> pictures{
    {"ratio", coloured_by(ui::Colouring::feed_ratio)},
    {"acceleration", coloured_by(ui::Colouring::acceleration)},
    {"tangential", coloured_by(ui::Colouring::tangential_acceleration)},
    {"jerk", coloured_by(ui::Colouring::jerk)},
    {"error", coloured_by(ui::Colouring::contour_error)},
    {"cause", coloured_by(ui::Colouring::cause)},
    {"lost", compared_by(ui::Colouring::time_lost, ui::Background::light)},
    {"lost_dark", compared_by(ui::Colouring::time_lost, ui::Background::dark)},
    {"distance", compared_by(ui::Colouring::path_distance, ui::Background::light)},
    {"exaggerated", scene_with([](ui::PathScene& scene, const Run&) { scene.set_exaggeration(50); })},
    {"overlays", scene_with(add_overlays)},
    {"measured", scene_with(add_measurement)},
    {"dark", scene_with(make_dark)},
    {"perspective", scene_with(look_from_near, ui::StandardView::iso)},
    {"iso", scene_from(ui::StandardView::iso)},
    {"top", scene_from(ui::StandardView::top)},
    {"front", scene_from(ui::StandardView::front)},
    {"right", scene_from(ui::StandardView::right)},
    {"charts", ui::draw_charts},
    {"dark_charts", draw_dark_charts},
    {"comparison", draw_comparison},
    {"sheet", draw_sheet},
    {"window", [](const Run& run, ui::PictureSize size) { return ui::draw_window(run, size, {}); }}};

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int compare(const fs::path& folder, const std::string& model, const std::string& name, ui::PictureSize size,
            const fs::path& results) {
  const Run run = simulate_text(contents(folder / "program.nc"), model);
  return compare_with_baseline(pictures.at(name)(run, size), folder / ("baseline_" + name + ".png"), results,
                               name == "window" ? PictureOf::window : PictureOf::drawing);
}

}  // namespace
}  // namespace feedscope::test

int main(int argc, char** argv) {
  using namespace feedscope;
  if (argc != 6) {
    std::puts("render_case FOLDER MODEL PICTURE WxH RESULTS");
    return 2;
  }
  ui::PictureSize size;
  if (std::sscanf(argv[4], "%dx%d", &size.width, &size.height) != 2) {
    std::puts("size: WxH");
    return 2;
  }
  try {
    return test::compare(argv[1], argv[2], argv[3], size, argv[5]);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
