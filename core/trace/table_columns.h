#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/trace/trace_builder.h"
#include "core/trace/trace_columns.h"
#include "core/trace/trace_row.h"

namespace feedscope {

/// Where in a row a quantity stands, and in what unit.
struct FoundColumn {
  std::size_t place = 0;  ///< from 0 on
  double factor = 1;      ///< inside units a unit of the file
  double offset = 0;      ///< of a position, inside units

  /// A number of the file in inside units.
  double inside(double number) const { return number * factor + offset; }
};

/// Which column of a table is what.
struct FoundColumns {
  std::array<std::optional<FoundColumn>, trace_quantity_count> columns;
  double period = 0;  ///< of tables whose times are not used [s]
  TraceClock clock = TraceClock::times;

  const std::optional<FoundColumn>& of(TraceQuantity quantity) const {
    return columns[static_cast<std::size_t>(quantity)];
  }
};

/// The first lines of a table.
struct TableHead {
  RowStyle style;
  std::size_t first_row = 0;                             ///< lines in front of the first row of numbers
  std::vector<std::string> titles;                       ///< of the columns; empty: there are none
  std::vector<std::vector<std::optional<double>>> rows;  ///< the first ones
};

/// Looks at the first lines. Throws InputError naming the file if there is no row of at least two numbers.
TableHead find_table(std::string_view text, const std::string& name, const TraceColumns& columns);

/// Matches what was asked for, the titles, and where there are neither, the values: a first column of whole
/// numbers that rise by one, then up to three columns of numbers, one of whole numbers (line), one (feed).
/// Notes in `builder` what was assumed. Throws InputError naming a column that is not there.
FoundColumns find_columns(const TableHead& head, const TraceColumns& asked, const std::string& name,
                          TraceBuilder& builder);

}  // namespace feedscope
