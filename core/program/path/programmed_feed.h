#pragma once

#include <cstdint>

#include "core/program/text/diagnostic_log.h"

namespace feedscope {

/// Meaning of F.
enum class FeedMode : std::uint8_t {
  per_minute,      ///< G94
  inverse_time,    ///< G93: F is one over the minutes of the block
  per_revolution,  ///< G95: along with the spindle speed
  per_tooth,       ///< per revolution and tooth
};

/// Feed of a program, with the spindle and the teeth on which it depends.
class ProgrammedFeed {
 public:
  /// `log` outlives it.
  explicit ProgrammedFeed(DiagnosticLog& log) : log_(log) {}

  /// A new mode has no feed yet.
  void set_mode(FeedMode mode);
  FeedMode mode() const { return mode_; }
  /// > 0; mm/s, 1/s, or mm per revolution or tooth, by the mode.
  void set_value(double value) { value_ = value; }
  /// The last valid one; 0: none yet in this mode.
  double value() const { return value_; }
  /// [1/s].
  void set_spindle_speed(double speed) { spindle_speed_ = speed; }
  double spindle_speed() const { return spindle_speed_; }
  void set_tooth_count(double teeth) { tooth_count_ = teeth; }

  /// Resulting speed of motions [mm/s]; meaningless under G93.
  double rate() const;
  /// Feed of a motion of this length [mm]; 0, with one report at `place`, if the program gives none.
  double over(double length, const DiagnosticLog::Place& place);

 private:
  void report_missing(const DiagnosticLog::Place& place);

  DiagnosticLog& log_;
  FeedMode mode_ = FeedMode::per_minute;
  double value_ = 0;
  double spindle_speed_ = 0;
  double tooth_count_ = 1;
  bool missing_reported_ = false;
};

}  // namespace feedscope
