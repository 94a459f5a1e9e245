#include "core/program/sinumerik/geometry/motion.h"

#include <algorithm>
#include <cmath>

namespace feedscope::sinumerik {

bool Motions::has_words() const {
  const bool arc = modal_.motion != nullptr && Arcs::makes(modal_.motion->action);
  return words_.has_any("XYZ") || words_.is_polar() || words_.has(Address::ang) ||
         (arc && (words_.has_any("IJK") || words_.has(Address::ar) || words_.has(Address::cr)));
}

bool Motions::run() {
  if (parts_.splines.begun() && modal_.motion->action != Action::spline) {
    parts_.splines.finish();
  }
  if (!has_words()) {
    check_unused(false);
    parts_.corners.cut(false);
    return false;
  }
  if (functions_.machine_axes != nullptr) {
    parts_.splines.finish();
    parts_.machine_positions.move();
    return false;
  }
  if (modal_.motion == nullptr) {
    report(Severity::warning, "motion-mode", 0, words_.first_column("XYZ"), [] {
      return Text{NC_("core", "position words before the first G0, G1, G2 or G3"),
                  NC_("core", "G1 is used; write the G word")};
    });
    modal_.motion = find_g(1);
  }
  const Action action = modal_.motion->action;
  if (action == Action::unread_motion) {
    return false;
  }
  check_unused(Arcs::makes(action));
  move(action);
  return true;
}

void Motions::move(Action action) {
  path().set_column(written(words_.first_column("XYZIJK")));
  parts_.path_modes.use(action == Action::rapid);
  const double feed = path().feed();
  if (words_.has(Address::fb)) {
    path().set_feed(parts_.feeds.feed_of(words_[Address::fb].value));
  }
  parts_.corners.cut(action == Action::rapid || action == Action::line || Arcs::makes(action));
  const Vec3 target = parts_.targets.target(parts_.splines.position());
  Vec3 start = path().position();
  parts_.targets.program_axes();
  switch (action) {
    case Action::rapid:
      parts_.last.set_line();
      path().rapid(target);
      break;
    case Action::line:
      parts_.last.set_line();
      path().line(target);
      break;
    case Action::thread:
      thread(target);
      break;
    case Action::spline:
      parts_.splines.collect(target);
      break;
    case Action::polynomial:
      start = parts_.polynomials.move(target);
      break;
    default:
      parts_.arcs.move(target);
  }
  if (words_.has(Address::fb)) {
    path().set_feed(feed);
  }
  parts_.last.set_start(start);
}

void Motions::check_unused(bool arc) const {
  if (arc || !words_.has_any("IJK")) {
    return;
  }
  const Action action = modal_.motion == nullptr ? Action::line : modal_.motion->action;
  if (action == Action::thread || action == Action::unread_motion) {
    return;
  }
  for (const char letter : {'I', 'J', 'K'}) {
    if (words_.has(letter)) {
      report(Severity::warning, "unused-word", letter, words_[letter].column, [&] {
        return Text{message(NC_("core", "{}{} has no meaning in this block"), letter, words_[letter].value),
                    NC_("core", "it is ignored; check whether G2 or G3 is missing")};
      });
    }
  }
}

/// A thread's feed is its lead times the spindle speed.
void Motions::thread(const Vec3& target) {
  double lead = 0;
  for (const char letter : {'I', 'J', 'K'}) {
    lead = words_.has(letter) ? std::max(lead, std::abs(to_mm(words_[letter].value))) : lead;
  }
  report(Severity::info, "thread", 0, words_.first_column("XYZ"), [&] {
    return Text{message(NC_("core", "{} (thread) is shown as a line"), modal_.motion->name),
                NC_("core", "its feed is lead times spindle speed; the run-up of the spindle is not shown")};
  });
  const FeedMode mode = path().feed_mode();
  const double feed = path().feed();
  path().set_feed_mode(FeedMode::per_revolution);
  path().set_feed(lead);
  parts_.last.set_line();
  path().line(target);
  path().set_feed_mode(mode);
  path().set_feed(feed);
}

}  // namespace feedscope::sinumerik
