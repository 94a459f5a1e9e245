#include "core/program/dialect.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/program/iso/language/printer_words.h"
#include "core/program/text/scanner.h"

namespace feedscope {

namespace {

constexpr auto dialects = std::to_array<DialectInfo>({
    {Dialect::iso, "iso", "ISO"},
    {Dialect::fanuc, "fanuc", "Fanuc"},
    {Dialect::linuxcnc, "linuxcnc", "LinuxCNC"},
    {Dialect::grbl, "grbl", "grbl"},
    {Dialect::sinumerik, "sinumerik", "Sinumerik 840D"},
    {Dialect::heidenhain, "heidenhain", "Heidenhain"},
    {Dialect::heidenhain_iso, "heidenhain-iso", "Heidenhain DIN/ISO"},
});

/// Points for each dialect, by its number.
using Score = std::array<int, dialects.size()>;

constexpr int decisive = 100;

int& of(Score& score, Dialect dialect) {
  return score[static_cast<std::size_t>(dialect)];
}

template <std::size_t Count>
bool is_one_of(std::string_view word, const std::array<std::string_view, Count>& words) {
  return std::any_of(words.begin(), words.end(),
                     [&](std::string_view candidate) { return letters::same(word, candidate); });
}

/// Names of statements, or in them, that only the Sinumerik has.
constexpr auto sinumerik_names = std::to_array<std::string_view>(
    {"DEF",   "PROC",  "MSG",     "TRANS",  "ATRANS",  "ROT",     "AROT",      "SCALE",  "ASCALE", "MIRROR",
     "SUPA",  "CTOL",  "OTOL",    "COMPOF", "COMPON",  "COMPCAD", "COMPCURV",  "SOFT",   "BRISK",  "FFWON",
     "FFWOF", "GOTOF", "GOTOB",   "STOPRE", "TRAORI",  "TRAFOOF", "WORKPIECE", "EXTERN", "MCALL",  "ENDFOR",
     "CIP",   "CT",    "ENDLOOP", "UNTIL",  "BSPLINE", "ASPLINE", "CSPLINE",   "DIAMON", "CFC",    "CFTCP"});

/// Statements of Okuma's OSP: run mode of the following blocks, subprogram calls at each position, their end.
constexpr auto okuma_statements =
    std::to_array<std::string_view>({"NOEX", "MODIN", "MODOUT", "RTS", "VZOFX", "VZOFY", "VZOFZ", "VTOFH"});

constexpr std::uint32_t lines_looked_at = 2000;

constexpr auto linuxcnc_flow =
    std::to_array<std::string_view>({"SUB", "ENDSUB", "CALL", "IF", "ELSEIF", "ELSE", "ENDIF", "WHILE",
                                     "ENDWHILE", "DO", "REPEAT", "ENDREPEAT", "RETURN"});

constexpr auto heidenhain_words =
    std::to_array<std::string_view>({"L", "CC", "LBL", "FN", "CP", "LP", "RND", "STOP", "CR", "CT"});

void score_heidenhain(Scanner scan, Score& score) {
  const bool numbered = scan.number().has_value();
  const std::string_view first = scan.name();
  if (first.empty()) {
    return;
  }
  const std::string_view second = Scanner(scan).name();
  const auto pair = [&](std::string_view a, std::string_view b) {
    return letters::same(first, a) && letters::same(second, b);
  };
  if (pair("BEGIN", "PGM")) {
    of(score, Dialect::heidenhain) += decisive;
  } else if (pair("TOOL", "CALL") || pair("TOOL", "DEF") || pair("CYCL", "DEF") || pair("BLK", "FORM") ||
             pair("END", "PGM") || (numbered && is_one_of(first, heidenhain_words))) {
    of(score, Dialect::heidenhain) += 3;
  }
}

void score_statement(std::string_view line, Scanner scan, Score& score) {
  if (scan.take('O') && scan.peek() == '<') {
    of(score, Dialect::linuxcnc) += decisive;
    return;
  }
  scan = Scanner(line);
  scan.take('/');
  if (scan.take('N')) {
    scan.number();
  }
  Scanner word = scan;
  const bool tape_number = line.starts_with(':');
  if ((word.take('O') || (tape_number && word.take(':'))) && word.number()) {
    if (is_one_of(word.name(), linuxcnc_flow)) {
      of(score, Dialect::linuxcnc) += decisive;
    } else if (word.at_end() || word.peek() == '(') {
      of(score, Dialect::fanuc) += 3;
    }
    return;
  }
  word = scan;
  const std::string_view name = word.name();
  if (is_one_of(name, sinumerik_names) || (name.size() > 5 && letters::same(name.substr(0, 5), "CYCLE"))) {
    of(score, Dialect::sinumerik) += 3;
  } else if ((letters::same(name, "IF") || letters::same(name, "WHILE")) && word.peek() == '[') {
    of(score, Dialect::fanuc) += 5;
  }
}

void score_content(std::string_view line, Score& score) {
  const bool has_hash = line.find('#') != std::string_view::npos;
  if (line.find("#<") != std::string_view::npos) {
    of(score, Dialect::linuxcnc) += 5;
  }
  if (!has_hash) {
    const std::size_t equals = line.find('=');
    const std::size_t comment = std::min(line.find(';'), line.find('('));
    if (equals != std::string_view::npos && equals < comment && equals > 0 &&
        (letters::is_name_part(line[equals - 1]) || line[equals - 1] == ' ' || line[equals - 1] == ']')) {
      of(score, Dialect::sinumerik) += 2;
    }
  }
  for (std::size_t at = line.find_first_of("Gg"); at != std::string_view::npos;
       at = line.find_first_of("Gg", at + 1)) {
    if (at > 0 && letters::is_letter(line[at - 1])) {
      continue;
    }
    const std::string_view rest = line.substr(at + 1);
    if (rest.starts_with("05.1") || rest.starts_with("5.1 Q") || rest.starts_with("05 P10000") ||
        rest.starts_with("54.1")) {
      of(score, Dialect::fanuc) += 3;
    } else if (rest.size() >= 3 && rest.starts_with("64") && rest[2] >= '1' && rest[2] <= '5') {
      of(score, Dialect::sinumerik) += 3;
    } else if (rest.starts_with("64 P") || rest.starts_with("64P")) {
      of(score, Dialect::linuxcnc) += 2;
    }
  }
}

/// Heidenhain DIN/ISO: "%NAME G71 *", and "*" at the end of every block.
void score_din(std::string_view line, Score& score) {
  const std::size_t last = line.find_last_not_of(" \t");
  if (last != std::string_view::npos && line[last] == '*' && line.find('(') == std::string_view::npos) {
    of(score, Dialect::heidenhain_iso) += 2;
  }
  if (line.starts_with('%') &&
      (line.find("G71") != std::string_view::npos || line.find("G70") != std::string_view::npos)) {
    of(score, Dialect::heidenhain_iso) += 5;
  }
}

void score_line(std::string_view line, Score& score) {
  Scanner scan(line);
  const char first = scan.peek();
  if (first == '\0' || first == '(' || first == ';') {
    if (line.find("$PATH=") != std::string_view::npos) {
      of(score, Dialect::sinumerik) += decisive;
    }
    return;
  }
  if (line.starts_with("%_N_")) {
    of(score, Dialect::sinumerik) += decisive;
  }
  if (first == '$') {
    of(score, Dialect::grbl) += 3;
  }
  if (!iso::klipper_command(line).empty()) {
    of(score, Dialect::grbl) += 5;
    return;
  }
  score_din(line, score);
  try {
    score_heidenhain(scan, score);
    score_statement(line, scan, score);
  } catch (...) {
    // An unreadable number gives no hint of the dialect.
  }
  score_content(line, score);
}

/// True if a word with a number directly follows another word, "G15 H1".
bool has_pair(std::string_view line, std::string_view first, char second) {
  for (std::size_t at = 0; at + first.size() < line.size(); ++at) {
    if (!letters::same(line.substr(at, first.size()), first) ||
        (at > 0 && letters::is_name_part(line[at - 1]))) {
      continue;
    }
    Scanner scan(line, at + first.size());
    if (scan.take(second) && letters::is_digit(scan.peek())) {
      return true;
    }
  }
  return false;
}

/// Points for words of a line that only the controls of Okuma have.
int okuma_points(std::string_view line) {
  line = line.substr(0, line.find('('));
  int points = 0;
  points += has_pair(line, "G15", 'H') || has_pair(line, "G16", 'H') ? 3 : 0;
  points += has_pair(line, "G56", 'H') ? 2 : 0;
  Scanner scan(line);
  if (scan.take('N')) {
    scan.skip_digits();
  }
  const std::string_view name = scan.name();
  const bool variable = name.size() > 2 && letters::same(name.substr(0, 2), "VC") &&
                        letters::is_digit(name[2]) && scan.peek() == '=';
  const bool call = letters::same(name, "CALL") && scan.take('O');
  const bool statement = is_one_of(name, okuma_statements);
  return points + (variable || statement ? 3 : 0) + (call ? 4 : 0);
}

void score_ending(const std::string& name, Score& score) {
  const std::string ending = std::filesystem::path(name).extension().string();
  const auto is = [&](std::string_view other) { return letters::same(ending, other); };
  if (is(".mpf") || is(".spf")) {
    of(score, Dialect::sinumerik) += 4;
  } else if (is(".ngc")) {
    of(score, Dialect::linuxcnc) += 4;
  } else if (is(".h")) {
    of(score, Dialect::heidenhain) += 4;
  } else if (is(".i")) {
    of(score, Dialect::heidenhain_iso) += 1;
  } else if (is(".gcode")) {
    of(score, Dialect::grbl) += 1;
  }
}

}  // namespace

std::span<const DialectInfo> all_dialects() {
  return dialects;
}

const DialectInfo& info_of(Dialect dialect) {
  return dialects[static_cast<std::size_t>(dialect)];
}

Dialect dialect_of_id(std::string_view id) {
  std::vector<std::string> ids;
  for (const DialectInfo& info : dialects) {
    if (info.id == id) {
      return info.dialect;
    }
    ids.emplace_back(info.id);
  }
  const std::string nearest = nearest_name(id, ids);
  throw InputError(fmt::format("dialect: \"{}\" is not known{}; give one of {}", id,
                               nearest.empty() ? "" : fmt::format(", did you mean \"{}\"?", nearest),
                               fmt::join(ids, ", ")));
}

std::optional<ForeignLanguage> recognise_foreign(const SourceText& source) {
  constexpr int enough = 5;
  const std::string ending = std::filesystem::path(source.name()).extension().string();
  int points = letters::same(ending, ".min") || letters::same(ending, ".ssb") ? enough : 0;
  std::uint32_t first = 0;
  for (std::uint32_t line = 1; line <= std::min(source.line_count(), lines_looked_at); ++line) {
    const int more = okuma_points(source.line(line));
    first = first == 0 && more > 0 ? line : first;
    points += more;
  }
  if (points < enough) {
    return std::nullopt;
  }
  return ForeignLanguage{
      "Okuma OSP",
      NC_("core",
          "G15 H selects a work offset there, G56 H a tool length, VC1 is a variable and CALL a subprogram"),
      first};
}

Dialect recognise(const SourceText& source) {
  if (recognise_foreign(source)) {
    return Dialect::iso;
  }
  Score score{};
  score_ending(source.name(), score);
  for (std::uint32_t line = 1; line <= std::min(source.line_count(), lines_looked_at); ++line) {
    score_line(source.line(line), score);
  }
  const auto best = std::max_element(score.begin(), score.end());
  return *best == 0 ? Dialect::iso : dialects[static_cast<std::size_t>(best - score.begin())].dialect;
}

}  // namespace feedscope
