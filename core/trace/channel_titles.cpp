#include "core/trace/channel_titles.h"

#include "core/trace/table_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"

namespace feedscope {

std::vector<UsedChannel> used_channels(const std::vector<std::string>& titles, const TraceColumns& asked,
                                       const std::string& name, TraceBuilder& builder) {
  TableHead head;
  head.titles = titles;
  TraceColumns wanted = asked;
  wanted.of(TraceQuantity::time).reset();
  wanted.of(TraceQuantity::number).reset();
  wanted.period = 1;  // these formats have times of their own
  const FoundColumns found = find_columns(head, wanted, name, builder);
  std::vector<UsedChannel> used;
  for (const TraceQuantity quantity :
       {TraceQuantity::x, TraceQuantity::y, TraceQuantity::z, TraceQuantity::feed, TraceQuantity::line}) {
    if (const auto& column = found.of(quantity)) {
      used.push_back({column->place, quantity, column->factor});
      if (quantity == TraceQuantity::feed) {
        builder.has_feed();
      } else if (quantity == TraceQuantity::line) {
        builder.has_line();
      } else {
        builder.has_axis(static_cast<std::size_t>(quantity) - static_cast<std::size_t>(TraceQuantity::x));
      }
    }
  }
  if (!builder.axis(0) && !builder.axis(1) && !builder.axis(2)) {
    throw InputError(fmt::format(
        "'{}' has no signal that is known as the position of X, Y or Z; it has {}; say which, as --columns "
        "x=1:mm,y=2:mm",
        name, titles.empty() ? "none" : fmt::format("{}", fmt::join(titles, ", "))));
  }
  return used;
}

}  // namespace feedscope
