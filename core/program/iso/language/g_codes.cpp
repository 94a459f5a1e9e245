#include "core/program/iso/language/g_codes.h"

#include <array>

namespace feedscope::iso {

namespace {

using enum GAction;
using enum Severity;

constexpr Translatable positions_left_out = NC_("core", "positions are skipped up to the next G0 to G3");
constexpr Translatable motion_left_out = NC_("core", "its motion is skipped");
constexpr Translatable unshifted = NC_("core", "the path is shown without it");
constexpr Translatable stays_put = NC_("core", "nothing moves");
constexpr Translatable tip_shown = NC_("core", "the path shown is that of the tool tip");
constexpr Translatable no_effect = NC_("core", "it does not change the programmed path");

// Sorted by number.
constexpr auto g_codes = std::to_array<GCode>({
    {0, GGroup::motion, rapid, info, {}, {}},
    {10, GGroup::motion, line, info, {}, {}},
    {20, GGroup::motion, arc_cw, info, {}, {}},
    {30, GGroup::motion, arc_ccw, info, {}, {}},
    {40, GGroup::none, dwell, info, {}, {}},
    {50, GGroup::motion, spline, info, {}, {}, true},
    {51, GGroup::motion, spline, info, {}, {}, true},
    {52, GGroup::motion, spline, info, {}, {}},
    {53, GGroup::motion, spline, info, {}, {}},
    {61, GGroup::motion, unread_motion, error, NC_("core", "spline"), positions_left_out},
    {62, GGroup::motion, spline, info, {}, {}},
    {70, GGroup::none, report, error, NC_("core", "diameter programming or cylindrical interpolation"),
     unshifted},
    {71, GGroup::none, report, error, NC_("core", "cylindrical interpolation"), unshifted},
    {80, GGroup::none, path_control, info, {}, {}},
    {90, GGroup::none, path_control, info, {}, {}},
    {100, GGroup::none, axis_function, info, {}, {}},
    {110, GGroup::none, accept, info, {}, {}},
    {120, GGroup::none, own_words, error, NC_("core", "circular pocket"), motion_left_out},
    {121, GGroup::none, report, error, NC_("core", "polar coordinate interpolation"), unshifted},
    {130, GGroup::none, own_words, error, NC_("core", "circular pocket"), motion_left_out},
    {131, GGroup::none, accept, info, {}, {}},
    {150, GGroup::none, function, info, {}, {}},
    {160, GGroup::none, function, info, {}, {}},
    {170, GGroup::plane, plane_xy, info, {}, {}},
    {180, GGroup::plane, plane_zx, info, {}, {}},
    {190, GGroup::plane, plane_yz, info, {}, {}},
    {200, GGroup::units, inch, info, {}, {}},
    {210, GGroup::units, metric, info, {}, {}},
    {220, GGroup::none, accept, info, {}, {}},
    {230, GGroup::none, accept, info, {}, {}},
    {270, GGroup::none, own_words, warning, NC_("core", "reference point check"), stays_put},
    {280, GGroup::none, axis_function, info, {}, {}},
    {281, GGroup::none, function, info, {}, {}},
    {290, GGroup::none, axis_function, info, {}, {}},
    {300, GGroup::none, axis_function, info, {}, {}},
    {301, GGroup::none, function, info, {}, {}},
    {310, GGroup::none, own_words, error, NC_("core", "skip motion"), stays_put},
    {320, GGroup::motion, unread_motion, error, NC_("core", "thread cutting"), positions_left_out},
    {330, GGroup::motion, unread_motion, error, NC_("core", "thread cutting"), positions_left_out},
    {331, GGroup::motion, unread_motion, error, NC_("core", "rigid tapping"), positions_left_out},
    {382, GGroup::none, own_words, error, NC_("core", "probing"), stays_put},
    {383, GGroup::none, own_words, error, NC_("core", "probing"), stays_put},
    {384, GGroup::none, own_words, error, NC_("core", "probing"), stays_put},
    {385, GGroup::none, own_words, error, NC_("core", "probing"), stays_put},
    {400, GGroup::radius, function, info, {}, {}},
    {410, GGroup::radius, function, info, {}, {}},
    {411, GGroup::radius, function, info, {}, {}},
    {420, GGroup::radius, function, info, {}, {}},
    {421, GGroup::radius, function, info, {}, {}},
    {430, GGroup::tool_length, report, info, NC_("core", "tool length compensation"), tip_shown},
    {431, GGroup::tool_length, report, info, NC_("core", "tool length compensation"), tip_shown},
    {432, GGroup::tool_length, report, info, NC_("core", "tool length compensation"), tip_shown},
    {434, GGroup::tool_length, report, error, NC_("core", "tool centre point control"),
     NC_("core", "only X, Y and Z are shown")},
    {435, GGroup::tool_length, report, error, NC_("core", "tool centre point control"),
     NC_("core", "only X, Y and Z are shown")},
    {440, GGroup::tool_length, report, info, NC_("core", "tool length compensation"), tip_shown},
    {450, GGroup::none, report, error, NC_("core", "tool offset of one block"), unshifted},
    {460, GGroup::none, report, error, NC_("core", "tool offset of one block"), unshifted},
    {470, GGroup::none, own_words, error, NC_("core", "engraving, or double tool offset of one block"),
     motion_left_out},
    {480, GGroup::none, report, error, NC_("core", "tool offset of one block"), unshifted},
    {490, GGroup::tool_length, accept, info, {}, {}},
    {500, GGroup::none, function, info, {}, {}},
    {501, GGroup::none, axis_function, info, {}, {}},
    {510, GGroup::none, axis_function, info, {}, {}},
    {511, GGroup::none, axis_function, info, {}, {}},
    {520, GGroup::none, axis_function, info, {}, {}},
    {530, GGroup::none, axis_function, info, {}, {}},
    {531, GGroup::none, report, info, NC_("core", "turning of the tool axis"),
     NC_("core", "X, Y and Z are shown as programmed")},
    {540, GGroup::offset, function, info, {}, {}},
    {541, GGroup::offset, function, info, {}, {}},
    {550, GGroup::offset, function, info, {}, {}},
    {560, GGroup::offset, function, info, {}, {}},
    {570, GGroup::offset, function, info, {}, {}},
    {580, GGroup::offset, function, info, {}, {}},
    {590, GGroup::offset, function, info, {}, {}},
    {591, GGroup::offset, function, info, {}, {}},
    {592, GGroup::offset, function, info, {}, {}},
    {593, GGroup::offset, function, info, {}, {}},
    {600, GGroup::path_mode, accept, info, {}, {}},
    {610, GGroup::path_mode, path_control, info, {}, {}},
    {611, GGroup::path_mode, path_control, info, {}, {}},
    {620, GGroup::path_mode, path_control, info, {}, {}},
    {630, GGroup::path_mode, path_control, info, {}, {}},
    {640, GGroup::path_mode, path_control, info, {}, {}},
    {650, GGroup::none, own_words, error, NC_("core", "macro call"), motion_left_out},
    {660, GGroup::none, own_words, error, NC_("core", "modal macro call"), motion_left_out},
    {661, GGroup::none, own_words, error, NC_("core", "macro call in each block"), motion_left_out},
    {670, GGroup::none, cancel_macro, info, {}, {}},
    {680, GGroup::none, axis_function, info, {}, {}},
    {682, GGroup::none, axis_function, info, {}, {}},
    {683, GGroup::none, own_words, error, NC_("core", "tilted working plane"), unshifted},
    {684, GGroup::none, own_words, error, NC_("core", "tilted working plane"), unshifted},
    {690, GGroup::none, function, info, {}, {}},
    {700, GGroup::none, axis_function, info, {}, {}},
    {710, GGroup::none, axis_function, info, {}, {}},
    {720, GGroup::none, axis_function, info, {}, {}},
    {730, GGroup::motion, cycle, info, {}, {}},
    {740, GGroup::motion, cycle, info, {}, {}},
    {760, GGroup::motion, cycle, info, {}, {}},
    {770, GGroup::motion, unread_motion, error, NC_("core", "back boring"), positions_left_out},
    {800, GGroup::none, cancel_cycle, info, {}, {}},
    {810, GGroup::motion, cycle, info, {}, {}},
    {820, GGroup::motion, cycle, info, {}, {}},
    {830, GGroup::motion, cycle, info, {}, {}},
    {840, GGroup::motion, cycle, info, {}, {}},
    {842, GGroup::motion, cycle, info, {}, {}},
    {843, GGroup::motion, cycle, info, {}, {}},
    {850, GGroup::motion, cycle, info, {}, {}},
    {860, GGroup::motion, cycle, info, {}, {}},
    {870, GGroup::motion, cycle, info, {}, {}},
    {880, GGroup::motion, cycle, info, {}, {}},
    {890, GGroup::motion, cycle, info, {}, {}},
    {900, GGroup::distance, absolute, info, {}, {}},
    {901, GGroup::center_distance, absolute_centers, info, {}, {}},
    {910, GGroup::distance, incremental, info, {}, {}},
    {911, GGroup::center_distance, incremental_centers, info, {}, {}},
    {920, GGroup::none, axis_function, info, {}, {}, true},
    {921, GGroup::none, function, info, {}, {}},
    {922, GGroup::none, function, info, {}, {}},
    {923, GGroup::none, function, info, {}, {}},
    {930, GGroup::feed_mode, other_feed, info, {}, {}},
    {940, GGroup::feed_mode, feed_per_minute, info, {}, {}},
    {950, GGroup::feed_mode, other_feed, info, {}, {}},
    {960, GGroup::none, report, info, NC_("core", "constant cutting speed"), no_effect},
    {970, GGroup::none, accept, info, {}, {}},
    {980, GGroup::none, function, info, {}, {}},
    {990, GGroup::none, function, info, {}, {}},
    {1030, GGroup::none, accept, info, {}, {}},
    {1070, GGroup::none, report, error, NC_("core", "cylindrical mapping"), unshifted},
    {1360, GGroup::none, own_words, error, NC_("core", "probing"), stays_put},
    {1410, GGroup::none, report, error, NC_("core", "cutter compensation in space"), unshifted},
    {1430, GGroup::tool_length, report, error, NC_("core", "tool length compensation of five axes"),
     NC_("core", "only X, Y and Z are shown")},
    {1500, GGroup::none, own_words, error, NC_("core", "pocket milling"), motion_left_out},
    {1540, GGroup::offset, function, info, {}, {}},
    {1870, GGroup::none, path_control, info, {}, {}},
    {2340, GGroup::tool_length, report, error, NC_("core", "tool centre point control"),
     NC_("core", "only X, Y and Z are shown")},
    {2540, GGroup::none, report, error, NC_("core", "dynamic work offset"), unshifted},
    {2550, GGroup::none, accept, info, {}, {}},
    {2680, GGroup::none, own_words, error, NC_("core", "tilted working plane"), unshifted},
    {2690, GGroup::none, accept, info, {}, {}},
});

constexpr int number_limit = 2700;
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

}  // namespace feedscope::iso
