#include "core/program/sinumerik/language/functions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_map>

#include "core/program/sinumerik/language/names.h"

namespace feedscope::sinumerik {

namespace {

constexpr auto error = Severity::error;
constexpr auto warning = Severity::warning;
constexpr auto info = Severity::info;
using enum Action;

constexpr Translatable not_moved = NC_("core", "positions are skipped up to the next motion word");
constexpr Translatable path_as_programmed = NC_("core", "X, Y and Z are shown as programmed");
constexpr Translatable contour_shown = NC_("core", "the path shown is the programmed contour");
constexpr Translatable own_limits = NC_("core", "the limits of the machine file are used");
constexpr Translatable straight_approach =
    NC_("core", "compensation begins and ends on a straight line, as with NORM");
constexpr Translatable compensation_in_space = NC_("core", "3D cutter compensation");
constexpr Translatable in_plane = NC_("core", "the cutter is compensated in the plane");

constexpr auto functions = std::to_array<Function>({
    {"G0", Group::motion, rapid},
    {"G1", Group::motion, line},
    {"G2", Group::motion, arc_cw},
    {"G3", Group::motion, arc_ccw},
    {"CIP", Group::motion, arc_through},
    {"CT", Group::motion, arc_tangent},
    {"ASPLINE", Group::motion, spline},
    {"BSPLINE", Group::motion, spline},
    {"CSPLINE", Group::motion, spline},
    {"POLY", Group::motion, polynomial},
    {"G33", Group::motion, thread},
    {"G331", Group::motion, thread},
    {"G332", Group::motion, thread},
    {"G34", Group::motion, unread_motion, error, NC_("core", "thread with increasing lead"), not_moved},
    {"G35", Group::motion, unread_motion, error, NC_("core", "thread with decreasing lead"), not_moved},
    {"INVCW", Group::motion, unread_motion, error, NC_("core", "involute"), not_moved},
    {"INVCCW", Group::motion, unread_motion, error, NC_("core", "involute"), not_moved},
    {"G63", Group::none, report, info, NC_("core", "tapping with compensating chuck"),
     NC_("core", "a line at the programmed feed")},
    {"G4", Group::own_block, dwell},
    {"G17", Group::plane, plane_xy},
    {"G18", Group::plane, plane_zx},
    {"G19", Group::plane, plane_yz},
    {"G70", Group::units, inch},
    {"G71", Group::units, metric},
    {"G700", Group::units, inch_all},
    {"G710", Group::units, metric_all},
    {"G90", Group::distance, absolute},
    {"G91", Group::distance, incremental},
    {"G93", Group::feed_mode, feed_inverse_time},
    {"G94", Group::feed_mode, feed_per_minute},
    {"G95", Group::feed_mode, feed_per_revolution},
    {"G97", Group::feed_mode, feed_per_revolution},
    {"G971", Group::feed_mode, feed_per_minute},
    {"G972", Group::none, accept},
    {"G973", Group::feed_mode, feed_per_revolution},
    {"G96", Group::feed_mode, feed_per_revolution, warning, NC_("core", "constant cutting speed"),
     NC_("core", "the last spindle speed is used")},
    {"G961", Group::feed_mode, feed_per_minute},
    {"G962", Group::none, accept},
    {"G53", Group::none, machine_axes},
    {"G153", Group::none, machine_axes},
    {"SUPA", Group::none, machine_axes},
    {"G74", Group::own_block, machine_axes},
    {"G75", Group::own_block, machine_axes},
    {"G751", Group::own_block, machine_axes},
    {"TRANS", Group::own_block, shift},
    {"ATRANS", Group::own_block, shift_more},
    {"ROT", Group::own_block, turn},
    {"AROT", Group::own_block, turn_more},
    {"SCALE", Group::own_block, scale},
    {"ASCALE", Group::own_block, scale_more},
    {"MIRROR", Group::own_block, mirror},
    {"AMIRROR", Group::own_block, mirror_more},
    {"G58", Group::own_block, coarse_shift},
    {"G59", Group::own_block, fine_shift},
    {"G110", Group::own_block, pole_from_position},
    {"G111", Group::own_block, pole_from_zero},
    {"G112", Group::own_block, pole_from_pole},
    {"ROTS", Group::own_block, own_words, error, NC_("core", "rotation by solid angles"),
     NC_("core", "the path is shown without it")},
    {"AROTS", Group::own_block, own_words, error, NC_("core", "rotation by solid angles"),
     NC_("core", "the path is shown without it")},
    {"CROTS", Group::own_block, own_words, error, NC_("core", "rotation by solid angles"),
     NC_("core", "the path is shown without it")},
    {"G25", Group::own_block, own_words},
    {"G26", Group::own_block, own_words},
    {"G9", Group::none, exact_stop_once},
    {"G60", Group::path_mode, path_control},
    {"G64", Group::path_mode, path_control},
    {"G641", Group::path_mode, path_control},
    {"G642", Group::path_mode, path_control},
    {"G643", Group::path_mode, path_control},
    {"G644", Group::path_mode, path_control},
    {"G645", Group::path_mode, path_control},
    {"G601", Group::exact_stop_window, path_control},
    {"G602", Group::exact_stop_window, path_control},
    {"G603", Group::exact_stop_window, path_control},
    {"COMPON", Group::compaction, path_control},
    {"COMPCURV", Group::compaction, path_control},
    {"COMPCAD", Group::compaction, path_control},
    {"COMPSURF", Group::compaction, path_control},
    {"COMPPATH", Group::compaction, path_control},
    {"COMPOF", Group::compaction, path_control},
    {"SOFT", Group::acceleration, path_control},
    {"BRISK", Group::acceleration, path_control},
    {"DRIVE", Group::acceleration, path_control},
    {"FFWON", Group::feed_forward, path_control},
    {"FFWOF", Group::feed_forward, path_control},
    {"BAUTO", Group::none, spline_end},
    {"BNAT", Group::none, spline_end},
    {"BTAN", Group::none, spline_end},
    {"EAUTO", Group::none, spline_end},
    {"ENAT", Group::none, spline_end},
    {"ETAN", Group::none, spline_end},
    {"G40", Group::compensation, compensation_off},
    {"G41", Group::compensation, compensation_left},
    {"G42", Group::compensation, compensation_right},
    {"G450", Group::corner, corner_arc},
    {"G451", Group::corner, corner_meeting},
    {"G147", Group::none, report, error, NC_("core", "soft approach"), path_as_programmed},
    {"G148", Group::none, report, error, NC_("core", "soft retraction"), path_as_programmed},
    {"G247", Group::none, report, error, NC_("core", "soft approach"), path_as_programmed},
    {"G248", Group::none, report, error, NC_("core", "soft retraction"), path_as_programmed},
    {"G347", Group::none, report, error, NC_("core", "soft approach"), path_as_programmed},
    {"G348", Group::none, report, error, NC_("core", "soft retraction"), path_as_programmed},
    {"G5", Group::none, report, error, NC_("core", "oblique plunge grinding"), path_as_programmed},
    {"G7", Group::none, report, error, NC_("core", "oblique plunge grinding"), path_as_programmed},
    {"G291", Group::none, report, error, NC_("core", "ISO dialect"),
     NC_("core", "the following blocks are interpreted as Siemens code")},
    {"DIAMON", Group::diameter, diameters},
    {"DIAM90", Group::diameter, diameters_if_absolute},
    {"DIAMOF", Group::diameter, radii},
    {"TRAORI", Group::none, report, info, NC_("core", "tool orientation"),
     NC_("core", "the path shown is that of the tool tip")},
    {"TRACYL", Group::none, report, error, NC_("core", "cylinder surface transformation"),
     path_as_programmed},
    {"TRANSMIT", Group::none, report, error, NC_("core", "face end transformation"), path_as_programmed},
    {"TRAANG", Group::none, report, error, NC_("core", "inclined axis"), path_as_programmed},
    {"TRACON", Group::none, report, error, NC_("core", "chained transformation"), path_as_programmed},
    {"TOFRAME", Group::none, report, error, NC_("core", "frame in tool direction"), path_as_programmed},
    {"TOFRAMEX", Group::none, report, error, NC_("core", "frame in tool direction"), path_as_programmed},
    {"TOFRAMEY", Group::none, report, error, NC_("core", "frame in tool direction"), path_as_programmed},
    {"TOFRAMEZ", Group::none, report, error, NC_("core", "frame in tool direction"), path_as_programmed},
    {"TOROT", Group::none, report, error, NC_("core", "rotation in tool direction"), path_as_programmed},
    {"PAROT", Group::none, report, error, NC_("core", "alignment with the workpiece"), path_as_programmed},
    {"FPO", Group::none, report, info, NC_("core", "feed by a polynomial"),
     NC_("core", "the feed does not change")},
    {"MEAS", Group::none, report, warning, NC_("core", "measuring"),
     NC_("core", "the probe is assumed never to touch")},
    {"MEAW", Group::none, report, warning, NC_("core", "measuring"),
     NC_("core", "the probe is assumed never to touch")},
    {"TRAILON", Group::none, report, warning, NC_("core", "coupled axes"), path_as_programmed},
    {"TANG", Group::none, report, warning, NC_("core", "tangential control"), path_as_programmed},
    {"OSCILL", Group::none, report, warning, NC_("core", "oscillating axes"), path_as_programmed},
    {"POSP", Group::none, report, error, NC_("core", "positioning axis"),
     NC_("core", "its motion is skipped")},
    {"PRESETON", Group::none, report, error, NC_("core", "setting of actual values"), path_as_programmed},
    {"GEOAX", Group::none, report, error, NC_("core", "change of geometry axes"), path_as_programmed},
    {"PTP", Group::none, report, warning, NC_("core", "point-to-point motion"), path_as_programmed},
    {"OFFN", Group::none, report, error, NC_("core", "contour offset"), contour_shown},
    {"FZ", Group::none, report, error, NC_("core", "feed per tooth"),
     NC_("core", "the last feed is used; write F")},
    {"OVR", Group::none, report, error, NC_("core", "feed override"), NC_("core", "the feed of F is used")},
    {"OVRRAP", Group::none, report, warning, NC_("core", "override of rapids"),
     NC_("core", "rapids of the machine are used")},
    {"DYNNORM", Group::none, report, info, NC_("core", "set of dynamic limits"), own_limits},
    {"DYNPOS", Group::none, report, info, NC_("core", "set of dynamic limits"), own_limits},
    {"DYNROUGH", Group::none, report, info, NC_("core", "set of dynamic limits"), own_limits},
    {"DYNSEMIFIN", Group::none, report, info, NC_("core", "set of dynamic limits"), own_limits},
    {"DYNFINISH", Group::none, report, info, NC_("core", "set of dynamic limits"), own_limits},
    {"DYNPREC", Group::none, report, info, NC_("core", "set of dynamic limits"), own_limits},
    {"ACC", Group::none, report, warning, NC_("core", "acceleration of an axis"), own_limits},
    {"ACCLIMA", Group::none, report, warning, NC_("core", "acceleration of an axis"), own_limits},
    {"VELOLIM", Group::none, report, warning, NC_("core", "speed of an axis"), own_limits},
    {"VELOLIMA", Group::none, report, warning, NC_("core", "speed of an axis"), own_limits},
    {"JERKLIM", Group::none, report, warning, NC_("core", "jerk of an axis"), own_limits},
    {"JERKLIMA", Group::none, report, warning, NC_("core", "jerk of an axis"), own_limits},
    {"FL", Group::none, report, warning, NC_("core", "speed of an axis"), own_limits},
    {"KONT", Group::none, report, warning, NC_("core", "approach around the corner"), straight_approach},
    {"KONTC", Group::none, report, warning, NC_("core", "approach on a curve"), straight_approach},
    {"KONTT", Group::none, report, warning, NC_("core", "approach on a curve"), straight_approach},
    {"DISC", Group::none, report, warning, NC_("core", "overshoot at outside corners"),
     NC_("core", "they are rounded by a circle")},
    {"CUT3DC", Group::none, report, warning, compensation_in_space, in_plane},
    {"CUT3DCC", Group::none, report, warning, compensation_in_space, in_plane},
    {"CUT3DCCD", Group::none, report, warning, compensation_in_space, in_plane},
    {"CUT3DF", Group::none, report, warning, compensation_in_space, in_plane},
    {"CUT3DFS", Group::none, report, warning, compensation_in_space, in_plane},
    {"CUT3DFF", Group::none, report, warning, compensation_in_space, in_plane},
    {"TOFFR", Group::none, report, error, NC_("core", "tool radius offset"),
     NC_("core", "the radius does not change")},
    {"EXECSTRING", Group::none, report, error, NC_("core", "block made of strings"),
     NC_("core", "the block is skipped")},
    {"EXECTAB", Group::none, report, error, NC_("core", "execution of a contour table"),
     NC_("core", "its motion is skipped")},
    {"REPOSL", Group::none, report, error, NC_("core", "return to the contour"),
     NC_("core", "its motion is skipped")},
    {"REPOSA", Group::none, report, error, NC_("core", "return to the contour"),
     NC_("core", "its motion is skipped")},
    {"PRESETONS", Group::none, report, error, NC_("core", "setting of actual values"), path_as_programmed},
    {"TRAFOON", Group::none, report, error, NC_("core", "transformation"), path_as_programmed},
});

/// Names and G words that leave the path unchanged.
constexpr auto accepted = std::to_array<std::string_view>(
    {"FNORM",     "FLIN",     "FCUB",         "FIFOCTRL",  "CFC",       "CFTCP",     "CFIN",
     "NORM",      "CDON",     "CDOF",         "CDOF2",     "STOPRE",    "STARTFIFO", "STOPFIFO",
     "WAITM",     "WAITMC",   "WAITE",        "WAITP",     "WAITS",     "INIT",      "START",
     "SETM",      "CLEARM",   "SETMS",        "MSG",       "WORKPIECE", "TRAFOOF",   "ORIWKS",
     "ORIMKS",    "ORIAXES",  "ORIVECT",      "ORIEULER",  "ORIRPY",    "ORIRPY2",   "ORIPLANE",
     "ORICURVE",  "ORIVIRT1", "ORIVIRT2",     "ORISON",    "ORISOF",    "ORIC",      "ORID",
     "ORIRESET",  "OSOF",     "OSC",          "OSD",       "OSS",       "OSSE",      "OST",
     "SPOS",      "SPOSA",    "LIMS",         "SVC",       "SCC",       "DISPLON",   "DISPLOF",
     "SBLON",     "SBLOF",    "SAVE",         "ACTBLOCNO", "ICYCON",    "ICYCOF",    "GROUP_BEGIN",
     "GROUP_END", "FGROUP",   "FGREF",        "RTLION",    "RTLIOF",    "WALIMON",   "WALIMOF",
     "WALCS0",    "SPCON",    "SPCOF",        "PAROTOF",   "TOROTOF",   "TCARR",     "TCOABS",
     "TCOFR",     "TCOFRX",   "TCOFRY",       "TCOFRZ",    "CUT2D",     "CUT2DF",    "CUTCONON",
     "CUTCONOF",  "SETAL",    "STOLF",        "CTOLG0",    "OTOLG0",    "ATOL",      "UPATH",
     "SPATH",     "BLSYNC",   "SETINT",       "ENABLE",    "DISABLE",   "CLRINT",    "OVRA",
     "SOFTA",     "BRISKA",   "DRIVEA",       "FENDNORM",  "DISR",      "DISCL",     "FAD",
     "PM",        "PR",       "GETSELT",      "GETEXET",   "TLIFT",     "TANGOF",    "TRAILOF",
     "TCI",       "FTOCON",   "FTOCOF",       "SETPIECE",  "DELT",      "NEWCONF",   "FXS",
     "FXST",      "FXSW",     "DRFOF",        "CORROF",    "STAT",      "TU",        "PUNCHACC",
     "SPOF",      "CP",       "LFOF",         "LFON",      "POLFMASK",  "LFTXT",     "LFWP",
     "LFPOS",     "G460",     "G461",         "G462",      "G62",       "G621",      "G140",
     "G141",      "G142",     "G143",         "G340",      "G341",      "G290",      "STOPREOF",
     "SYNFCT",    "CANCEL",   "RELEASE",      "GET",       "GETD",      "SOFTENDSA", "SONC",
     "SPN",       "PON",      "PONC",         "PDELAYON",  "PDELAYOF",  "CUT2DD",    "CUT2DFD",
     "TOFF",      "TOFFL",    "GROUP_ADDEND", "COUPDEF",   "COUPON",    "COUPONC",   "COUPOF",
     "COUPDEL",   "COUPRES",  "ORIPATH",      "ORIPATHS",  "ORICONCW",  "ORICONCCW", "ORICONIO",
     "ORICONTO",  "ORIROTA",  "ORIROTR",      "ORIROTT",   "ORIROTC",   "ORIAXPOS",  "PROTA",
     "PROTS",     "PROTD",    "WRITE",        "DELETE",    "CALLPATH"});

using Table = std::unordered_map<std::string_view, Function>;

Table make_table() {
  Table table;
  for (const std::string_view name : accepted) {
    table.try_emplace(name, Function{name});
  }
  for (const Function& function : functions) {
    table.insert_or_assign(function.name, function);
  }
  return table;
}

const Table& table() {
  static const Table all = make_table();
  return all;
}

constexpr int greatest_g = 999;

std::array<const Function*, greatest_g + 1> make_numbers() {
  static const Function offset{"G54", Group::offset, work_offset};
  static const Function oem{
      "G810", Group::none, report, warning, NC_("core", "machine builder function"), path_as_programmed};
  std::array<const Function*, greatest_g + 1> numbers{};
  for (const auto& [name, function] : table()) {
    int number = 0;
    const char* const end = name.data() + name.size();
    if (name.front() == 'G' && std::from_chars(name.data() + 1, end, number).ptr == end) {
      numbers[static_cast<std::size_t>(number)] = &function;
    }
  }
  const auto fill = [&](std::size_t from, std::size_t to, const Function& function) {
    std::fill(numbers.begin() + static_cast<std::ptrdiff_t>(from),
              numbers.begin() + static_cast<std::ptrdiff_t>(to) + 1, &function);
  };
  fill(54, 57, offset);
  fill(500, 599, offset);
  fill(810, 829, oem);
  return numbers;
}

}  // namespace

const Function* find_function(std::string_view name) {
  const std::string upper = upper_case(name);
  const auto found = table().find(upper);
  return found == table().end() ? nullptr : &found->second;
}

const Function* find_g(int number) {
  static const auto numbers = make_numbers();
  return number < 0 || number > greatest_g ? nullptr : numbers[static_cast<std::size_t>(number)];
}

}  // namespace feedscope::sinumerik
