#include "tests/render/baseline.h"

#include <vtkVersionMacros.h>

#include <QtGlobal>

#include <cstdio>
#include <fstream>

#include "tests/render/picture_difference.h"

namespace feedscope::test {

namespace fs = std::filesystem;

namespace {

struct Bounds {
  double mean = mean_allowed;
  double largest = largest_allowed;
};

/// Baselines are drawn on Debian 12 (VTK 9.1, Qt 6.4). Later versions of VTK end wide lines square, which
/// changes squares at the ends of corner blends by up to 51; other versions of Qt lay windows out a pixel or
/// two apart, so that only what is missing altogether shows.
Bounds bounds_here(PictureOf what) {
  constexpr bool other_vtk = VTK_MAJOR_VERSION != 9 || VTK_MINOR_VERSION != 1;
  constexpr bool other_qt = QT_VERSION < QT_VERSION_CHECK(6, 4, 0) || QT_VERSION >= QT_VERSION_CHECK(6, 5, 0);
  Bounds bounds;
  if (other_vtk) {
    bounds.largest = 60;
  }
  if (other_qt && what == PictureOf::window) {
    bounds = {2.5, 75};
  }
  return bounds;
}

void save(const ui::Picture& picture, const fs::path& file) {
  std::ofstream(file, std::ios::binary) << ui::to_png(picture);
}

}  // namespace

int compare_with_baseline(const ui::Picture& picture, const fs::path& baseline, const fs::path& results,
                          PictureOf what) {
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
  const Bounds bounds = bounds_here(what);
  std::printf("difference: mean %.3f (at most %.2f), largest %.2f (at most %.0f)\n", d.mean, bounds.mean,
              d.largest, bounds.largest);
  if (d.mean <= bounds.mean && d.largest <= bounds.largest) {
    return 0;
  }
  save(d.map, results / "difference.png");
  fs::copy_file(baseline, results / "baseline.png", fs::copy_options::overwrite_existing);
  std::printf("not as the baseline: see rendered.png, baseline.png and difference.png in %s\n",
              results.c_str());
  return 1;
}

}  // namespace feedscope::test
