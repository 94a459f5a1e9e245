#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace feedscope::ui {

/// A place between two lines of a laid out text where a page may end. Lengths in units of the layout.
struct PageGap {
  double above = 0;     ///< lower end of the lines above
  double below = 0;     ///< upper end of the lines below
  double cost = 0;      ///< of a break here: 0 is ideal, see page_cost
  bool forced = false;  ///< a page must end here
  double head = 0;      ///< height of the table heads repeated on a page that begins here
};

/// Costs of a page in addition to the break at its end; fewer and fuller pages are cheaper.
namespace page_cost {
inline constexpr double page = 100;  ///< each page
/// Times the square of the empty share, except for the last page and at a forced break.
inline constexpr double empty = 100;
inline constexpr double min_fill = 0.26;  ///< of each page but the last
inline constexpr double little = 1e5;     ///< a page filled less than that
inline constexpr double sliver = 30;      ///< a last page of hardly a line
}  // namespace page_cost

/// Indices of the gaps at which pages of `height` end, with the least total cost. `gaps` from top to bottom
/// between `top` and `bottom` of the text. A part too high for a page gets a page of its own. Time
/// proportional to the number of gaps times those of a page.
std::vector<std::size_t> best_page_breaks(std::span<const PageGap> gaps, double top, double bottom,
                                          double height);

}  // namespace feedscope::ui
