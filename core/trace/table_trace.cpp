#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/translatable.h"
#include "core/trace/table_columns.h"
#include "core/trace/trace_builder.h"
#include "core/trace/trace_formats.h"
#include "core/trace/trace_row.h"

namespace feedscope {
namespace {

class TableReader {
 public:
  TableReader(TraceText& text, const TraceColumns& columns)
      : text_(text),
        head_(find_table(text.head(), text.name(), columns)),
        builder_(text.name(), head_.titles.empty() && head_.style.separator == ' '
                                  ? "LinuxCNC halsampler"
                                  : QT_TRANSLATE_NOOP("core", "table of samples")),
        found_(find_columns(head_, columns, text.name(), builder_)) {
    for (std::size_t q = 0; q < trace_quantity_count; ++q) {
      if (const auto quantity = static_cast<TraceQuantity>(q); found_.of(quantity)) {
        quantities_.push_back(quantity);
        builder_.has(quantity);
      }
    }
    builder_.set_clock(found_.clock);
    if (!builder_.has_place() && !head_.titles.empty()) {
      throw InputError(message(NC_("core",
                                   "'{}' has no column that is known as the position of X, Y or Z; it has "
                                   "{}; say which, as --columns x=2:mm,y=3:mm"),
                               text.name(), fmt::to_string(fmt::join(head_.titles, ", "))));
    }
  }

  Trace read() {
    std::string_view line;
    while (text_.next_line(line)) {
      if (text_.line_number() > head_.first_row && !line.empty()) {
        read_row(line);
      }
    }
    return builder_.finish();
  }

 private:
  double value(TraceQuantity quantity) const {
    const auto& column = found_.of(quantity);
    if (!column || column->place >= fields_.size()) {
      return TraceSample::missing;
    }
    const auto number = field_number(fields_[column->place], head_.style.decimal);
    return number ? column->inside(*number) : TraceSample::missing;
  }

  double time_of_row() {
    if (found_.of(TraceQuantity::time)) {
      return value(TraceQuantity::time);
    }
    if (found_.of(TraceQuantity::number)) {
      return value(TraceQuantity::number) * found_.period;
    }
    return static_cast<double>(rows_++) * found_.period;
  }

  void read_row(std::string_view line) {
    split_row(line, head_.style.separator, fields_);
    TraceSample sample;
    for (const TraceQuantity quantity : quantities_) {
      sample.set(quantity, value(quantity));
    }
    const bool any = std::ranges::any_of(sample.place, [](double place) { return std::isfinite(place); });
    sample.time = any ? time_of_row() : TraceSample::missing;
    if (std::isfinite(sample.time)) {
      builder_.add(sample, text_.line_number());
    } else {
      builder_.skip(text_.line_number(), line);
    }
  }

  TraceText& text_;
  TableHead head_;
  TraceBuilder builder_;
  FoundColumns found_;
  std::vector<TraceQuantity> quantities_;  ///< of the table
  std::vector<std::string_view> fields_;
  std::size_t rows_ = 0;
};

}  // namespace

Trace read_table_trace(TraceText& text, const TraceColumns& columns) {
  return TableReader(text, columns).read();
}

}  // namespace feedscope
