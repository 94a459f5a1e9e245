#include "core/program/sinumerik/geometry/corners.h"

#include <algorithm>
#include <array>
#include <utility>

namespace feedscope::sinumerik {

void Corners::run_modal() {
  if (words_.has(Address::rndm)) {
    const BlockWords::Value& radius = words_[Address::rndm];
    modes_.rounding = std::max(0.0, to_mm(radius.value));
    if (radius.value < 0) {
      report(Severity::error, "corner", 2, radius.column, [&] {
        return Text{message(NC_("core", "RNDM={} is negative"), radius.value),
                    NC_("core", "corners stay sharp; write a radius or 0")};
      });
    }
  }
  if (words_.has(Address::frcm)) {
    modes_.feed = std::max(0.0, words_[Address::frcm].value);
  }
}

void Corners::cut(bool at_line_or_arc) const {
  constexpr std::array own{std::pair(Address::rnd, CornerCut::Kind::rounding),
                           std::pair(Address::chf, CornerCut::Kind::chamfer_by_length),
                           std::pair(Address::chr, CornerCut::Kind::chamfer)};
  const auto found =
      std::find_if(own.begin(), own.end(), [this](const auto& word) { return words_.has(word.first); });
  CornerCut cut;
  cut.modal = found == own.end();
  cut.at_feed_only = cut.modal;
  cut.size = cut.modal ? modes_.rounding : to_mm(words_[found->first].value);
  cut.kind = cut.modal ? CornerCut::Kind::rounding : found->second;
  if (cut.size == 0 || (cut.modal && !at_line_or_arc)) {
    return;
  }
  const std::uint32_t column = cut.modal ? 0 : words_[found->first].column;
  if (cut.size < 0 || !at_line_or_arc) {
    report(Severity::error, "corner", cut.size < 0 ? 2 : 3, column, [&] {
      return Text{cut.size < 0 ? message(NC_("core", "a rounding or chamfer of {} is negative"), cut.size)
                               : NC_("core", "a rounding or chamfer in a block without a line or arc"),
                  NC_("core", "the corner stays sharp; write it in the block that ends at the corner")};
    });
    return;
  }
  const double feed = words_.has(Address::frc) ? words_[Address::frc].value : modes_.feed;
  if (feed > 0) {
    const double of_block = path().feed();
    path().set_feed(feeds_.feed_of(feed));
    cut.feed = path().feed_rate();
    path().set_feed(of_block);
  }
  cut.feed_of_next = true;
  cut.shrinks = true;
  cut.place = place(column);
  path().cut_next_corner(cut, modal_.plane);
}

}  // namespace feedscope::sinumerik
