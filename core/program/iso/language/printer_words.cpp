#include "core/program/iso/language/printer_words.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/program/text/scanner.h"

namespace feedscope::iso {

namespace {

struct Range {
  int first = 0;
  int last = 0;
};

/// M words of printers and plotters, none of which grbl has: motors off, extruder, fan, temperatures, texts,
/// limits and offsets of the firmware, servo, beep, waiting, levelling, memory, filament.
constexpr auto printer_codes = std::to_array<Range>({{17, 18},
                                                     {82, 84},
                                                     {104, 109},
                                                     {117, 118},
                                                     {140, 141},
                                                     {190, 191},
                                                     {200, 209},
                                                     {220, 221},
                                                     {280, 281},
                                                     {300, 304},
                                                     {400, 400},
                                                     {420, 420},
                                                     {500, 504},
                                                     {600, 600},
                                                     {900, 900},
                                                     {906, 907}});

bool is_printer_code(double code) {
  return std::any_of(printer_codes.begin(), printer_codes.end(),
                     [code](const Range& range) { return code >= range.first && code <= range.last; });
}

bool has_printer_word(std::string_view line) {
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char letter = letters::to_upper(line[at]);
    if (letter == ';' || letter == '(') {
      return false;
    }
    const bool begins = at == 0 || !letters::is_letter(line[at - 1]);
    if (!begins || (letter != 'M' && letter != 'E')) {
      continue;
    }
    Scanner scan(line, at + 1);
    scan.take('-');
    const std::size_t digits = scan.at();
    scan.skip_digits();
    const bool has_number = scan.at() > digits || scan.peek() == '.';
    if (letter == 'E' && has_number) {
      return true;
    }
    Scanner number(line, at + 1);
    constexpr std::size_t longest = 4;
    if (letter == 'M' && has_number && scan.at() - digits <= longest &&
        is_printer_code(number.number().value_or(0))) {
      return true;
    }
  }
  return false;
}

/// Beginnings of the names of Klipper's commands and of macros that slicers write.
constexpr auto klipper_names = std::to_array<std::string_view>({"SET_VELOCITY_LIMIT",
                                                                "SET_PRESSURE_ADVANCE",
                                                                "SET_GCODE_",
                                                                "SET_RETRACTION",
                                                                "SET_FAN_SPEED",
                                                                "SET_HEATER_TEMPERATURE",
                                                                "SET_PRINT_STATS_INFO",
                                                                "SET_INPUT_SHAPER",
                                                                "TEMPERATURE_WAIT",
                                                                "SAVE_GCODE_STATE",
                                                                "RESTORE_GCODE_STATE",
                                                                "EXCLUDE_OBJECT",
                                                                "BED_MESH_",
                                                                "QUAD_GANTRY_LEVEL",
                                                                "Z_TILT_ADJUST",
                                                                "TIMELAPSE_TAKE_FRAME",
                                                                "START_PRINT",
                                                                "PRINT_START",
                                                                "END_PRINT",
                                                                "PRINT_END"});

}  // namespace

std::string_view klipper_command(std::string_view line) {
  Scanner scan(line);
  scan.peek();
  const std::string_view name = scan.name();
  const bool known = std::ranges::any_of(klipper_names, [&](std::string_view begin) {
    return name.size() >= begin.size() && letters::same(name.substr(0, begin.size()), begin);
  });
  return known ? name : std::string_view();
}

bool is_for_printer(const SourceText& text) {
  for (std::uint32_t line = 1; line <= text.line_count(); ++line) {
    if (has_printer_word(text.line(line)) || !klipper_command(text.line(line)).empty()) {
      return true;
    }
  }
  return false;
}

}  // namespace feedscope::iso
