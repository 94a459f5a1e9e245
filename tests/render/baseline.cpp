#include "tests/render/baseline.h"

#include <cstdio>
#include <fstream>

#include "tests/render/picture_difference.h"

namespace feedscope::test {

namespace fs = std::filesystem;

namespace {

void save(const ui::Picture& picture, const fs::path& file) {
  std::ofstream(file, std::ios::binary) << ui::to_png(picture);
}

}  // namespace

int compare_with_baseline(const ui::Picture& picture, const fs::path& baseline, const fs::path& results) {
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

}  // namespace feedscope::test
