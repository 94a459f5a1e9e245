#include "core/program/sinumerik/geometry/path_words.h"

namespace feedscope::sinumerik {

void PathWords::apply(std::string_view name) {
  if (name == "G60") {
    control_.mode = PathMode::exact_stop;
  } else if (name.starts_with("G60")) {
    window_ = name == "G601"   ? ExactStopWindow::fine
              : name == "G602" ? ExactStopWindow::coarse
                               : ExactStopWindow::interpolation_end;
  } else if (name.starts_with("G64")) {
    control_.mode = PathMode::continuous;
    blend_ = name == "G64"    ? Blend::none
             : name == "G641" ? Blend::distance
             : name == "G644" ? Blend::dynamics
                              : Blend::tolerance;
  } else if (name == "COMPOF") {
    control_.compaction = control_.compressor = Switch::off;
  } else if (name.starts_with("COMP")) {
    control_.compaction = control_.compressor = Switch::on;
  } else if (name == "SOFT") {
    control_.acceleration = AccelerationMode::soft;
  } else if (name == "BRISK") {
    control_.acceleration = AccelerationMode::brisk;
  } else if (name == "DRIVE") {
    control_.acceleration = AccelerationMode::drive;
  } else if (name == "FFWON") {
    control_.feed_forward = Switch::on;
  } else if (name == "FFWOF") {
    control_.feed_forward = Switch::off;
  }
}

void PathWords::set_tolerance(double value) {
  tolerance_ = value < 0 ? std::nullopt : std::optional(value);
}

void PathWords::set_orientation_tolerance(double value) {
  control_.orientation_tolerance = value < 0 ? std::nullopt : std::optional(value);
}

void PathWords::set_cycle(double tolerance, int code, std::optional<double> orientation) {
  constexpr int first_older = 1000;
  constexpr int first_with_millions = 1'000'000;
  if (code % 10 == 0) {
    tolerance_.reset();
    control_.orientation_tolerance.reset();
    apply("COMPOF");
    return;
  }
  tolerance_ = tolerance;
  if (orientation) {
    control_.orientation_tolerance = orientation;
  }
  if (code >= first_older && code < first_with_millions) {
    set_older_cycle(code);
  } else {
    apply("G645");
    apply("COMPCAD");
  }
}

void PathWords::set_older_cycle(int code) {
  const int smoothing = code / 1000 % 10;
  const int feed_forward = code / 10'000 % 10;
  const int compressor = code / 100'000 % 10;
  apply(smoothing == 0 ? "G64" : smoothing == 1 ? "G641" : "G642");
  apply(feed_forward == 1 ? "FFWON" : "FFWOF");
  apply(feed_forward == 2 ? "BRISK" : "SOFT");
  apply(compressor == 0 ? "COMPOF" : "COMPCAD");
}

PathControl PathWords::control(bool rapid, bool stop) const {
  PathControl control = control_;
  if (stop) {
    control.mode = PathMode::exact_stop;
  }
  // Without G60 or G9 the windows have no effect (Programming Manual NC, 12/2019, 2.11.1).
  if (control.mode == PathMode::exact_stop) {
    control.exact_stop_window = window_;
  }
  const bool blends = control.mode == PathMode::continuous;
  if (blends && blend_ == Blend::distance) {
    // Without ADIS the control uses zero, as in G64.
    control.blend_distance = (rapid ? rapid_distance_ : distance_).value_or(0);
  }
  // The machine's default may be a blend with a tolerance.
  const bool tolerates = control.mode == PathMode::machine || (blends && blend_ == Blend::tolerance);
  if (tolerates || control.compaction == Switch::on) {
    control.contour_tolerance = tolerance_;
  }
  return control;
}

}  // namespace feedscope::sinumerik
