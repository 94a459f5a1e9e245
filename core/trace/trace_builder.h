#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/trace/trace.h"
#include "core/trace/trace_columns.h"

namespace feedscope {

/// One sample from a file, in internal units; missing values are NaN.
struct TraceSample {
  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  double time = missing;
  std::array<double, 3> place{missing, missing, missing};
  std::array<double, 3> actual{missing, missing, missing};
  double feed = missing;
  double line = missing;

  /// Sets any quantity except the number of a sample.
  void set(TraceQuantity quantity, double value);
};

/// Makes a trace from samples in the order of a file: where times go back it is divided (the longest part is
/// kept), occasional missing values are interpolated, gaps and jitter are detected.
class TraceBuilder {
 public:
  TraceBuilder(std::string name, std::string format);

  /// Declares a quantity of the file.
  void has(TraceQuantity quantity) { has_[static_cast<std::size_t>(quantity)] = true; }
  /// Whether there is a position of any axis.
  bool has_place() const;
  void set_clock(TraceClock clock) { trace_.clock = clock; }
  void note_column(std::string text) { trace_.columns.push_back(std::move(text)); }

  /// `source_line`: in the file, for messages. Throws InputError beyond 200 million samples.
  void add(const TraceSample& sample, std::uint32_t source_line);
  /// Skips a row without a sample; such rows are counted and reported once.
  void skip(std::uint32_t source_line, std::string_view row);
  void note(Severity severity, std::uint32_t source_line, std::string code, Message what, Message hint);

  /// Throws InputError if there are fewer than ten samples, or no axis.
  Trace finish();

 private:
  /// Samples between two places where the time goes back.
  struct Part {
    std::size_t begin = 0;
    std::uint32_t line = 0;
  };

  void keep_longest_part();
  /// Drops the samples outside of [begin, end).
  void keep(std::size_t begin, std::size_t end);
  bool is_there(TraceQuantity quantity) const { return has_[static_cast<std::size_t>(quantity)]; }
  void fill_missing();
  void drop_unknown_ends();
  void look_at_times();
  void look_at_jumps();
  void look_at_feed();
  double longest_jitter() const;
  std::uint32_t line_of(std::size_t sample) const;

  Trace trace_;
  std::array<bool, trace_quantity_count> has_{};
  std::vector<float> lines_;  ///< as in the file
  std::vector<Part> parts_;
  std::vector<std::pair<std::size_t, std::uint32_t>> lines_of_samples_;  ///< where rows and samples diverge
  std::uint32_t last_source_line_ = 0;
  std::size_t repeated_ = 0;
  std::uint32_t first_repeated_ = 0;
  std::size_t late_ = 0;
  std::uint32_t first_late_ = 0;
  std::size_t skipped_ = 0;
  std::uint32_t first_skipped_ = 0;
  std::string skipped_text_;
};

}  // namespace feedscope
