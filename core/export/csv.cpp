#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>

#include "core/analysis/run/run_sources.h"
#include "core/base/error.h"
#include "core/base/units.h"
#include "core/export/export.h"
#include "core/trajectory/state_walk.h"

namespace feedscope {
namespace {

constexpr double max_rows = 1e9;              // about 300 GB; so small a step is a typing error
constexpr std::size_t buffer_size = 1 << 20;  // bytes
constexpr std::size_t rows_per_report = 4096;

/// Collects text and passes it to the stream in large blocks.
class TextSink {
 public:
  explicit TextSink(std::ostream& out) : out_(out) { buffer_.reserve(buffer_size + 1024); }

  /// Enough digits for a nanometre in ten metres; no negative zero. An empty field for NaN.
  void number(double value) {
    if (std::isnan(value)) {
      buffer_.push_back(',');
    } else {
      fmt::format_to(std::back_inserter(buffer_), "{:.11g},", value + 0.0);
    }
  }
  void vector(const Vec3& v, double factor) {
    number(v.x() * factor);
    number(v.y() * factor);
    number(v.z() * factor);
  }
  void count(std::uint32_t value) { fmt::format_to(std::back_inserter(buffer_), "{},", value); }
  void text(std::string_view value) { buffer_.append(value); }
  /// Ends a row whose last field is a number.
  void end_number_row() {
    buffer_.resize(buffer_.size() - 1);
    end_row();
  }
  void end_row() {
    buffer_.push_back('\n');
    if (buffer_.size() > buffer_size) {
      flush();
    }
  }
  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

 private:
  std::ostream& out_;
  fmt::memory_buffer buffer_;
};

std::vector<std::string> cause_keys() {
  std::vector<std::string> keys;
  for (const Cause cause : all_causes()) {
    keys.push_back(cause_key(cause));
  }
  return keys;
}

/// A column of motion: a quantity in file units.
struct Column {
  std::string_view name;
  double (*of)(const Instant&) = nullptr;
  double factor = 1;
};

/// Columns before and after the limiting cause, formerly the last column; those of the drives only for
/// machines with drives.
struct Columns {
  std::vector<Column> before_cause;
  std::vector<Column> behind_cause;
};

Columns columns_of(const RunSources& sources) {
  Columns columns;
  for (const QuantityInfo& quantity : all_quantities()) {
    if (!quantity.column.empty() && sources.has(quantity)) {
      std::vector<Column>& side =
          quantity.id <= QuantityId::tangential_jerk ? columns.before_cause : columns.behind_cause;
      side.push_back({quantity.column, quantity.of, shown_unit(quantity.dimension).factor});
    }
  }
  return columns;
}

/// Rows of samples at instants that never decrease.
class SampleRows {
 public:
  /// `from`: the first instant [s].
  SampleRows(std::ostream& out, const Trajectory& trajectory, const RunSources& sources, double from,
             std::size_t rows, Progress* progress)
      : columns_(columns_of(sources)),
        sink_(out),
        walk_(trajectory, from),
        sampler_(sources, from),
        causes_(cause_keys()),
        rows_(rows),
        progress_(progress) {
    for (const Column& column : columns_.before_cause) {
      sink_.text(column.name);
      sink_.text(",");
    }
    sink_.text("cause");
    for (const Column& column : columns_.behind_cause) {
      sink_.text(",");
      sink_.text(column.name);
    }
    sink_.end_row();
  }
  SampleRows(const SampleRows&) = delete;
  SampleRows& operator=(const SampleRows&) = delete;

  void add(double time) { add(walk_.at(time)); }
  void add(const State& state) {
    write_row(state);
    if (progress_ != nullptr && row_ % rows_per_report == 0) {
      progress_->report(static_cast<double>(row_) / static_cast<double>(rows_));
    }
    ++row_;
  }
  void end() { sink_.flush(); }

 private:
  void write_row(const State& state) {
    const Instant instant = sampler_.at(state);
    for (const Column& column : columns_.before_cause) {
      if (column.of == info_of(QuantityId::line).of) {
        sink_.count(state.line);
      } else {
        sink_.number(column.of(instant) * column.factor);
      }
    }
    sink_.text(causes_[cause_index(state.cause)]);
    sink_.text(",");
    for (const Column& column : columns_.behind_cause) {
      sink_.number(column.of(instant) * column.factor);
    }
    sink_.end_number_row();
  }

  const Columns columns_;
  TextSink sink_;
  StateWalk walk_;
  InstantSampler sampler_;
  std::vector<std::string> causes_;
  std::size_t rows_;
  std::size_t row_ = 0;
  Progress* progress_;
};

}  // namespace

void write_csv(std::ostream& out, const Trajectory& trajectory, double step, Progress* progress,
               const RunSources& sources) {
  const double duration = trajectory.duration();
  if (!(step > 0) || duration / step > max_rows) {
    throw InputError(fmt::format(
        "a step of {} s gives more than a billion rows for a cycle time of {:.6g} s; use a larger step", step,
        duration));
  }
  // A row whose printed time equals that of the end would repeat it: 11 digits distinguish 1e-10.
  const auto count = static_cast<std::size_t>(std::ceil(duration / step * (1 - 1e-10)));
  SampleRows rows(out, trajectory, sources, 0, count, progress);
  for (std::size_t row = 0; row < count; ++row) {
    rows.add(static_cast<double>(row) * step);
  }
  if (!trajectory.pieces().empty()) {
    rows.add(trajectory.state(duration));
  }
  rows.end();
}

void write_csv(std::ostream& out, const Trajectory& trajectory, std::span<const double> times,
               Progress* progress, const RunSources& sources) {
  SampleRows rows(out, trajectory, sources, times.empty() ? 0 : times.front(), times.size(), progress);
  for (const double time : trajectory.pieces().empty() ? std::span<const double>() : times) {
    rows.add(std::clamp(time, 0.0, trajectory.duration()));
  }
  rows.end();
}

std::string_view blend_kind(ElementKind kind) {
  switch (kind) {
    case ElementKind::arc:
    case ElementKind::connecting_arc:
      return "arc";
    case ElementKind::filtered:
      return "filtered";
    case ElementKind::line:
      return "overlap";
    default:
      return "cubic";
  }
}

void write_blends(std::ostream& out, const Trajectory& trajectory, const Progress* progress) {
  TextSink sink(out);
  sink.text(
      "line,kind,x_mm,y_mm,z_mm,turn_deg,transition_mm,epsilon_mm,length_mm,min_radius_mm,entry_feed_mm_min,"
      "exit_feed_mm_min");
  sink.end_row();
  FilterWalk filters;
  for (std::size_t i = 0; i < trajectory.blend_count(); ++i) {
    stop_if_cancelled(progress);
    const BlendRecord blend = trajectory.blend(i, filters);
    const ElementKind kind = trajectory.path().kind(blend.element);
    sink.count(blend.line);
    sink.text(blend_kind(kind));
    sink.text(",");
    sink.vector(blend.corner, 1);
    sink.number(units::to_deg(blend.turn));
    sink.number(blend.transition);
    sink.number(blend.epsilon);
    sink.number(blend.length);
    sink.number(blend.min_radius);
    sink.number(units::to_mm_min(blend.entry_speed));
    sink.number(units::to_mm_min(blend.exit_speed));
    sink.end_number_row();
  }
  sink.flush();
}

}  // namespace feedscope
