#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace feedscope::ui {

/// A place between two lines of a laid out text where a page may end. Lengths in units of the layout.
struct PageGap {
  double above = 0;     ///< lower end of what is above
  double below = 0;     ///< upper end of what is below
  double cost = 0;      ///< of a break here: 0 is as good as any, see page_cost
  bool forced = false;  ///< a page must end here
  double head = 0;      ///< height of the table heads that are repeated on a page that begins here
};

/// What a page costs beside the break at its end; the fewer and fuller the pages, the cheaper.
namespace page_cost {
inline constexpr double page = 100;  ///< each page
/// Times the square of the share that is left empty, unless it is the last one or ends at a forced break.
inline constexpr double empty = 100;
inline constexpr double min_fill = 0.26;  ///< of each page but the last
inline constexpr double little = 1e5;     ///< a page less full than that
inline constexpr double sliver = 30;      ///< a last page with hardly a line on it
}  // namespace page_cost

/// Indices of the gaps at which pages of `height` end so that all pages together cost least. `gaps` from top
/// to bottom between `top` and `bottom` of the text. What no page can hold gets one of its own. Costs time in
/// the number of gaps times those of a page.
std::vector<std::size_t> best_page_breaks(std::span<const PageGap> gaps, double top, double bottom,
                                          double height);

}  // namespace feedscope::ui
