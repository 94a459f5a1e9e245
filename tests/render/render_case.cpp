// Draws one case without a display and compares it with its baseline.
//   render_case FOLDER MODEL PICTURE WxH RESULTS
// FOLDER holds program.nc and baseline_PICTURE.png (a camera, charts, dark_charts, comparison or window);
// RESULTS is where the pictures of a failure are left.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>

#include "tests/render/charts_picture.h"
#include "tests/render/picture_difference.h"
#include "tests/ui/comparison_fixture.h"
#include "tests/ui/run_fixture.h"
#include "ui/scene/picture.h"
#include "ui/window_picture.h"

namespace feedscope::test {
namespace {

namespace fs = std::filesystem;

using Draw = std::function<ui::Picture(const Run&, ui::PictureSize)>;

Draw scene_from(ui::StandardView view) {
  return [view](const Run& run, ui::PictureSize size) { return ui::draw_run(run, size, view); };
}

ui::Picture draw_comparison(const Run& run, ui::PictureSize size) {
  return ui::draw_comparison(run.input, usual_compared_runs(), {"alpha=2", "X.jerk=5"}, size);
}

const std::map<std::string, Draw> pictures{{"iso", scene_from(ui::StandardView::iso)},
                                           {"top", scene_from(ui::StandardView::top)},
                                           {"front", scene_from(ui::StandardView::front)},
                                           {"right", scene_from(ui::StandardView::right)},
                                           {"charts", ui::draw_charts},
                                           {"dark_charts", draw_dark_charts},
                                           {"comparison", draw_comparison},
                                           {"window", [](const Run& run, ui::PictureSize size) {
                                              return ui::draw_window(run, size, ui::StandardView::iso);
                                            }}};

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void save(const ui::Picture& picture, const fs::path& file) {
  std::ofstream(file, std::ios::binary) << ui::to_png(picture);
}

int compare(const fs::path& folder, const std::string& model, const std::string& name, ui::PictureSize size,
            const fs::path& results) {
  const Run run = simulate_text(contents(folder / "program.nc"), model);
  const ui::Picture picture = pictures.at(name)(run, size);
  const fs::path baseline = folder / ("baseline_" + name + ".png");
  fs::create_directories(results);
  const fs::path rendered = results / "rendered.png";
  save(picture, rendered);
  if (!fs::exists(baseline)) {
    std::printf("no baseline: look at %s, and if it is right copy it to %s\n", rendered.c_str(),
                baseline.c_str());
    return 1;
  }
  const ui::Picture expected = ui::read_png(baseline.string());
  const PictureDifference d = difference(picture, expected);
  std::printf("difference: mean %.3f (at most %.2f), largest %.2f (at most %.0f)\n", d.mean, mean_allowed,
              d.largest, largest_allowed);
  if (looks_the_same(d)) {
    return 0;
  }
  save(d.map, results / "difference.png");
  fs::copy_file(baseline, results / "baseline.png", fs::copy_options::overwrite_existing);
  std::printf("not as the baseline: see rendered.png, baseline.png and difference.png in %s\n",
              results.c_str());
  return 1;
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
