#include "core/program/sinumerik/geometry/feeds.h"

#include "core/base/units.h"

namespace feedscope::sinumerik {

void Feeds::set_mode(const Function& function) {
  restore_surface_speed(function.name.starts_with("G96"));
  path().set_feed_mode(function.action == Action::feed_per_minute     ? FeedMode::per_minute
                       : function.action == Action::feed_inverse_time ? FeedMode::inverse_time
                                                                      : FeedMode::per_revolution);
}

double Feeds::feed_of(double value) const {
  const double length = modal_.inch_feed ? units::from_inch(value) : value;
  switch (path().feed_mode()) {
    case FeedMode::per_minute:
      return units::from_mm_min(length);
    case FeedMode::inverse_time:
      return value / 60;
    case FeedMode::per_revolution:
    case FeedMode::per_tooth:
      break;
  }
  return length;
}

void Feeds::run() {
  // In G4 they are times, in G25 and G26 limits.
  const Function* const own = functions_.own_block;
  if (own != nullptr && (own->action == Action::dwell || own->action == Action::own_words)) {
    return;
  }
  if (words_.has('S') && words_['S'].value >= 0 && !surface_speed_) {
    path().set_spindle_speed(words_['S'].value / 60);
  }
  if (!words_.has('F')) {
    return;
  }
  const BlockWords::Value& word = words_['F'];
  if (!(word.value > 0)) {
    report(Severity::error, "feed-value", 0, word.column, [&] {
      return Text{message(NC_("core", "feed F{} is not above zero"), word.value),
                  path().feed() > 0
                      ? NC_("core", "the last valid feed stays in force; write a feed above zero")
                      : NC_("core", "feed moves run as fast as the axes allow; write a feed above zero")};
    });
    return;
  }
  path().set_feed(feed_of(word.value));
}

}  // namespace feedscope::sinumerik
