#include "tests/render/picture_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace feedscope::test {
namespace {

using Triple = std::array<double, 3>;

double to_linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double lightness(double t) {
  constexpr double knee = 6.0 / 29.0;
  return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4.0 / 29.0;
}

Triple to_lab(const Triple& rgb) {
  const double r = to_linear(rgb[0]);
  const double g = to_linear(rgb[1]);
  const double b = to_linear(rgb[2]);
  const double x = lightness((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const double y = lightness(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double z = lightness((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

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

Triple average(const ui::Picture& picture, int left, int top) {
  Triple sum{};
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
      const Triple p = to_lab(average(a, left, top));
      const Triple q = to_lab(average(b, left, top));
      const double distance = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
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
