#include "core/models/guarantees.h"

#include <array>
#include <utility>

namespace feedscope {
namespace {

using Of = KeptLimit::Of;

/// Text about an acceleration or jerk that is kept in parts: the parts, the resulting bound of their sum, and
/// the part that is not bounded.
Message parts_text(const Message& what, const KeptLimit& kept, bool jerk) {
  const Message limit =
      kept.factor == 1 ? NC_("core", "the limit") : message(NC_("core", "{} times the limit"), kept.factor);
  return jerk ? message(NC_("core",
                            "{} of every axis: along the path the change of the acceleration (v'') and the "
                            "part due to curvature (v^3 k^2) each stay within {}, together within {} times "
                            "the limit; across the path (3 v v' k) it is not bounded"),
                        what, limit, 2 * kept.factor)
              : message(NC_("core",
                            "{} of every axis: along and across the path it stays within {} each, together "
                            "within {} times the limit"),
                        what, limit, 2 * kept.factor);
}

Message how_kept(const Message& what, const KeptLimit& kept, bool many) {
  if (kept.of == Of::nothing) {
    return many ? message(NC_("core", "{} are not bounded"), what)
                : message(NC_("core", "{} is not bounded"), what);
  }
  if (kept.factor == 1) {
    return many ? message(NC_("core", "{} of every axis are kept"), what)
                : message(NC_("core", "{} of every axis is kept"), what);
  }
  return many ? message(NC_("core", "{} of every axis stay within {} times the limit"), what, kept.factor)
              : message(NC_("core", "{} of every axis stays within {} times the limit"), what, kept.factor);
}

/// "velocity of every axis is kept; acceleration and jerk of every axis are not bounded".
Message kept_text(const KeptLimits& limits) {
  const std::array<std::pair<Message, KeptLimit>, 3> all{
      {{NC_("core", "velocity"), limits.velocity},
       {NC_("core", "acceleration"), limits.acceleration},
       {limits.of_blend_jerk ? NC_("core", "jerk (blend_jerk)") : NC_("core", "jerk"), limits.jerk}}};
  Message text;
  for (std::size_t i = 0; i < all.size();) {
    const KeptLimit& kept = all[i].second;
    Message part;
    if (kept.of == Of::parts) {  // a jerk has other parts than an acceleration
      part = parts_text(all[i].first, kept, i == 2);
      ++i;
    } else {
      std::vector<Message> words;
      for (; i < all.size() && all[i].second == kept; ++i) {
        words.push_back(all[i].first);
      }
      part = how_kept(listed(words), kept, words.size() > 1);
    }
    text = text.empty() ? part : message(NC_("core", "{}; {}"), text, part);
  }
  return text;
}

Message covered_sentence(Covered covered) {
  return covered == Covered::lines
             ? NC_("core",
                   "The source covers lines and their corners; arcs and helices follow the shared rules.")
             : NC_("core", "The source covers arcs; lines follow the shared rules.");
}

Message feed_sentence(const Guarantees& g) {
  const Message feed = g.feed_of_run ? NC_("core", "the largest programmed feed between two standstills")
                                     : NC_("core", "the programmed feed");
  if (g.feed == Guarantees::unbounded && !g.rounds_places) {
    return NC_("core",
               "The programmed feed is kept along every block; where two blocks overlap their speeds add.");
  }
  if (g.feed == Guarantees::unbounded) {
    return NC_(
        "core",
        "The programmed feed is met to whole steps and counts of a timer; very slow feeds are exceeded.");
  }
  if (!g.rapids_of_axes) {
    return message(NC_("core", "Never faster than {}; rapids run at the maximum velocity of the control."),
                   feed);
  }
  return g.feed == 1
             ? message(NC_("core", "Never faster than {}; rapids never faster than the axes allow."), feed)
             : message(NC_("core", "Never faster than {} times {}."), g.feed, feed);
}

Message contour_sentence(const Guarantees& g) {
  if (g.contour == 0 && g.rounds_places) {
    return NC_("core",
               "The programmed path is followed by straight blocks, arcs by chords within the arc tolerance; "
               "no corner is blended. Ends of blocks are rounded to whole steps of the axes.");
  }
  if (g.contour == 0 && g.arcs_are_chords) {
    return NC_("core",
               "The programmed path is followed by straight blocks, arcs by chords; no corner is blended.");
  }
  if (g.contour == 0) {
    return NC_("core", "The programmed path is followed exactly; no corner is blended.");
  }
  if (g.contour == Guarantees::unbounded) {
    return g.meets_tangent_ends
               ? NC_("core",
                     "The distance of programmed corners from the path is not bounded; tangent transitions "
                     "between blocks are passed exactly.")
               : NC_("core", "The distance of programmed corners from the path is not bounded.");
  }
  if (g.contour == 1) {
    return g.meets_tangent_ends
               ? NC_("core",
                     "Every programmed corner lies within the contour tolerance of the path; tangent "
                     "transitions between blocks are passed exactly.")
               : NC_("core", "Every programmed corner lies within the contour tolerance of the path.");
  }
  return g.meets_tangent_ends
             ? message(NC_("core",
                           "Every programmed corner lies within {} times the contour tolerance of the path; "
                           "tangent transitions between blocks are passed exactly."),
                       g.contour)
             : message(NC_("core",
                           "Every programmed corner lies within {} times the contour tolerance of the path."),
                       g.contour);
}

Message continuity_sentence(Continuity continuity) {
  switch (continuity) {
    case Continuity::position:
      return NC_("core", "The speed jumps along the path.");
    case Continuity::speed:
      return NC_("core",
                 "The speed is continuous; the acceleration jumps where the curvature of the path does.");
    case Continuity::acceleration:
      break;
  }
  return NC_("core", "Velocity and acceleration are continuous everywhere.");
}

Message turning_sentence(const Guarantees& g) {
  return g.turning_rapids_only ? message(NC_("core",
                                             "Where rotary axes turn in rapids, every axis of the machine "
                                             "stays within {} times its velocity."),
                                         g.turning_velocity)
                               : message(NC_("core",
                                             "Where rotary axes turn, every axis of the machine stays within "
                                             "{} times its velocity."),
                                         g.turning_velocity);
}

Message stop_sentence(const Guarantees& g) {
  std::vector<Message> places;
  if (g.stops_at_line_corners) {
    places.emplace_back(NC_("core", "at corners of lines"));
  }
  if (g.stops_at_arc_corners) {
    places.emplace_back(NC_("core", "at corners that touch an arc"));
  }
  if (g.stops_at_reversals) {
    places.emplace_back(NC_("core", "at reversals"));
  }
  if (g.stops_at_rapids) {
    places.emplace_back(NC_("core", "before and after every rapid"));
  }
  return places.empty() ? NC_("core", "Full stops at dwells only.")
                        : message(NC_("core", "Full stops {}."), listed(places));
}

}  // namespace

KeptLimits all_kept() {
  return {{Of::whole, 1}, {Of::whole, 1}, {Of::whole, 1}, false};
}

KeptLimits static_arc_limits() {
  return {{Of::whole, 1}, {Of::parts, 1}, {Of::parts, 1}, false};
}

std::vector<Message> sentences(const Guarantees& g) {
  std::vector<Message> text;
  if (g.covered != Covered::both) {
    text.push_back(covered_sentence(g.covered));
  }
  text.push_back(contour_sentence(g));
  text.push_back(feed_sentence(g));
  text.push_back(message(NC_("core", "On lines: {}."), kept_text(g.lines)));
  text.push_back(message(NC_("core", "On arcs: {}."), kept_text(g.arcs)));
  if (g.contour > 0) {
    text.push_back(message(NC_("core", "On corner blends: {}."), kept_text(g.blends)));
  }
  if (g.lays_curves) {
    text.push_back(message(NC_("core", "On smooth curves: {}."), kept_text(g.curves)));
  }
  if (g.turning_velocity < Guarantees::unbounded) {
    text.push_back(turning_sentence(g));
  }
  text.push_back(continuity_sentence(g.continuity));
  if (g.continuity != Continuity::position) {
    text.emplace_back(g.follows_brisk
                          ? NC_("core",
                                "Where the program asks for BRISK, no jerk along the path is bounded: its "
                                "acceleration changes within one interpolation period.")
                          : NC_("core", "BRISK of the program is not followed."));
  }
  if (g.meets_tangent_ends) {
    text.emplace_back(
        NC_("core",
            "A junction that touches an arc and turns by up to 0.01 rad is passed as if it were tangent: "
            "there the velocity of an axis jumps by up to 1 % of the feed (1 mm/s at 6000 mm/min)."));
  }
  text.push_back(stop_sentence(g));
  return text;
}

}  // namespace feedscope
