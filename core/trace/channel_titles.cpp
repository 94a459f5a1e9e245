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
  wanted.period = 1;  // these formats have their own times
  const FoundColumns found = find_columns(head, wanted, name, builder);
  std::vector<UsedChannel> used;
  for (std::size_t q = 0; q < trace_quantity_count; ++q) {
    const auto quantity = static_cast<TraceQuantity>(q);
    const auto& column = found.of(quantity);
    if (column && quantity != TraceQuantity::time && quantity != TraceQuantity::number) {
      used.push_back({*column, quantity});
      builder.has(quantity);
    }
  }
  if (!builder.has_place()) {
    throw InputError(message(NC_("core",
                                 "'{}' has no signal that is known as the position of X, Y or Z; it has {}; "
                                 "say which, as --columns x=1:mm,y=2:mm"),
                             name,
                             titles.empty() ? Message(NC_("core", "none"))
                                            : Message::as_written(fmt::to_string(fmt::join(titles, ", ")))));
  }
  return used;
}

}  // namespace feedscope
