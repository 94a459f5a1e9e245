#pragma once

#include "ui/scene/picture.h"

namespace feedscope::test {

/// How far two pictures of one size are apart to the eye: CIELAB distance (CIE 1976; 2 is just noticed side
/// by side, 100 is black to white) between averages over squares of four pixels.
struct PictureDifference {
  double mean = 0;
  double largest = 0;
  ui::Picture map;  ///< white where equal, black from largest_allowed on
};

/// Squares, so that an edge that another Mesa version rounds by part of a pixel hardly counts, while a line,
/// a label or a colour that is missing does.
inline constexpr int difference_square = 4;

/// Throws std::invalid_argument if the sizes differ.
PictureDifference difference(const ui::Picture& a, const ui::Picture& b);

/// Bounds that a rendered picture keeps to its baseline.
///
/// A line of 2.6 pixels shifted by a quarter of a pixel changes a square it crosses by up to a sixteenth of
/// the contrast, about 5; the shortest label missing, or a line, changes some square by more than 25. Of the
/// picture, lines and text cover some 5 %: all of them shifted so change the mean by less than 0.25.
inline constexpr double largest_allowed = 14;
inline constexpr double mean_allowed = 0.25;

inline bool looks_the_same(const PictureDifference& d) {
  return d.mean <= mean_allowed && d.largest <= largest_allowed;
}

}  // namespace feedscope::test
