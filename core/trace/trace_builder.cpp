#include "core/trace/trace_builder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/units.h"

namespace feedscope {
namespace {

constexpr std::size_t most_samples = 200'000'000;
constexpr std::size_t least_samples = 10;
constexpr std::size_t most_listed = 5;
constexpr std::size_t shown_text = 60;
constexpr double gap_share = 1.75;  // of the period: a sample is missing

/// Numbers of missing values filled in.
struct Filled {
  std::size_t between = 0;  ///< interpolated
  std::size_t held = 0;     ///< copies of the last known one
};

/// Longest distance between two known samples of a signal with a lower rate than others, in samples. If more
/// are missing, the recorder has omitted them because the value did not change.
template <class Number>
std::size_t longest_between(const std::vector<Number>& values) {
  constexpr std::size_t least = 10;
  constexpr std::size_t much_longer = 5;
  std::vector<std::size_t> steps;
  std::size_t known = values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) {
      if (known < values.size()) {
        steps.push_back(i - known);
      }
      known = i;
    }
  }
  if (steps.empty()) {
    return least;
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return std::max(least, much_longer * *middle);
}

/// Fills missing values between two known ones by interpolation; with `hold`, if many are missing, and after
/// the last one, by the previous value. Values before the first one stay missing.
template <class Number>
Filled fill_between(const std::vector<double>& time, std::vector<Number>& values, bool hold) {
  Filled filled;
  const std::size_t longest = longest_between(values);
  std::size_t known = values.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) {
      continue;
    }
    const bool held = hold || i - known > longest;
    for (std::size_t k = known + 1; known < values.size() && k < i; ++k) {
      const double share = held ? 0 : (time[k] - time[known]) / (time[i] - time[known]);
      const auto from = static_cast<double>(values[known]);
      values[k] = static_cast<Number>(from + share * (static_cast<double>(values[i]) - from));
      ++(held ? filled.held : filled.between);
    }
    known = i;
  }
  if (known < values.size() && values.size() - known > longest) {
    for (std::size_t k = known + 1; k < values.size(); ++k) {
      values[k] = values[known];
      ++filled.held;
    }
  }
  return filled;
}

/// Speed of the positions over the recorded feed, where that is steady; 0 if it varies from place to place or
/// few places show it. Some controls record the feed a few samples ahead of the positions.
double steady_feed_ratio(const Trace& trace) {
  constexpr std::size_t reach = 8;  // samples
  constexpr float steady = 0.005F;
  constexpr std::size_t least = 100;
  constexpr double same = 0.03;
  constexpr double nearly_all = 0.8;
  constexpr std::size_t most = 20'000;
  const std::size_t stride = 1 + trace.size() / most;
  std::vector<double> ratios;
  for (std::size_t i = reach; i + reach < trace.size(); i += stride) {
    const float feed = trace.feed[i];
    const auto is_steady = [&](std::size_t other) {
      return std::abs(trace.feed[other] - feed) <= steady * feed;
    };
    const double time = trace.time[i + reach / 2] - trace.time[i - reach / 2];
    if (feed > 0 && time < gap_share * reach * trace.period && is_steady(i - reach) && is_steady(i + reach)) {
      const double way = (trace.place_at(i + reach / 2) - trace.place_at(i - reach / 2)).norm();
      ratios.push_back(way / time / static_cast<double>(feed));
    }
  }
  if (ratios.size() < least) {
    return 0;
  }
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  const double median = *middle;
  const auto like_it =
      std::ranges::count_if(ratios, [&](double ratio) { return std::abs(ratio - median) <= same * median; });
  return static_cast<double>(like_it) >= nearly_all * static_cast<double>(ratios.size()) ? median : 0;
}

/// Whether a ratio is that of two units of feed rather than of two rates.
bool is_ratio_of_units(double ratio) {
  constexpr double same = 0.03;
  constexpr std::array factors{60.0, 25.4, 1000.0, 1000.0 / 60, 25.4 * 60};
  return std::ranges::any_of(factors, [&](double factor) {
    return std::abs(ratio / factor - 1) < same || std::abs(ratio * factor - 1) < same;
  });
}

template <class Number>
void cut(std::vector<Number>& values, std::size_t begin, std::size_t end) {
  if (!values.empty()) {
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(end), values.end());
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(begin));
  }
}

}  // namespace

void TraceSample::set(TraceQuantity quantity, double value) {
  switch (quantity) {
    case TraceQuantity::time:
      time = value;
      break;
    case TraceQuantity::number:
      break;
    case TraceQuantity::x:
    case TraceQuantity::y:
    case TraceQuantity::z:
      place[static_cast<std::size_t>(quantity) - static_cast<std::size_t>(TraceQuantity::x)] = value;
      break;
    case TraceQuantity::line:
      line = value;
      break;
    case TraceQuantity::feed:
      feed = value;
      break;
    case TraceQuantity::actual_x:
    case TraceQuantity::actual_y:
    case TraceQuantity::actual_z:
      actual[static_cast<std::size_t>(quantity) - static_cast<std::size_t>(TraceQuantity::actual_x)] = value;
      break;
  }
}

TraceBuilder::TraceBuilder(std::string name, std::string format) {
  trace_.name = std::move(name);
  trace_.format = std::move(format);
}

bool TraceBuilder::has_place() const {
  return std::ranges::any_of(place_quantities, [&](TraceQuantity quantity) { return is_there(quantity); });
}

void TraceBuilder::note(Severity severity, std::uint32_t source_line, std::string code, Message what,
                        Message hint) {
  trace_.notes.push_back({.severity = severity,
                          .line = source_line,
                          .column = 0,
                          .code = std::move(code),
                          .message = std::move(what),
                          .hint = std::move(hint)});
}

void TraceBuilder::skip(std::uint32_t source_line, std::string_view row) {
  if (skipped_++ == 0) {
    first_skipped_ = source_line;
    for (const char c : row.substr(0, shown_text)) {
      const auto byte = static_cast<unsigned char>(c);
      skipped_text_ += byte < 0x20 || byte >= 0x7F ? '?' : c;
    }
  }
}

void TraceBuilder::add(const TraceSample& sample, std::uint32_t source_line) {
  constexpr double longest = 1e12;   // [s]
  constexpr double farthest = 1e12;  // [mm]: beyond any axis; such a number marks a missing value
  if (!(std::abs(sample.time) < longest)) {
    skip(source_line, "a row without a time");
    return;
  }
  if (!trace_.time.empty()) {
    const double step = sample.time - trace_.time.back();
    if (step == 0) {
      first_repeated_ = repeated_++ == 0 ? source_line : first_repeated_;
      return;
    }
    if (step < 0 && -step <= longest_jitter()) {
      first_late_ = late_++ == 0 ? source_line : first_late_;
      return;
    }
    if (step < 0) {
      if (parts_.size() <= most_listed) {
        note(Severity::warning, source_line, "trace-time-back",
             message(NC_("core", "the time goes back from {:.6g} s to {:.6g} s"), trace_.time.back(),
                     sample.time),
             NC_("core", "only the longest part between two such places is used"));
      }
      parts_.push_back({trace_.time.size(), source_line});
    }
  } else {
    parts_.push_back({0, source_line});
  }
  if (trace_.time.size() >= most_samples) {
    throw InputError(message(NC_("core", "{}:{}: the trace has more than {} million samples"), trace_.name,
                             source_line, most_samples / 1'000'000));
  }
  if (source_line != last_source_line_ + 1 || trace_.time.empty()) {
    lines_of_samples_.emplace_back(trace_.time.size(), source_line);
  }
  last_source_line_ = source_line;
  trace_.time.push_back(sample.time);
  const auto known = [](double place) { return std::abs(place) < farthest ? place : TraceSample::missing; };
  for (std::size_t axis = 0; axis < place_quantities.size(); ++axis) {
    if (is_there(place_quantities[axis])) {
      trace_.place[axis].push_back(known(sample.place[axis]));
    }
    if (is_there(actual_quantities[axis])) {
      trace_.actual[axis].push_back(known(sample.actual[axis]));
    }
  }
  if (is_there(TraceQuantity::feed)) {
    trace_.feed.push_back(static_cast<float>(sample.feed));
  }
  if (is_there(TraceQuantity::line)) {
    lines_.push_back(static_cast<float>(sample.line));
  }
}

/// How far the time of a sample with jitter may be before that of the previous one [s]; 0 while too little is
/// known.
double TraceBuilder::longest_jitter() const {
  constexpr double periods = 3;
  const std::size_t begin = parts_.back().begin;
  const std::size_t count = trace_.time.size() - begin;
  return count < least_samples
             ? 0
             : periods * (trace_.time.back() - trace_.time[begin]) / static_cast<double>(count - 1);
}

std::uint32_t TraceBuilder::line_of(std::size_t sample) const {
  const auto after =
      std::ranges::upper_bound(lines_of_samples_, sample, {}, &std::pair<std::size_t, std::uint32_t>::first);
  if (after == lines_of_samples_.begin()) {
    return 0;
  }
  const auto& [first, line] = *std::prev(after);
  return line + static_cast<std::uint32_t>(sample - first);
}

void TraceBuilder::keep_longest_part() {
  std::size_t begin = 0;
  std::size_t end = trace_.time.size();
  if (parts_.size() > 1) {
    std::size_t most = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const std::size_t until = i + 1 < parts_.size() ? parts_[i + 1].begin : trace_.time.size();
      if (until - parts_[i].begin > most) {
        most = until - parts_[i].begin;
        begin = parts_[i].begin;
        end = until;
      }
    }
    note(Severity::warning, line_of(begin), "trace-parts",
         parts_.size() == 2
             ? message(NC_("core", "the time goes back once; the longest part with {} of {} samples is used"),
                       most, trace_.time.size())
             : message(
                   NC_("core", "the time goes back {} times; the longest part with {} of {} samples is used"),
                   parts_.size() - 1, most, trace_.time.size()),
         NC_("core", "record one run in one trace"));
  }
  keep(begin, end);
}

void TraceBuilder::keep(std::size_t begin, std::size_t end) {
  cut(trace_.time, begin, end);
  for (auto* places : {&trace_.place, &trace_.actual}) {
    for (auto& values : *places) {
      cut(values, begin, end);
    }
  }
  cut(trace_.feed, begin, end);
  cut(lines_, begin, end);
  for (auto& [sample, line] : lines_of_samples_) {
    sample = sample > begin ? sample - begin : 0;
  }
}

void TraceBuilder::fill_missing() {
  Filled filled;
  for (auto* places : {&trace_.place, &trace_.actual}) {
    for (auto& values : *places) {
      const Filled of_axis = fill_between(trace_.time, values, false);
      filled.between += of_axis.between;
      filled.held += of_axis.held;
    }
  }
  fill_between(trace_.time, trace_.feed, false);
  fill_between(trace_.time, lines_, true);
  if (filled.between > 0) {
    note(Severity::info, 0, "trace-interpolated",
         message(NC_("core", "{} missing positions are interpolated between their neighbours"),
                 filled.between),
         NC_("core", "signals recorded at one rate need none"));
  }
  if (filled.held > 0) {
    note(Severity::info, 0, "trace-unchanged",
         message(NC_("core", "{} positions that are missing for long are those before them"), filled.held),
         NC_("core", "recorders that write changes alone leave them out"));
  }
}

void TraceBuilder::drop_unknown_ends() {
  const auto known = [&](std::size_t i) {
    const auto is_known = [&](const auto& values) { return values.empty() || std::isfinite(values[i]); };
    return std::ranges::all_of(trace_.place, is_known) && std::ranges::all_of(trace_.actual, is_known);
  };
  std::size_t begin = 0;
  std::size_t end = trace_.time.size();
  while (begin < end && !known(begin)) {
    ++begin;
  }
  while (end > begin && !known(end - 1)) {
    --end;
  }
  keep(begin, end);
  for (float& feed : trace_.feed) {
    feed = std::isfinite(feed) ? feed : 0;
  }
}

void TraceBuilder::look_at_times() {
  constexpr double coarse = 0.0101;  // [s]
  std::vector<double> steps;
  steps.reserve(trace_.time.size() - 1);
  for (std::size_t i = 1; i < trace_.time.size(); ++i) {
    steps.push_back(trace_.time[i] - trace_.time[i - 1]);
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  trace_.period = *middle;
  double squares = 0;
  std::size_t counted = 0;
  for (std::size_t i = 1; i < trace_.time.size(); ++i) {
    const double step = trace_.time[i] - trace_.time[i - 1];
    if (step <= gap_share * trace_.period) {
      squares += (step - trace_.period) * (step - trace_.period);
      ++counted;
      continue;
    }
    trace_.lost += step - trace_.period;
    if (trace_.gaps++ < most_listed) {
      note(Severity::warning, line_of(i), "trace-gap",
           message(NC_("core", "{:.6g} ms without a sample at {:.6g} s"), units::to_ms(step),
                   trace_.time[i - 1] - trace_.time.front()),
           NC_("core", "what happened there is not known; ramps and corners there tell nothing"));
    }
  }
  if (trace_.gaps > most_listed) {
    note(Severity::warning, 0, "trace-gap",
         message(NC_("core", "{} more stretches without samples, {:.6g} s in all"), trace_.gaps - most_listed,
                 trace_.lost),
         NC_("core", "record less signals, or at a lower rate"));
  }
  trace_.jitter = counted > 0 ? std::sqrt(squares / static_cast<double>(counted)) : 0;
  if (trace_.jitter > 0.1 * trace_.period) {
    note(Severity::info, 0, "trace-jitter",
         message(NC_("core", "samples are {:.3g} ms apart, give or take {:.3g} ms"),
                 units::to_ms(trace_.period), units::to_ms(trace_.jitter)),
         NC_("core", "times are used as they stand"));
  }
  if (trace_.period > coarse) {
    note(Severity::warning, 0, "trace-coarse",
         message(NC_("core",
                     "one sample each {:.4g} ms: ramps and corners that last less than {:.4g} ms cannot be "
                     "told apart"),
                 units::to_ms(trace_.period), units::to_ms(3 * trace_.period)),
         NC_("core", "record at 1 to 4 ms; times and velocities of long moves are right as it is"));
  }
}

/// Finds position jumps that no machine makes between two samples.
void TraceBuilder::look_at_jumps() {
  constexpr double least = 1;       // [mm]
  constexpr double much_more = 10;  // times the neighbouring steps
  std::size_t count = 0;
  const auto step = [&](std::size_t from, std::size_t to) {
    return (trace_.place_at(to) - trace_.place_at(from)).norm();
  };
  const auto report = [&](std::size_t i, const Message& what, const Message& hint) {
    if (count++ < most_listed) {
      note(Severity::warning, line_of(i), "trace-jump", what, hint);
    }
  };
  for (std::size_t i = 1; i + 1 < trace_.size(); ++i) {
    const double here = step(i - 1, i);
    const double time = trace_.time[i] - trace_.time[i - 1];
    if (here < least || here <= fastest_possible * time || time > gap_share * trace_.period) {
      continue;
    }
    const double behind = step(i, i + 1);
    const double before = i > 1 ? step(i - 2, i - 1) : 0;
    const double at = trace_.time[i] - trace_.time.front();
    if (behind > here / 2 && step(i - 1, i + 1) * much_more < here) {
      report(i,
             message(NC_("core", "the sample at {:.6g} s lies {:.4g} mm beside those before and after it"),
                     at, here),
             NC_("core", "it is not compared; the others are right"));
      ++i;
    } else if (here > much_more * std::max(before, behind)) {
      report(i,
             message(NC_("core", "the position jumps by {:.4g} mm within {:.4g} ms at {:.6g} s"), here,
                     units::to_ms(time), at),
             NC_("core",
                 "samples are missing there without a gap in the times: all later times, and the cycle time, "
                 "are too short by an unknown time"));
    }
  }
  if (count > most_listed) {
    note(Severity::warning, 0, "trace-jump",
         message(NC_("core", "{} more jumps of the position"), count - most_listed),
         NC_("core", "check how the trace was recorded"));
  }
}

/// For traces without times: checks the feed reported by the control against that of the positions.
void TraceBuilder::look_at_feed() {
  constexpr double about_one = 0.05;
  const bool all_axes = std::ranges::none_of(trace_.place, &std::vector<double>::empty);
  if (trace_.clock == TraceClock::times || trace_.feed.empty() || !all_axes) {
    return;
  }
  const double ratio = steady_feed_ratio(trace_);
  if (ratio == 0 || std::abs(ratio - 1) < about_one || is_ratio_of_units(ratio)) {
    return;
  }
  note(Severity::warning, 0, "trace-rate",
       message(NC_("core",
                   "the positions of the trace move at {:.3g} % of the feed that it records: its sampling "
                   "rate is wrong"),
               100 * ratio),
       message(NC_("core",
                   "give the right rate, {0:.0f} samples a second, as --columns linuxcnc,rate={0:.0f}; or "
                   "leave the column of the feed out"),
               1 / (trace_.period * ratio)));
}

Trace TraceBuilder::finish() {
  if (skipped_ > 0) {
    note(Severity::warning, first_skipped_, "trace-row",
         skipped_ == 1
             ? message(NC_("core", "a row without numbers is skipped, the first is '{}'"), skipped_text_)
             : message(NC_("core", "{} rows without numbers are skipped, the first is '{}'"), skipped_,
                       skipped_text_),
         NC_("core", "remove rows that are not data, or check the columns"));
  }
  if (repeated_ > 0) {
    note(Severity::warning, first_repeated_, "trace-time-repeated",
         message(NC_("core", "{} samples at the time of the one before are skipped"), repeated_),
         NC_("core", "record the time with more digits"));
  }
  if (late_ > 0) {
    note(Severity::warning, first_late_, "trace-time-jitter",
         message(NC_("core", "{} samples with a time a little before that of the sample ahead are skipped"),
                 late_),
         NC_("core", "the times jitter by more than a period: record the time of the control's cycle"));
  }
  if (!has_place()) {
    throw InputError(message(
        NC_("core", "'{}' has no position of X, Y or Z; name their columns, as --columns x=2:mm,y=3:mm"),
        trace_.name));
  }
  keep_longest_part();
  if (trace_.time.size() > 1) {
    fill_missing();
    drop_unknown_ends();
  }
  if (trace_.time.size() < least_samples) {
    throw InputError(
        message(NC_("core", "'{}' has too few samples whose times rise: {}; a trace has at least {}"),
                trace_.name, trace_.time.size(), least_samples));
  }
  look_at_times();
  look_at_jumps();
  look_at_feed();
  const double first = trace_.time.front();
  for (double& time : trace_.time) {
    time -= first;
  }
  if (is_there(TraceQuantity::line)) {
    trace_.line.reserve(lines_.size());
    constexpr float largest = 16'777'216;  // largest float with exact whole numbers
    for (const float line : lines_) {
      trace_.line.push_back(line >= 0 && line < largest ? static_cast<std::uint32_t>(line) : 0);
    }
  }
  return std::move(trace_);
}

}  // namespace feedscope
