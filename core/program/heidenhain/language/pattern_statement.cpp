#include "core/program/heidenhain/language/pattern_statement.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/units.h"
#include "core/program/cycles/hole_patterns.h"
#include "core/program/path/plane_points.h"
#include "core/program/text/message.h"
#include "core/program/text/read_fault.h"

namespace feedscope::heidenhain {

namespace {

struct PatternWord {
  std::string_view name;
  double PatternWords::*value = nullptr;
  bool is_length = false;
};

/// Longer names come before their own beginnings.
constexpr auto pattern_words = std::to_array<PatternWord>({
    {"NUMX", &PatternWords::columns, false},
    {"NUMY", &PatternWords::rows, false},
    {"NUM", &PatternWords::count, false},
    {"ROTX", &PatternWords::first_turn, false},
    {"ROTY", &PatternWords::second_turn, false},
    {"ROT", &PatternWords::turn, false},
    {"START", &PatternWords::start, false},
    {"STEP", &PatternWords::step, false},
    {"DX", &PatternWords::column_spacing, true},
    {"DY", &PatternWords::row_spacing, true},
    {"D", &PatternWords::spacing, true},
    {"X", &PatternWords::x, true},
    {"Y", &PatternWords::y, true},
    {"Z", &PatternWords::z, true},
});

int checked_count(double count, std::uint32_t column) {
  constexpr double most = 10000;
  if (!(count >= 1 && count <= most)) {
    throw ReadFault{"pattern", column,
                    message(NC_("core", "{} is not a number of places from 1 to {}"), count, most),
                    NC_("core", "the pattern is skipped; check NUM, NUMX and NUMY")};
  }
  return static_cast<int>(count);
}

std::vector<Vec2> places_in_plane(std::string_view kind, const PatternWords& words, const Vec2& at,
                                  std::uint32_t column) {
  if (letters::same(kind, "POS")) {
    return {at};
  }
  if (letters::same(kind, "CIRC") || letters::same(kind, "PITCHCIRC")) {
    const int count = checked_count(words.count, column);
    const bool by_step = letters::same(kind, "PITCHCIRC") && words.step != 0;
    return places_of(CirclePattern{.center = at,
                                   .diameter = words.spacing,
                                   .start = units::from_deg(words.start),
                                   .step = by_step ? units::from_deg(words.step) : 2 * units::pi / count,
                                   .count = count});
  }
  if (letters::same(kind, "ROW")) {
    return places_of(RowPattern{.start = at,
                                .spacing = words.spacing,
                                .angle = units::from_deg(words.turn),
                                .count = checked_count(words.count, column)});
  }
  GridPattern grid;
  grid.start = at;
  grid.angle = units::from_deg(words.turn);
  grid.column_spacing = words.column_spacing;
  grid.row_spacing = words.row_spacing;
  grid.columns = checked_count(words.columns, column);
  grid.rows = checked_count(words.rows, column);
  grid.first_angle = units::from_deg(words.first_turn);
  grid.second_angle = units::from_deg(words.second_turn);
  grid.frame_only = letters::same(kind, "FRAME");
  checked_count(words.columns * words.rows, column);
  return places_of(grid);
}

}  // namespace

void PatternStatement::run(Scanner& scanner, std::uint32_t column) {
  constexpr std::array<std::string_view, 6> kinds{"POS", "ROW", "PAT", "FRAME", "CIRC", "PITCHCIRC"};
  if (!scanner.take_keyword("DEF")) {
    throw_unread_words(scanner, Message::as_written("PATTERN DEF"));
  }
  std::vector<Vec3> places;
  while (!scanner.at_end()) {
    const std::uint32_t at = scanner.column();
    std::string_view kind = scanner.name();
    kind = kind.substr(0, kind.find_last_not_of("0123456789") + 1);
    const bool known = std::any_of(kinds.begin(), kinds.end(),
                                   [kind](std::string_view name) { return letters::same(name, kind); });
    if (!known || !scanner.take('(')) {
      throw ReadFault{"pattern", at,
                      message(NC_("core", "{} is not a pattern"), in_quotes(scanner.text().substr(at - 1))),
                      NC_("core", "the pattern is skipped; write POS, ROW, PAT, FRAME, CIRC or PITCHCIRC")};
    }
    const PatternWords words = read_words(scanner);
    const Vec3 origin(words.x, words.y, words.z);
    for (const Vec2& place : places_in_plane(kind, words, in_plane(origin, plane()), at)) {
      places.push_back(from_plane(place, plane(), origin));
    }
  }
  if (places.empty()) {
    throw ReadFault{"pattern", column, NC_("core", "PATTERN DEF without a pattern"),
                    NC_("core", "write POS1 (X+5 Y+5 Z+0)")};
  }
  cycle_calls_.set_pattern(std::move(places));
}

PatternWords PatternStatement::read_words(Scanner& scanner) const {
  PatternWords words;
  while (!scanner.take(')')) {
    const auto known = std::find_if(pattern_words.begin(), pattern_words.end(),
                                    [&](const PatternWord& word) { return scanner.take(word.name); });
    if (known == pattern_words.end()) {
      throw_unread_words(scanner, NC_("core", "a pattern"));
    }
    const double value = read_value(scanner);
    words.*known->value = known->is_length ? to_mm(value) : value;
  }
  return words;
}

}  // namespace feedscope::heidenhain
