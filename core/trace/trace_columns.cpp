#include "core/trace/trace_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "core/base/error.h"
#include "core/base/nearest_name.h"
#include "core/base/typed_number.h"

namespace feedscope {
namespace {

constexpr std::array<std::string_view, trace_quantity_count> quantity_names{
    "time", "number", "x", "y", "z", "line", "feed", "actual_x", "actual_y", "actual_z"};

struct Unit {
  std::string_view name;
  double factor;
};

constexpr double inch = 25.4;
constexpr double minute = 60;
constexpr std::array<Unit, 5> time_units{
    {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}, {"min", minute}}};
constexpr std::array<Unit, 6> length_units{
    {{"mm", 1}, {"um", 1e-3}, {"nm", 1e-6}, {"m", 1e3}, {"in", inch}, {"inch", inch}}};
constexpr std::array<Unit, 6> feed_units{{{"mm/s", 1},
                                          {"mm/min", 1 / minute},
                                          {"m/min", 1e3 / minute},
                                          {"m/s", 1e3},
                                          {"in/s", inch},
                                          {"in/min", inch / minute}}};

std::string lower(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\"");
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(" \t\"") - first + 1);
}

template <std::size_t n>
std::optional<double> factor_in(const std::array<Unit, n>& units, std::string_view name) {
  const auto found = std::ranges::find(units, name, &Unit::name);
  return found == units.end() ? std::nullopt : std::optional(found->factor);
}

template <std::size_t n>
std::string names_of(const std::array<Unit, n>& units) {
  std::vector<std::string_view> names;
  for (const Unit& unit : units) {
    names.push_back(unit.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

[[noreturn]] void refuse(const Message& what) {
  throw InputError(message(NC_("core", "column specification: {}"), what));
}

double number_of(std::string_view key, std::string_view text, double least, double most) {
  const TypedNumber number = typed_number(text);
  if (!number.value || *number.value < least || *number.value > most) {
    refuse(message(NC_("core", "{}={} must be a number from {} to {}"), key, text, least, most));
  }
  return *number.value;
}

char separator_of(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, char>, 4> words{
      {{"tab", '\t'}, {"comma", ','}, {"semicolon", ';'}, {"blank", ' '}}};
  for (const auto& [name, separator] : words) {
    if (word == name) {
      return separator;
    }
  }
  refuse(message(NC_("core", "separator={} must be tab, comma, semicolon or blank"), word));
}

char decimal_of(std::string_view word) {
  if (word != "point" && word != "comma") {
    refuse(message(NC_("core", "decimal={} must be point or comma"), word));
  }
  return word == "point" ? '.' : ',';
}

/// Removes ":12.5" from the end of "2:mm:12.5" and returns the offset; 0 if there is none.
double take_offset(TraceQuantity quantity, std::string_view& value) {
  const auto last = value.rfind(':');
  if (last == std::string_view::npos || value.substr(0, last).find(':') == std::string_view::npos) {
    return 0;
  }
  const TypedNumber number = typed_number(trimmed(value.substr(last + 1)));
  if (!number.value) {
    return 0;  // the colon belongs to the column's name
  }
  if (!is_position(quantity)) {
    refuse(message(NC_("core", "{} cannot have an offset, {}; positions of axes can"), to_string(quantity),
                   value.substr(last + 1)));
  }
  value = value.substr(0, last);
  return *number.value;
}

TraceColumn column_of(TraceQuantity quantity, std::string_view value) {
  TraceColumn column;
  column.offset = take_offset(quantity, value);
  const auto colon = value.rfind(':');
  column.column = std::string(trimmed(value.substr(0, colon)));
  if (column.column.empty()) {
    refuse(message(NC_("core", "{}= needs the number or the name of a column, such as {}=2"),
                   to_string(quantity), to_string(quantity)));
  }
  if (colon != std::string_view::npos && !(column.offset != 0 && trimmed(value.substr(colon + 1)).empty())) {
    std::string_view unit = trimmed(value.substr(colon + 1));
    const bool mirrored = unit.starts_with('-');
    unit.remove_prefix(mirrored ? 1 : 0);
    const auto factor = trace_unit(quantity, unit);
    if (!factor) {
      refuse(message(NC_("core", "unit '{}' of {} is not known; known: {}"), unit, to_string(quantity),
                     trace_units(quantity)));
    }
    column.factor = mirrored ? -*factor : *factor;
    column.unit_given = true;
    column.unit = std::string(unit);
  }
  return column;
}

void apply(TraceColumns& columns, std::string_view key, std::string_view value) {
  constexpr double slowest = 1e-9;
  constexpr double fastest = 1e9;
  const auto quantity = std::ranges::find(quantity_names, key);
  if (quantity != quantity_names.end()) {
    const auto q = static_cast<TraceQuantity>(quantity - quantity_names.begin());
    columns.of(q) = column_of(q, value);
  } else if (key == "period") {
    columns.period = number_of(key, value, slowest, fastest);
  } else if (key == "rate") {
    columns.period = 1 / number_of(key, value, slowest, fastest);
  } else if (key == "separator") {
    columns.separator = separator_of(value);
  } else if (key == "decimal") {
    columns.decimal = decimal_of(value);
  } else if (key == "skip") {
    columns.skip = static_cast<std::size_t>(number_of(key, value, 0, fastest));
  } else {
    std::vector<std::string> known(quantity_names.begin(), quantity_names.end());
    known.insert(known.end(), {"period", "rate", "separator", "decimal", "skip"});
    const std::string nearest = nearest_name(key, known);
    refuse(message(NC_("core", "unknown key '{}'; {}"), key,
                   nearest.empty() ? message(NC_("core", "known: {}"), fmt::to_string(fmt::join(known, ", ")))
                                   : message(NC_("core", "did you mean '{}'?"), nearest)));
  }
}

/// Reads assignments into `columns`.
TraceColumns parse_assignments(std::string_view specification, TraceColumns columns = {}) {
  while (!specification.empty()) {
    const auto end = specification.find(',');
    const std::string_view part = trimmed(specification.substr(0, end));
    specification = end == std::string_view::npos ? std::string_view() : specification.substr(end + 1);
    const auto equals = part.find('=');
    if (equals == std::string_view::npos) {
      refuse(message(NC_("core", "'{}' is not KEY=VALUE"), part));
    }
    apply(columns, trimmed(part.substr(0, equals)), trimmed(part.substr(equals + 1)));
  }
  return columns;
}

/// Words of "X_mm" and "Pos. X1 [mm]": x, mm; pos, x1, mm.
std::vector<std::string> words_of(std::string_view title) {
  std::vector<std::string> words{""};
  for (const char c : lower(title)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) {
    words.pop_back();
  }
  return words;
}

bool any_of(const std::vector<std::string>& words, std::initializer_list<std::string_view> wanted) {
  return std::ranges::any_of(words, [&](const std::string& word) {
    return std::ranges::find(wanted, std::string_view(word)) != wanted.end();
  });
}

/// Unit in a title: "mm" of "X [mm]", "X (mm)" and "x_mm", "mm/min" of "feed_mm_min".
std::string unit_of(std::string_view title) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const auto begin = title.find(open);
    const auto end = begin == std::string_view::npos ? begin : title.find(close, begin);
    if (end != std::string_view::npos) {
      const std::string unit = lower(trimmed(title.substr(begin + 1, end - begin - 1)));
      if (!unit.empty() && std::isdigit(static_cast<unsigned char>(unit.front())) == 0) {
        return unit;
      }
    }
  }
  std::string small = lower(trimmed(title));
  for (const std::string_view unit : {"_mm_min", "_mm_s", "_m_min", "_in_min", "_in_s", "_m_s", "_mm", "_um",
                                      "_inch", "_in", "_ms", "_us", "_s", "_m"}) {
    if (small.ends_with(unit) && small.size() > unit.size()) {
      std::string text(unit.substr(1));
      std::ranges::replace(text, '_', '/');
      return text;
    }
  }
  return "";
}

std::optional<TraceQuantity> axis_of(const std::vector<std::string>& words) {
  if (any_of(words, {"error", "err", "deviation", "current", "torque", "power", "load", "acc", "acceleration",
                     "jerk", "vel", "velocity", "speed", "following", "lag", "offset"})) {
    return std::nullopt;
  }
  constexpr std::array<std::pair<char, TraceQuantity>, 3> axes{
      {{'x', TraceQuantity::x}, {'y', TraceQuantity::y}, {'z', TraceQuantity::z}}};
  for (const auto& [letter, quantity] : axes) {
    const std::string name(1, letter);
    if (any_of(words, {name, name + "1", "m" + name, "m" + name + "1", "pos" + name, "axis" + name,
                       name + "pos", name + "set", name + "cmd"})) {
      return quantity;
    }
  }
  return std::nullopt;
}

}  // namespace

std::string_view to_string(TraceQuantity quantity) {
  return quantity_names[static_cast<std::size_t>(quantity)];
}

bool is_position(TraceQuantity quantity) {
  return std::ranges::find(place_quantities, quantity) != place_quantities.end() ||
         std::ranges::find(actual_quantities, quantity) != actual_quantities.end();
}

bool TraceColumns::any() const {
  return std::ranges::any_of(columns, [](const auto& column) { return column.has_value(); });
}

const std::vector<TracePreset>& trace_presets() {
  static const std::vector<TracePreset> presets{
      {"linuxcnc", "number=1,x=2:mm,y=3:mm,z=4:mm,line=5,feed=6:mm/s,separator=blank"},
      {"linuxcnc-xyz", "number=1,x=2:mm,y=3:mm,z=4:mm,separator=blank"},
      {"feedscope", "time=time_s:s,x=x_mm:mm,y=y_mm:mm,z=z_mm:mm,line=line,feed=feed_mm_min:mm/min"},
      {"feedscope-actual", "time=time_s:s,x=actual_x_mm:mm,y=actual_y_mm:mm,z=actual_z_mm:mm,line=line"},
  };
  return presets;
}

TraceColumns parse_trace_columns(const std::string& specification) {
  const std::string_view all = specification;
  const auto end = std::min(all.find(','), all.size());
  const std::string_view first = trimmed(all.substr(0, end));
  if (first.find('=') != std::string_view::npos) {
    return parse_assignments(all);
  }
  std::vector<std::string_view> names;
  for (const TracePreset& preset : trace_presets()) {
    if (first == preset.name) {
      return parse_assignments(all.substr(std::min(end + 1, all.size())),
                               parse_assignments(preset.specification));
    }
    names.push_back(preset.name);
  }
  throw InputError(message(NC_("core",
                               "'{}' is no preset of columns; known: {}; or write a specification such as "
                               "time=1:ms,x=2:mm,y=3:mm"),
                           first, fmt::to_string(fmt::join(names, ", "))));
}

std::optional<double> trace_unit(TraceQuantity quantity, std::string_view unit) {
  switch (quantity) {
    case TraceQuantity::time:
      return factor_in(time_units, unit);
    case TraceQuantity::feed:
      return factor_in(feed_units, unit);
    default:
      if (is_position(quantity)) {
        return factor_in(length_units, unit);
      }
      return unit.empty() ? std::optional(1.0) : std::nullopt;
  }
}

std::string trace_units(TraceQuantity quantity) {
  switch (quantity) {
    case TraceQuantity::time:
      return names_of(time_units);
    case TraceQuantity::feed:
      return names_of(feed_units);
    default:
      return is_position(quantity) ? names_of(length_units) : "none";
  }
}

NamedColumn recognise_column(std::string_view title) {
  NamedColumn named;
  named.unit = unit_of(title);
  const std::vector<std::string> words = words_of(title);
  if (words.empty()) {
    return named;
  }
  if (const auto axis = axis_of(words)) {
    named.quantity = axis;
    const bool set = any_of(words, {"set", "setpoint", "setpt", "cmd", "command", "nominal", "soll",
                                    "sollwert", "desval", "desired"});
    named.actual = !set && any_of(words, {"act", "actual", "ist", "istwert", "measured", "fb", "encoder"});
    named.rank = set ? 2 : named.actual ? 0 : 1;
  } else if (any_of(words, {"time", "t", "zeit", "temps", "sampletime", "timestamp"})) {
    named.quantity = TraceQuantity::time;
  } else if (any_of(words,
                    {"line", "block", "zeile", "satz", "satznummer", "ligne", "linenumber", "blocknumber"})) {
    named.quantity = TraceQuantity::line;
  } else if (any_of(words, {"feed", "feedrate", "vorschub", "avance", "bahngeschwindigkeit"}) &&
             !any_of(words, {"programmed", "prog", "override", "per"})) {
    named.quantity = TraceQuantity::feed;
  } else if (any_of(words, {"number", "sample", "nr", "index", "cycle"})) {
    named.quantity = TraceQuantity::number;
  }
  if (named.quantity && !trace_unit(*named.quantity, named.unit)) {
    named.unit.clear();
  }
  return named;
}

}  // namespace feedscope
