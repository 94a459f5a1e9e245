#include "core/program/path/programmed_feed.h"

namespace feedscope {

void ProgrammedFeed::set_mode(FeedMode mode) {
  if (mode != mode_) {
    mode_ = mode;
    value_ = 0;
  }
}

double ProgrammedFeed::rate() const {
  switch (mode_) {
    case FeedMode::per_minute:
    case FeedMode::inverse_time:
      break;
    case FeedMode::per_revolution:
      return value_ * spindle_speed_;
    case FeedMode::per_tooth:
      return value_ * tooth_count_ * spindle_speed_;
  }
  return value_;
}

double ProgrammedFeed::over(double length, const DiagnosticLog::Place& place) {
  const double feed = rate() * (mode_ == FeedMode::inverse_time ? length : 1);
  if (feed == 0 && length > 0) {
    report_missing(place);
  }
  return feed;
}

void ProgrammedFeed::report_missing(const DiagnosticLog::Place& place) {
  if (missing_reported_) {
    return;
  }
  missing_reported_ = true;
  const bool no_spindle = value_ > 0 && spindle_speed_ == 0;
  log_.add(Severity::error, "feed-missing", 0, place, [&] {
    return DiagnosticLog::Text{no_spindle ? NC_("core", "a feed per revolution without a spindle speed")
                                          : NC_("core", "a feed move without a feed"),
                               no_spindle
                                   ? NC_("core", "it runs as fast as the axes allow; write S before it")
                                   : NC_("core", "it runs as fast as the axes allow; write F before it")};
  });
}

}  // namespace feedscope
