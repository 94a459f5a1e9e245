#include "core/trace/guess_trace.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/trace/table_columns.h"
#include "core/trace/trace_formats.h"

namespace feedscope {
namespace {

constexpr std::size_t least_rows = 10;

/// Whether there are consecutive rows of numbers.
bool is_table(const TableHead& table) {
  const auto numeric = [](const std::vector<std::optional<double>>& row) {
    const auto numbers = std::ranges::count_if(row, [](const auto& field) { return field.has_value(); });
    return numbers >= 2 && 2 * numbers > static_cast<std::ptrdiff_t>(row.size());
  };
  const auto rows = static_cast<std::size_t>(std::ranges::count_if(table.rows, numeric));
  return rows >= least_rows && 2 * rows > table.rows.size();
}

}  // namespace

GuessedTrace guess_trace(const std::filesystem::path& file) {
  try {
    TraceText text(file, nullptr);
    const std::string head(text.head());
    if (is_sinumerik_trace(head) || is_twincat_scope(head)) {
      return {TraceGuess::readable, {}};
    }
    const TableHead table = find_table(head, text.name(), {});
    if (!is_table(table)) {
      return {};
    }
    try {
      TraceBuilder builder(text.name(), "table");
      const FoundColumns found = find_columns(table, {}, text.name(), builder);
      if (!found.of(TraceQuantity::x) && !found.of(TraceQuantity::y) && !found.of(TraceQuantity::z)) {
        throw InputError(NC_("core", "no title of a column says which are the positions of X, Y and Z"));
      }
      if (table.titles.empty() && table.style.separator != ' ') {
        throw InputError(NC_("core", "the columns have no titles"));
      }
      return {TraceGuess::readable, {}};
    } catch (const InputError& error) {
      return {TraceGuess::columns_wanted, error.message()};
    }
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace feedscope
