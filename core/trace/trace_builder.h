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

/// One sample as a file has it, in inside units; what is not there is not a number.
struct TraceSample {
  static constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  double time = missing;
  std::array<double, 3> place{missing, missing, missing};
  std::array<double, 3> actual{missing, missing, missing};
  double feed = missing;
  double line = missing;

  /// Of all quantities but the number of a sample.
  void set(TraceQuantity quantity, double value);
};

/// Makes a trace of samples in the order of a file: times that go back part it (the longest part is kept),
/// values that are missing here and there are interpolated, gaps and jitter are found.
class TraceBuilder {
 public:
  TraceBuilder(std::string name, std::string format);

  /// Which of the quantities the file has.
  void has(TraceQuantity quantity) { has_[static_cast<std::size_t>(quantity)] = true; }
  /// Whether a position of any axis is among them.
  bool has_place() const;
  void set_clock(TraceClock clock) { trace_.clock = clock; }
  void note_column(std::string text) { trace_.columns.push_back(std::move(text)); }

  /// `source_line`: of the file, for messages. Throws InputError beyond 200 million samples.
  void add(const TraceSample& sample, std::uint32_t source_line);
  /// A row that holds no sample; counted and reported once.
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
  /// Forgets the samples outside of [begin, end).
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
  std::vector<float> lines_;  ///< as they stand in the file
  std::vector<Part> parts_;
  std::vector<std::pair<std::size_t, std::uint32_t>> lines_of_samples_;  ///< where rows and samples part
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
