#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/trace/trace_builder.h"
#include "core/trace/trace_columns.h"
#include "core/trace/trace_row.h"

namespace feedscope {

/// Place of a quantity in a row, and its unit.
struct FoundColumn {
  std::size_t place = 0;  ///< 0-based
  double factor = 1;      ///< internal units per unit of the file
  double offset = 0;      ///< of a position, internal units

  /// Converts a number of the file to internal units.
  double inside(double number) const { return number * factor + offset; }
};

struct FoundColumns {
  std::array<std::optional<FoundColumn>, trace_quantity_count> columns;
  double period = 0;  ///< of tables whose times are not used [s]
  TraceClock clock = TraceClock::times;

  const std::optional<FoundColumn>& of(TraceQuantity quantity) const {
    return columns[static_cast<std::size_t>(quantity)];
  }
};

/// First lines of a table.
struct TableHead {
  RowStyle style;
  std::size_t first_row = 0;                             ///< lines before the first row of numbers
  std::vector<std::string> titles;                       ///< of the columns; empty without titles
  std::vector<std::vector<std::optional<double>>> rows;  ///< the first ones
};

/// Examines the first lines. Throws InputError with the file if there is no row of at least two numbers.
TableHead find_table(std::string_view text, const std::string& name, const TraceColumns& columns);

/// Matches requested columns, titles, and without both, the values: a first column of whole numbers that rise
/// by one, then up to three columns of numbers, one of whole numbers (line), one (feed). Notes assumptions in
/// `builder`. Throws InputError with the name of a missing column.
FoundColumns find_columns(const TableHead& head, const TraceColumns& asked, const std::string& name,
                          TraceBuilder& builder);

}  // namespace feedscope
