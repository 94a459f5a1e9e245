#pragma once

#include <optional>
#include <string_view>

#include "core/program/path_control.h"

namespace feedscope::sinumerik {

/// Path control in force, stored in the control's own terms and turned into a PathControl for every motion,
/// because the meaning of a tolerance or distance depends on its G word.
class PathWords {
 public:
  /// G60, G601 to G603, G64, G641 to G645, COMPON, COMPOF, SOFT, BRISK, DRIVE, FFWON, FFWOF and similar.
  void apply(std::string_view name);
  /// CTOL [mm]; negative: the machine's again.
  void set_tolerance(double value);
  /// OTOL [rad]; negative: the machine's again.
  void set_orientation_tolerance(double value);
  /// ADIS [mm], of feed motions, and ADISPOS, of rapids.
  void set_distance(double value) { distance_ = value; }
  void set_rapid_distance(double value) { rapid_distance_ = value; }

  /// CYCLE832: tolerance [mm], code and orientation tolerance [rad]. A code of more than three digits is that
  /// of older controls: its digits also choose G64x, FFWON or FFWOF with SOFT or BRISK, and the compressor.
  void set_cycle(double tolerance, int code, std::optional<double> orientation);

  /// Path control of one motion; `stop`: with G9.
  PathControl control(bool rapid, bool stop) const;

 private:
  enum class Blend { none, distance, tolerance, dynamics };

  void set_older_cycle(int code);

  PathControl control_;
  ExactStopWindow window_ = ExactStopWindow::machine;
  Blend blend_ = Blend::none;
  std::optional<double> tolerance_;
  std::optional<double> distance_;
  std::optional<double> rapid_distance_;
};

}  // namespace feedscope::sinumerik
