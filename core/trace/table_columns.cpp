#include "core/trace/table_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/base/typed_number.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr std::size_t looked_at = 200;  // lines
constexpr double usual_period = 1e-3;   // [s]

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < looked_at) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    line.remove_suffix(line.ends_with('\r') ? 1 : 0);
    lines.push_back(line);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return lines;
}

std::vector<std::optional<double>> numbers_of(const std::vector<std::string_view>& fields, char decimal) {
  std::vector<std::optional<double>> numbers;
  for (const std::string_view field : fields) {
    numbers.push_back(field_number(field, decimal));
  }
  return numbers;
}

std::size_t count_of(const std::vector<std::optional<double>>& numbers) {
  return static_cast<std::size_t>(
      std::ranges::count_if(numbers, [](const auto& number) { return number.has_value(); }));
}

std::vector<std::string> titles_in(std::string_view line, char separator) {
  const auto first = line.find_first_not_of("#%; \t");
  line.remove_prefix(first == std::string_view::npos ? line.size() : first);
  std::vector<std::string_view> fields;
  split_row(line, separator, fields);
  return {fields.begin(), fields.end()};
}

bool is_unit(std::string_view text) {
  const std::string bare(text.substr(
      text.find_first_not_of("[( ") == std::string_view::npos ? text.size() : text.find_first_not_of("[( "),
      text.find_last_not_of(")] ") + 1));
  return trace_unit(TraceQuantity::time, bare).has_value() ||
         trace_unit(TraceQuantity::x, bare).has_value() || trace_unit(TraceQuantity::feed, bare).has_value();
}

/// Values of a column in the first rows; NaN where missing.
std::vector<double> values_of(const TableHead& head, std::size_t place) {
  std::vector<double> values;
  for (const auto& row : head.rows) {
    values.push_back(place < row.size() && row[place] ? *row[place] : TraceSample::missing);
  }
  return values;
}

bool are_whole(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double v) { return v == std::floor(v) && std::abs(v) < 1e9; });
}

double median_step(const std::vector<double>& values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && std::isfinite(values[i - 1])) {
      steps.push_back(values[i] - values[i - 1]);
    }
  }
  if (steps.empty()) {
    return 0;
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// Whether values rise evenly, as times do, and positions only for a while.
bool rises_evenly(const std::vector<double>& values) {
  constexpr double about = 0.5;
  constexpr double nearly_all = 0.9;
  const double usual = median_step(values);
  std::size_t even = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (step < 0) {
      return false;
    }
    even += std::abs(step - usual) <= about * usual ? 1 : 0;
  }
  return usual > 0 && static_cast<double>(even) >= nearly_all * static_cast<double>(values.size() - 1);
}

class ColumnFinder {
 public:
  ColumnFinder(const TableHead& head, const TraceColumns& asked, const std::string& name,
               TraceBuilder& builder)
      : head_(head), asked_(asked), name_(name), builder_(builder) {}

  FoundColumns find() {
    found_.period = asked_.period;
    for (std::size_t q = 0; q < trace_quantity_count; ++q) {
      if (asked_.columns[q] && !is_replaced(static_cast<TraceQuantity>(q))) {
        take_asked(static_cast<TraceQuantity>(q), *asked_.columns[q]);
      }
    }
    if (!head_.titles.empty()) {
      take_titles();
    } else if (!asked_.any()) {
      take_values();
    }
    settle_time();
    return found_;
  }

 private:
  /// Whether a given rate replaces the times of the file.
  bool is_replaced(TraceQuantity quantity) const {
    return quantity == TraceQuantity::time && asked_.period > 0;
  }

  void take(TraceQuantity quantity, std::size_t place, double factor, const std::string& unit,
            std::string_view why, double offset = 0) {
    found_.columns[static_cast<std::size_t>(quantity)] =
        FoundColumn{place, factor, offset * std::abs(factor)};
    std::string text = fmt::format("{}: column {}", to_string(quantity), place + 1);
    if (place < head_.titles.size()) {
      text += fmt::format(" '{}'", head_.titles[place]);
    }
    if (!unit.empty()) {
      text += fmt::format(" [{}{}]", factor < 0 ? "-" : "", unit);
    }
    if (offset != 0) {
      text += fmt::format(" {} {}", offset < 0 ? '-' : '+', std::abs(offset));
    }
    builder_.note_column(text + std::string(why));
  }

  /// Axis of x, y or z.
  static std::size_t axis_of(TraceQuantity place) {
    return static_cast<std::size_t>(place) - static_cast<std::size_t>(TraceQuantity::x);
  }

  std::size_t place_of(TraceQuantity quantity, const std::string& column) const {
    const TypedNumber number = typed_number(column);
    std::size_t widest = head_.titles.size();
    for (const auto& row : head_.rows) {
      widest = std::max(widest, row.size());
    }
    const auto titled = std::ranges::find(head_.titles, column);
    if (titled != head_.titles.end()) {
      return static_cast<std::size_t>(titled - head_.titles.begin());
    }
    if (number.value && *number.value == std::floor(*number.value) && *number.value >= 1 &&
        *number.value <= static_cast<double>(widest)) {
      return static_cast<std::size_t>(*number.value) - 1;
    }
    const std::string nearest = nearest_name(column, head_.titles);
    throw InputError(
        message(NC_("core", "'{}' has no column '{}' for {}; {}"), name_, column, to_string(quantity),
                !nearest.empty() ? message(NC_("core", "did you mean '{}'?"), nearest)
                : head_.titles.empty()
                    ? message(NC_("core", "it has {} columns without names"), widest)
                    : message(NC_("core", "it has {}"), fmt::to_string(fmt::join(head_.titles, ", ")))));
  }

  void take_asked(TraceQuantity quantity, const TraceColumn& column) {
    const std::size_t place = place_of(quantity, column.column);
    double factor = column.factor;
    std::string unit = column.unit;
    if (!column.unit_given && place < head_.titles.size()) {
      unit = recognise_column(head_.titles[place]).unit;
      factor *= trace_unit(quantity, unit).value_or(1);
    }
    take(quantity, place, factor, unit, "", column.offset);
  }

  void take_titles() {
    struct Candidate {
      std::size_t place = 0;
      NamedColumn named;
    };
    std::array<std::optional<Candidate>, trace_quantity_count> best;
    std::array<std::optional<Candidate>, actual_quantities.size()> measured;
    for (std::size_t i = 0; i < head_.titles.size(); ++i) {
      const NamedColumn named = recognise_column(head_.titles[i]);
      if (!named.quantity) {
        continue;
      }
      auto& held =
          named.actual ? measured[axis_of(*named.quantity)] : best[static_cast<std::size_t>(*named.quantity)];
      if (!held || named.rank > held->named.rank) {
        held = Candidate{i, named};
      }
    }
    for (std::size_t axis = 0; axis < measured.size(); ++axis) {
      auto& place = best[static_cast<std::size_t>(place_quantities[axis])];
      only_actual_[axis] = !place && measured[axis];
      (place ? best[static_cast<std::size_t>(actual_quantities[axis])] : place) = measured[axis];
    }
    const bool places_asked =
        asked_.of(TraceQuantity::x) || asked_.of(TraceQuantity::y) || asked_.of(TraceQuantity::z);
    for (std::size_t q = 0; q < trace_quantity_count; ++q) {
      const auto quantity = static_cast<TraceQuantity>(q);
      const bool is_place = is_position(quantity);
      if (!best[q] || found_.columns[q] || (is_place && places_asked) || is_replaced(quantity)) {
        continue;
      }
      const std::string& unit = best[q]->named.unit;
      take(quantity, best[q]->place, trace_unit(quantity, unit).value_or(1), unit,
           is_place && unit.empty() ? ", mm assumed" : "");
      unit_known_[q] = !unit.empty();
      if (is_place && quantity <= TraceQuantity::z) {
        used_actual_ += only_actual_[axis_of(quantity)] ? to_string(quantity) : std::string_view();
      }
    }
    note_actual();
  }

  /// Notes axes whose only positions are the actual ones.
  void note_actual() {
    std::vector<std::string> axes;
    for (const char axis : used_actual_) {
      axes.emplace_back(1, static_cast<char>(axis - 'x' + 'X'));
    }
    if (!axes.empty()) {
      builder_.note(
          Severity::info, 0, "trace-actual",
          message(NC_("core", "the trace has no set positions of {}: the actual ones are used instead"),
                  fmt::to_string(fmt::join(axes, ", "))),
          NC_("core",
              "feeds, ramps and corners contain what the drives do; record the set positions too to tell "
              "them apart"));
    }
  }

  void take_values() {
    std::size_t widest = 0;
    for (const auto& row : head_.rows) {
      widest = std::max(widest, row.size());
    }
    std::size_t next = 0;
    const std::vector<double> first = values_of(head_, 0);
    if (are_whole(first) && median_step(first) == 1) {
      take(TraceQuantity::number, next++, 1, "", ", it rises by one");
    } else if (asked_.period == 0 && rises_evenly(first)) {
      take(TraceQuantity::time, next++, 1, "", ", it rises");
    }
    std::size_t axis = 0;
    for (; axis < 3 && next < widest; ++axis, ++next) {
      take(place_quantities[axis], next, 1, "mm", ", assumed");
    }
    if (next < widest && are_whole(values_of(head_, next))) {
      take(TraceQuantity::line, next++, 1, "", ", whole numbers");
    }
    if (next + 1 == widest) {
      take(TraceQuantity::feed, next, 1, "mm/s", ", assumed");
    }
    builder_.note(Severity::info, static_cast<std::uint32_t>(head_.first_row + 1), "trace-columns",
                  NC_("core", "the table has no head: what its columns are is judged by their values"),
                  NC_("core", "say what they are: --columns time=1:s,x=2:mm,y=3:mm,z=4:mm"));
  }

  /// Handles a time without a unit, or no time.
  void settle_time() {
    constexpr double coarsest = 0.1;  // [s]: beyond it, the unit must be another one
    auto& time = found_.columns[static_cast<std::size_t>(TraceQuantity::time)];
    if (time) {
      const bool said = asked_.of(TraceQuantity::time)
                            ? asked_.of(TraceQuantity::time)->unit_given || time->factor != 1
                            : unit_known_[0];
      const double step = median_step(values_of(head_, time->place));
      if (!said && step >= coarsest) {
        time->factor = usual_period;
        builder_.note(
            Severity::warning, 0, "trace-time-unit",
            message(
                NC_("core", "the time has no unit and rises by {:.6g} a sample: milliseconds are assumed"),
                step),
            message(NC_("core", "say it: --columns time={}:ms"), time->place + 1));
      }
      return;
    }
    found_.clock = found_.period > 0           ? TraceClock::option
                   : asked_.machine_period > 0 ? TraceClock::machine
                                               : TraceClock::assumed;
    if (found_.clock == TraceClock::machine) {
      found_.period = asked_.machine_period;
      builder_.note(Severity::info, 0, "trace-period",
                    message(NC_("core",
                                "the trace has no times: one sample each {:.6g} ms is taken from the servo "
                                "period of the machine"),
                            units::to_ms(found_.period)),
                    NC_("core",
                        "if it was recorded at another rate, say it in samples a second, as --columns "
                        "linuxcnc,rate=1000"));
    } else if (found_.clock == TraceClock::assumed) {
      found_.period = usual_period;
      builder_.note(Severity::warning, 0, "trace-period",
                    NC_("core", "the trace has no times: one sample each millisecond is assumed"),
                    NC_("core",
                        "say the rate in samples a second, as --columns linuxcnc,rate=1000; or give the "
                        "machine its servo period"));
    }
  }

  const TableHead& head_;
  const TraceColumns& asked_;
  const std::string& name_;
  TraceBuilder& builder_;
  FoundColumns found_;
  std::array<bool, trace_quantity_count> unit_known_{};
  std::array<bool, actual_quantities.size()> only_actual_{};  ///< by axis
  std::string used_actual_;                                   ///< axes that use these: "xy"
};

}  // namespace

TableHead find_table(std::string_view text, const std::string& name, const TraceColumns& columns) {
  const std::vector<std::string_view> lines = lines_of(text);
  TableHead head;
  const std::size_t skip = std::min(columns.skip, lines.size());
  head.style = find_row_style({lines.begin() + static_cast<std::ptrdiff_t>(skip), lines.end()},
                              columns.separator, columns.decimal);
  std::vector<std::string_view> fields;
  std::size_t first = skip;
  for (; first < lines.size(); ++first) {
    split_row(lines[first], head.style.separator, fields);
    const std::size_t numbers = count_of(numbers_of(fields, head.style.decimal));
    if (numbers >= 2 && 2 * numbers > fields.size()) {
      break;
    }
  }
  if (first == lines.size()) {
    throw InputError(
        message(NC_("core",
                    "'{}' is no trace: no row of numbers in its first {} lines; known are LinuxCNC "
                    "halsampler, SINUMERIK trace (XML), TwinCAT Scope (text) and tables of samples"),
                name, lines.size()));
  }
  head.first_row = first;
  for (std::size_t i = first; i < lines.size(); ++i) {
    split_row(lines[i], head.style.separator, fields);
    head.rows.push_back(numbers_of(fields, head.style.decimal));
  }
  if (first > skip) {
    head.titles = titles_in(lines[first - 1], head.style.separator);
    if (first - skip > 1 && std::ranges::all_of(head.titles, is_unit)) {
      const std::vector<std::string> units = head.titles;
      head.titles = titles_in(lines[first - 2], head.style.separator);
      for (std::size_t i = 0; i < std::min(units.size(), head.titles.size()); ++i) {
        head.titles[i] += units[i].starts_with('[') || units[i].starts_with('(')
                              ? " " + units[i]
                              : fmt::format(" [{}]", units[i]);
      }
    }
    if (head.titles.size() < 2) {
      head.titles.clear();
    }
  }
  return head;
}

FoundColumns find_columns(const TableHead& head, const TraceColumns& asked, const std::string& name,
                          TraceBuilder& builder) {
  return ColumnFinder(head, asked, name, builder).find();
}

}  // namespace feedscope
