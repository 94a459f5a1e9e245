#include "tests/render/picture_difference.h"

#include <algorithm>
#include <stdexcept>

#include "tests/support/cielab.h"

namespace feedscope::test {
namespace {

std::size_t offset(const ui::Picture& picture, int x, int y) {
  return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
              static_cast<std::size_t>(x));
}

/// Calls `visit` with every pixel of a square, cut at the picture's edge.
template <class Visit>
void for_each_pixel(const ui::Picture& picture, int left, int top, Visit visit) {
  for (int y = top; y < std::min(top + difference_square, picture.size.height); ++y) {
    for (int x = left; x < std::min(left + difference_square, picture.size.width); ++x) {
      visit(offset(picture, x, y));
    }
  }
}

ColourTriple average(const ui::Picture& picture, int left, int top) {
  ColourTriple sum{};
  int count = 0;
  for_each_pixel(picture, left, top, [&](std::size_t at) {
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += picture.rgb[at + c] / 255.0;
    }
    ++count;
  });
  return {sum[0] / count, sum[1] / count, sum[2] / count};
}

}  // namespace

PictureDifference difference(const ui::Picture& a, const ui::Picture& b) {
  if (a.size.width != b.size.width || a.size.height != b.size.height) {
    throw std::invalid_argument("pictures of different size");
  }
  PictureDifference result;
  result.map = a;
  int squares = 0;
  for (int top = 0; top < a.size.height; top += difference_square) {
    for (int left = 0; left < a.size.width; left += difference_square) {
      const double distance =
          lab_distance(to_lab(to_linear(average(a, left, top))), to_lab(to_linear(average(b, left, top))));
      result.mean += distance;
      result.largest = std::max(result.largest, distance);
      ++squares;
      const double shade = 255 * (1 - std::min(1.0, distance / largest_allowed));
      for_each_pixel(a, left, top, [&](std::size_t at) {
        std::fill_n(result.map.rgb.begin() + static_cast<std::ptrdiff_t>(at), 3,
                    static_cast<unsigned char>(shade));
      });
    }
  }
  result.mean /= squares;
  return result;
}

}  // namespace feedscope::test
