#include "core/program/iso/g_codes.h"

#include <array>

namespace feedscope {

namespace {

using enum GAction;
using enum Severity;

constexpr std::string_view positions_left_out = "positions are left out up to the next G0 to G3";
constexpr std::string_view contour_shown = "the path shown is the programmed contour";
constexpr std::string_view unshifted = "the path is shown without it";
constexpr std::string_view stays_put = "the path stays where it is";
constexpr std::string_view tip_shown = "the path shown is that of the tool tip";
constexpr std::string_view feed_unknown = "feed moves run as fast as the axes allow";
constexpr std::string_view no_effect = "it does not change the programmed path";

// Sorted by number.
constexpr auto g_codes = std::to_array<GCode>({
    {0, GGroup::motion, rapid, info, {}, {}},
    {10, GGroup::motion, line, info, {}, {}},
    {20, GGroup::motion, arc_cw, info, {}, {}},
    {30, GGroup::motion, arc_ccw, info, {}, {}},
    {40, GGroup::none, dwell, info, {}, {}},
    {50, GGroup::motion, unread_motion, error, "spline or high-speed mode", positions_left_out, true},
    {51, GGroup::motion, unread_motion, error, "spline or contour control", positions_left_out, true},
    {52, GGroup::motion, unread_motion, error, "spline", positions_left_out},
    {53, GGroup::motion, unread_motion, error, "spline end", positions_left_out},
    {61, GGroup::motion, unread_motion, error, "spline", positions_left_out},
    {62, GGroup::motion, unread_motion, error, "spline", positions_left_out},
    {70, GGroup::none, report, error, "diameter programming or cylindrical interpolation", unshifted},
    {71, GGroup::none, report, error, "cylindrical interpolation", unshifted},
    {80, GGroup::none, path_control, info, {}, {}},
    {90, GGroup::none, path_control, info, {}, {}},
    {100, GGroup::none, own_words, warning, "offset by program", unshifted},
    {110, GGroup::none, accept, info, {}, {}},
    {121, GGroup::none, report, error, "polar coordinate interpolation", unshifted},
    {131, GGroup::none, accept, info, {}, {}},
    {150, GGroup::none, accept, info, {}, {}},
    {160, GGroup::none, report, error, "polar coordinates", "coordinates are shown as X, Y and Z"},
    {170, GGroup::plane, plane_xy, info, {}, {}},
    {180, GGroup::plane, plane_zx, info, {}, {}},
    {190, GGroup::plane, plane_yz, info, {}, {}},
    {200, GGroup::units, inch, info, {}, {}},
    {210, GGroup::units, metric, info, {}, {}},
    {220, GGroup::none, accept, info, {}, {}},
    {230, GGroup::none, accept, info, {}, {}},
    {270, GGroup::none, own_words, warning, "reference point check", stays_put},
    {280, GGroup::none, own_words, warning, "reference point return", stays_put},
    {281, GGroup::none, accept, info, {}, {}},
    {290, GGroup::none, own_words, warning, "return from the reference point", stays_put},
    {300, GGroup::none, own_words, warning, "second reference point return", stays_put},
    {301, GGroup::none, accept, info, {}, {}},
    {310, GGroup::none, own_words, error, "skip motion", stays_put},
    {320, GGroup::motion, unread_motion, error, "thread cutting", positions_left_out},
    {330, GGroup::motion, unread_motion, error, "thread cutting", positions_left_out},
    {331, GGroup::motion, unread_motion, error, "rigid tapping", positions_left_out},
    {382, GGroup::none, own_words, error, "probing", stays_put},
    {383, GGroup::none, own_words, error, "probing", stays_put},
    {384, GGroup::none, own_words, error, "probing", stays_put},
    {385, GGroup::none, own_words, error, "probing", stays_put},
    {400, GGroup::radius, accept, info, {}, {}},
    {410, GGroup::radius, report, error, "cutter radius compensation", contour_shown},
    {411, GGroup::radius, report, error, "cutter radius compensation", contour_shown},
    {420, GGroup::radius, report, error, "cutter radius compensation", contour_shown},
    {421, GGroup::radius, report, error, "cutter radius compensation", contour_shown},
    {430, GGroup::tool_length, report, info, "tool length compensation", tip_shown},
    {431, GGroup::tool_length, report, info, "tool length compensation", tip_shown},
    {432, GGroup::tool_length, report, info, "tool length compensation", tip_shown},
    {434, GGroup::tool_length, report, error, "tool centre point control", "only X, Y and Z are shown"},
    {435, GGroup::tool_length, report, error, "tool centre point control", "only X, Y and Z are shown"},
    {440, GGroup::tool_length, report, info, "tool length compensation", tip_shown},
    {490, GGroup::tool_length, accept, info, {}, {}},
    {500, GGroup::none, accept, info, {}, {}},
    {501, GGroup::none, accept, info, {}, {}},
    {510, GGroup::none, own_words, error, "scaling", unshifted},
    {511, GGroup::none, own_words, error, "mirroring", unshifted},
    {520, GGroup::none, own_words, error, "local shift", unshifted},
    {530, GGroup::none, own_words, warning, "motion in machine coordinates", stays_put},
    {540, GGroup::offset, work_offset, info, {}, {}},
    {541, GGroup::offset, work_offset, info, {}, {}},
    {550, GGroup::offset, work_offset, info, {}, {}},
    {560, GGroup::offset, work_offset, info, {}, {}},
    {570, GGroup::offset, work_offset, info, {}, {}},
    {580, GGroup::offset, work_offset, info, {}, {}},
    {590, GGroup::offset, work_offset, info, {}, {}},
    {591, GGroup::offset, work_offset, info, {}, {}},
    {592, GGroup::offset, work_offset, info, {}, {}},
    {593, GGroup::offset, work_offset, info, {}, {}},
    {600, GGroup::path_mode, accept, info, {}, {}},
    {610, GGroup::path_mode, path_control, info, {}, {}},
    {611, GGroup::path_mode, path_control, info, {}, {}},
    {620, GGroup::path_mode, path_control, info, {}, {}},
    {630, GGroup::path_mode, path_control, info, {}, {}},
    {640, GGroup::path_mode, path_control, info, {}, {}},
    {650, GGroup::none, own_words, error, "macro call", "its motion is left out"},
    {660, GGroup::none, own_words, error, "modal macro call", "its motion is left out"},
    {670, GGroup::none, cancel_macro, info, {}, {}},
    {680, GGroup::none, own_words, error, "coordinate rotation", unshifted},
    {682, GGroup::none, own_words, error, "tilted working plane", unshifted},
    {690, GGroup::none, accept, info, {}, {}},
    {730, GGroup::motion, unread_motion, error, "drilling cycle", positions_left_out},
    {740, GGroup::motion, unread_motion, error, "tapping cycle", positions_left_out},
    {760, GGroup::motion, unread_motion, error, "boring or threading cycle", positions_left_out},
    {800, GGroup::none, cancel_cycle, info, {}, {}},
    {810, GGroup::motion, unread_motion, error, "drilling cycle", positions_left_out},
    {820, GGroup::motion, unread_motion, error, "drilling cycle", positions_left_out},
    {830, GGroup::motion, unread_motion, error, "deep hole drilling cycle", positions_left_out},
    {840, GGroup::motion, unread_motion, error, "tapping cycle", positions_left_out},
    {850, GGroup::motion, unread_motion, error, "boring cycle", positions_left_out},
    {860, GGroup::motion, unread_motion, error, "boring cycle", positions_left_out},
    {870, GGroup::motion, unread_motion, error, "boring cycle", positions_left_out},
    {880, GGroup::motion, unread_motion, error, "boring cycle", positions_left_out},
    {890, GGroup::motion, unread_motion, error, "boring cycle", positions_left_out},
    {900, GGroup::distance, absolute, info, {}, {}},
    {901, GGroup::center_distance, absolute_centers, info, {}, {}},
    {910, GGroup::distance, incremental, info, {}, {}},
    {911, GGroup::center_distance, incremental_centers, info, {}, {}},
    {920, GGroup::none, own_words, error, "coordinate shift", unshifted, true},
    {921, GGroup::none, own_words, warning, "end of the coordinate shift", unshifted, true},
    {922, GGroup::none, own_words, warning, "end of the coordinate shift", unshifted, true},
    {923, GGroup::none, own_words, error, "coordinate shift", unshifted, true},
    {930, GGroup::feed_mode, other_feed, error, "inverse time feed", feed_unknown},
    {940, GGroup::feed_mode, feed_per_minute, info, {}, {}},
    {950, GGroup::feed_mode, other_feed, error, "feed per revolution", feed_unknown},
    {960, GGroup::none, report, info, "constant cutting speed", no_effect},
    {970, GGroup::none, accept, info, {}, {}},
    {980, GGroup::none, accept, info, {}, {}},
    {990, GGroup::none, accept, info, {}, {}},
    {1870, GGroup::none, path_control, info, {}, {}},
});

constexpr int number_limit = 2000;
constexpr std::uint8_t absent = 255;
static_assert(g_codes.size() < absent && g_codes.back().number < number_limit);

constexpr auto index_of_number = [] {
  std::array<std::uint8_t, number_limit> index{};
  index.fill(absent);
  for (std::size_t i = 0; i < g_codes.size(); ++i) {
    index[static_cast<std::size_t>(g_codes[i].number)] = static_cast<std::uint8_t>(i);
  }
  return index;
}();

}  // namespace

const GCode* find_g_code(int number) {
  if (number < 0 || number >= number_limit) {
    return nullptr;
  }
  const std::uint8_t i = index_of_number[static_cast<std::size_t>(number)];
  return i == absent ? nullptr : &g_codes[i];
}

}  // namespace feedscope
