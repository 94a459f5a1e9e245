#include "core/models/guarantees.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace feedscope {
namespace {

using Of = KeptLimit::Of;

/// "velocity, acceleration and jerk".
std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return text;
}

/// Text about an acceleration or jerk that is kept in parts: the parts, the resulting bound of their sum, and
/// the part that is not bounded.
std::string parts_text(const KeptLimit& kept, bool jerk) {
  const std::string limit = kept.factor == 1 ? "the limit" : fmt::format("{} times the limit", kept.factor);
  return jerk ? fmt::format(
                    "of every axis: along the path the change of the acceleration (v'') and the part due to "
                    "curvature (v^3 k^2) each stay within {}, together within {} times the limit; across the "
                    "path (3 v v' k) it is not bounded",
                    limit, 2 * kept.factor)
              : fmt::format(
                    "of every axis: along and across the path it stays within {} each, together within "
                    "{} times the limit",
                    limit, 2 * kept.factor);
}

std::string how_kept(const KeptLimit& kept, bool many) {
  if (kept.of == Of::nothing) {
    return many ? "are not bounded" : "is not bounded";
  }
  if (kept.factor == 1) {
    return many ? "of every axis are kept" : "of every axis is kept";
  }
  return fmt::format("of every axis {} within {} times the limit", many ? "stay" : "stays", kept.factor);
}

std::string place_sentence(const char* place, const KeptLimits& limits) {
  const std::array<std::pair<std::string, KeptLimit>, 3> all{
      {{"velocity", limits.velocity},
       {"acceleration", limits.acceleration},
       {limits.of_blend_jerk ? "jerk (blend_jerk)" : "jerk", limits.jerk}}};
  std::string text = place;
  for (std::size_t i = 0; i < all.size();) {
    std::vector<std::string> words;
    const KeptLimit& kept = all[i].second;
    text += i == 0 ? ": " : "; ";
    if (kept.of == Of::parts) {  // a jerk has other parts than an acceleration
      text += all[i].first + " " + parts_text(kept, i == 2);
      ++i;
      continue;
    }
    for (; i < all.size() && all[i].second == kept; ++i) {
      words.push_back(all[i].first);
    }
    text += listed(words) + " " + how_kept(kept, words.size() > 1);
  }
  return text + ".";
}

std::string covered_sentence(Covered covered) {
  return covered == Covered::lines
             ? "The source covers lines and their corners; arcs and helices follow the shared rules."
             : "The source covers arcs; lines follow the shared rules.";
}

std::string feed_sentence(const Guarantees& g) {
  const std::string feed =
      g.feed_of_run ? "the largest programmed feed between two standstills" : "the programmed feed";
  if (g.feed == Guarantees::unbounded && !g.rounds_places) {
    return "The programmed feed is kept along every block; where two blocks overlap their speeds add.";
  }
  if (g.feed == Guarantees::unbounded) {
    return "The programmed feed is met to whole steps and counts of a timer; very slow feeds are exceeded.";
  }
  if (!g.rapids_of_axes) {
    return fmt::format("Never faster than {}; rapids run at the maximum velocity of the control.", feed);
  }
  return g.feed == 1 ? fmt::format("Never faster than {}; rapids never faster than the axes allow.", feed)
                     : fmt::format("Never faster than {} times {}.", g.feed, feed);
}

std::string contour_sentence(const Guarantees& g) {
  std::string text;
  if (g.contour == 0 && g.rounds_places) {
    return "The programmed path is followed by straight blocks, arcs by chords within the arc tolerance; no "
           "corner is blended. Ends of blocks are rounded to whole steps of the axes.";
  }
  if (g.contour == 0 && g.arcs_are_chords) {
    return "The programmed path is followed by straight blocks, arcs by chords; no corner is blended.";
  }
  if (g.contour == 0) {
    return "The programmed path is followed exactly; no corner is blended.";
  }
  if (g.contour == Guarantees::unbounded) {
    text = "The distance of programmed corners from the path is not bounded";
  } else if (g.contour == 1) {
    text = "Every programmed corner lies within the contour tolerance of the path";
  } else {
    text = fmt::format("Every programmed corner lies within {} times the contour tolerance of the path",
                       g.contour);
  }
  return text + (g.meets_tangent_ends ? "; tangent transitions between blocks are passed exactly." : ".");
}

std::string continuity_sentence(Continuity continuity) {
  switch (continuity) {
    case Continuity::position:
      return "The speed jumps along the path.";
    case Continuity::speed:
      return "The speed is continuous; the acceleration jumps where the curvature of the path does.";
    case Continuity::acceleration:
      break;
  }
  return "Velocity and acceleration are continuous everywhere.";
}

std::string turning_sentence(const Guarantees& g) {
  return fmt::format(
      "Where rotary axes turn{}, every axis of the machine stays within {} times its velocity.",
      g.turning_rapids_only ? " in rapids" : "", g.turning_velocity);
}

std::string stop_sentence(const Guarantees& g) {
  std::vector<std::string> places;
  if (g.stops_at_line_corners) {
    places.emplace_back("at corners of lines");
  }
  if (g.stops_at_arc_corners) {
    places.emplace_back("at corners that touch an arc");
  }
  if (g.stops_at_reversals) {
    places.emplace_back("at reversals");
  }
  if (g.stops_at_rapids) {
    places.emplace_back("before and after every rapid");
  }
  return places.empty() ? "Full stops at dwells only." : fmt::format("Full stops {}.", listed(places));
}

}  // namespace

KeptLimits all_kept() {
  return {{Of::whole, 1}, {Of::whole, 1}, {Of::whole, 1}, false};
}

KeptLimits static_arc_limits() {
  return {{Of::whole, 1}, {Of::parts, 1}, {Of::parts, 1}, false};
}

std::vector<std::string> sentences(const Guarantees& g) {
  std::vector<std::string> text;
  if (g.covered != Covered::both) {
    text.push_back(covered_sentence(g.covered));
  }
  text.push_back(contour_sentence(g));
  text.push_back(feed_sentence(g));
  text.push_back(place_sentence("On lines", g.lines));
  text.push_back(place_sentence("On arcs", g.arcs));
  if (g.contour > 0) {
    text.push_back(place_sentence("On corner blends", g.blends));
  }
  if (g.lays_curves) {
    text.push_back(place_sentence("On smooth curves", g.curves));
  }
  if (g.turning_velocity < Guarantees::unbounded) {
    text.push_back(turning_sentence(g));
  }
  text.push_back(continuity_sentence(g.continuity));
  if (g.continuity != Continuity::position) {
    text.emplace_back(g.follows_brisk
                          ? "Where the program asks for BRISK, no jerk along the path is bounded: its "
                            "acceleration changes within one interpolation period."
                          : "BRISK of the program is not followed.");
  }
  if (g.meets_tangent_ends) {
    text.emplace_back(
        "A junction that touches an arc and turns by up to 0.01 rad is passed as if it were tangent: there "
        "the "
        "velocity of an axis jumps by up to 1 % of the feed (1 mm/s at 6000 mm/min).");
  }
  text.push_back(stop_sentence(g));
  return text;
}

}  // namespace feedscope
