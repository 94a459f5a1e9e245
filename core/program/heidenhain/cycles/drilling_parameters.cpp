// Parameters of the drilling cycles by their Q numbers.
#include <array>

#include "core/program/heidenhain/cycles/drilling_cycles.h"

namespace feedscope::heidenhain {

namespace {

using D = DrillingParameters;
using P = CycleParameter;
constexpr CycleUnit length = CycleUnit::length;
constexpr CycleUnit feed = CycleUnit::feed;
constexpr CycleUnit plain = CycleUnit::plain;

constexpr P clearance{200, &D::clearance, length, {}};
constexpr P depth{201, &D::depth, length, {}};
constexpr P infeed{202, &D::infeed, length, {}};
constexpr P surface{203, &D::surface, length, {}};
constexpr P second_clearance{204, &D::second_clearance, length, {}};
constexpr P plunge_feed{206, &D::feed, feed, {}};
constexpr P bottom_dwell{211, &D::bottom_dwell, plain, 0};
constexpr P retract_feed{208, &D::retract_feed, feed, 0};
constexpr P top_dwell{210, &D::top_dwell, plain, 0};
constexpr P decrement{212, &D::decrement, length, 0};
constexpr P min_infeed{205, &D::min_infeed, length, 0};
constexpr P break_distance{256, &D::break_distance, length, 0.2};
constexpr P break_infeed{257, &D::break_infeed, length, 0};
constexpr P pitch{239, &D::pitch, length, {}};

constexpr P to_shoulder{395, &D::to_shoulder, plain, 0};
constexpr P start_depth{379, &D::start_depth, length, 0};
constexpr P start_feed{253, &D::start_feed, feed, 0};

constexpr std::array drilling{clearance,        depth,        plunge_feed, infeed, top_dwell, surface,
                              second_clearance, bottom_dwell, to_shoulder};
constexpr std::array reaming{clearance,    depth,   plunge_feed,     bottom_dwell,
                             retract_feed, surface, second_clearance};
constexpr std::array boring{clearance,    depth,   plunge_feed,      bottom_dwell,
                            retract_feed, surface, second_clearance, P{214, &D::retreat, plain, 0}};
constexpr std::array universal_drilling{clearance,        depth,        plunge_feed,
                                        infeed,           top_dwell,    surface,
                                        second_clearance, decrement,    P{213, &D::breaks, plain, 0},
                                        min_infeed,       bottom_dwell, retract_feed,
                                        break_distance,   to_shoulder};
constexpr std::array pecking{clearance,
                             depth,
                             plunge_feed,
                             infeed,
                             surface,
                             second_clearance,
                             decrement,
                             min_infeed,
                             P{258, &D::upper_stop, length, 0.2},
                             P{259, &D::lower_stop, length, 0.2},
                             break_infeed,
                             break_distance,
                             bottom_dwell,
                             start_depth,
                             start_feed,
                             retract_feed,
                             to_shoulder};
constexpr std::array deep_drilling{clearance,
                                   depth,
                                   plunge_feed,
                                   bottom_dwell,
                                   surface,
                                   second_clearance,
                                   start_depth,
                                   start_feed,
                                   retract_feed,
                                   P{202, &D::infeed, length, 0},
                                   P{401, &D::feed_factor, plain, 100},
                                   P{435, &D::dwell_depth, length, 0},
                                   to_shoulder};
constexpr std::array tapping{clearance, depth, plunge_feed, bottom_dwell, surface, second_clearance};
constexpr std::array rigid_tapping{clearance, depth, pitch, surface, second_clearance};
constexpr std::array bore_milling{clearance,
                                  depth,
                                  plunge_feed,
                                  P{334, &D::helix_infeed, length, {}},
                                  surface,
                                  second_clearance,
                                  P{335, &D::diameter, length, {}},
                                  P{351, &D::climb, plain, 1}};
constexpr std::array back_boring{clearance,
                                 P{249, &D::counterbore, length, {}},
                                 P{250, &D::thickness, length, {}},
                                 P{251, &D::off_center, length, {}},
                                 P{252, &D::edge_height, length, {}},
                                 P{253, &D::start_feed, feed, {}},
                                 P{254, &D::counterbore_feed, feed, {}},
                                 P{255, &D::counterbore_dwell, plain, 0},
                                 surface,
                                 second_clearance,
                                 P{214, &D::retreat, plain, {}}};
constexpr std::array breaking_tapping{
    clearance,        depth,        pitch,          surface,
    second_clearance, break_infeed, break_distance, P{403, &D::retract_factor, plain, 1}};
constexpr std::array centering{
    clearance,       P{343, &D::by_diameter, plain, 0}, depth, plunge_feed, bottom_dwell, surface,
    second_clearance};

}  // namespace

std::span<const CycleParameter> parameters_of_drilling(int number) {
  switch (number) {
    case 200:
      return drilling;
    case 201:
      return reaming;
    case 202:
      return boring;
    case 203:
      return universal_drilling;
    case 204:
      return back_boring;
    case 205:
      return pecking;
    case 206:
      return tapping;
    case 207:
      return rigid_tapping;
    case 208:
      return bore_milling;
    case 209:
      return breaking_tapping;
    case 240:
      return centering;
    case 241:
      return deep_drilling;
    default:
      return {};
  }
}

}  // namespace feedscope::heidenhain
