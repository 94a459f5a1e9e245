#include "core/machine/import/fanuc_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/translatable.h"
#include "core/base/typed_number.h"
#include "core/base/units.h"
#include "core/machine/import/numbered_parameters.h"
#include "core/machine/settings.h"

namespace feedscope {
namespace {

constexpr int rapid_traverse = 1420;
constexpr int cutting_feed = 1430;
constexpr int cutting_feed_ahead = 1432;  ///< under look-ahead control; 0: as 1430
constexpr int acceleration_limit = 1660;
constexpr int acceleration_change = 1772;
constexpr int loop_gain = 1825;
constexpr int axis_names = 1020;
constexpr int machine_unit = 1001;
constexpr int axis_kinds = 1006;
constexpr std::array used_parameters{rapid_traverse,     cutting_feed,        cutting_feed_ahead,
                                     acceleration_limit, acceleration_change, loop_gain,
                                     axis_names,         machine_unit,        axis_kinds};

/// A parameter that affects the time of a program but has no counterpart in machine files.
struct UnmodelledParameter {
  int number;
  Translatable meaning;
};
/// Source: Fanuc Series 0i-F and 30i-B, parameter manuals, "Feedrate" and "Acceleration/deceleration
/// control".
constexpr std::array unmodelled_parameters{
    UnmodelledParameter{1620, NC_("core", "time constant of rapids")},
    UnmodelledParameter{1622, NC_("core", "time constant of cutting feeds after interpolation")},
    UnmodelledParameter{1671, NC_("core", "acceleration of rapids")},
    UnmodelledParameter{1672, NC_("core", "time in which the acceleration of rapids is reached")},
    UnmodelledParameter{1732, NC_("core", "feed below which arcs do not slow down")},
    UnmodelledParameter{1735, NC_("core", "acceleration on arcs")},
    UnmodelledParameter{1737, NC_("core", "acceleration under look-ahead control")},
    UnmodelledParameter{1769, NC_("core", "time constant after interpolation under look-ahead control")},
    UnmodelledParameter{1783,
                        NC_("core", "difference of feeds that is passed at corners without slowing down")},
    UnmodelledParameter{1788, NC_("core", "change of acceleration that is passed without slowing down")},
};

/// A letter with the value after it.
struct FanucWord {
  char letter;
  std::string_view value;
};

/// Words of a line of parameters; none for another line.
std::vector<FanucWord> fanuc_words(std::string_view line) {
  constexpr std::string_view letters = "NQALTSP";
  std::vector<FanucWord> words;
  while (!(line = without_blanks(line)).empty()) {
    const std::size_t end = std::min(line.find_first_not_of("0123456789.-", 1), line.size());
    if (letters.find(line.front()) == std::string_view::npos || end == 1) {
      return {};
    }
    words.push_back({line.front(), line.substr(1, end - 1)});
    line.remove_prefix(end);
  }
  const bool has_value = std::ranges::find(words, 'P', &FanucWord::letter) != words.end();
  return has_value && words.front().letter == 'N' && words.front().value.size() <= 5
             ? words
             : std::vector<FanucWord>();
}

int whole(std::string_view text) {
  constexpr double most = 99999;
  const double value = typed_number(text).value.value_or(0);
  return value >= 0 && value <= most ? static_cast<int>(value) : 0;
}

std::size_t recognised_fanuc(std::string_view text) {
  std::size_t parameters = 0;
  std::size_t others = 0;
  bool has_limits = false;
  for (const ConfigurationLine& line : lines_of(text)) {
    const std::vector<FanucWord> words = fanuc_words(line.text);
    if (!words.empty()) {
      ++parameters;
      const int number = whole(words.front().value);
      has_limits = has_limits || number == rapid_traverse || number == acceleration_limit;
    } else if (!line.text.empty() && line.text != "%") {
      ++others;
    }
  }
  return has_limits && parameters > others ? parameters : 0;
}

class FanucReader {
 public:
  explicit FanucReader(MachineDraft draft) : draft_(std::move(draft)) {}

  ImportedMachine read(std::string_view text) {
    for (const ConfigurationLine& line : lines_of(text)) {
      read_line(line);
    }
    Machine& machine = draft_.machine();
    machine.control = "Fanuc";
    machine.reference = fmt::format("{}, parameters of the machine's Fanuc", draft_.file());
    draft_.choose_model({"essid"});
    draft_.note(Severity::info, {}, "not-modelled",
                NC_("core", "there is no model of a Fanuc: that of another control runs its limits"));
    if (is_inch_machine()) {
      return draft_.finish(fanuc_parameters.kind, {24, 3, 50});
    }
    for (const AxisInfo& axis : known_axes) {
      read_axis(axis.name);
    }
    return draft_.finish(fanuc_parameters.kind, {24, 3, 50});
  }

 private:
  void read_line(const ConfigurationLine& line) {
    const ConfigurationPlace place{line.number, ""};
    const std::vector<FanucWord> words = fanuc_words(line.text);
    if (words.empty()) {
      if (!line.text.empty() && line.text != "%") {
        draft_.note(Severity::info, place, "not-understood",
                    message(NC_("core", "'{}' is not a parameter; it is skipped"), line.text));
      }
      return;
    }
    const int number = whole(words.front().value);
    if (std::ranges::find(used_parameters, number) == used_parameters.end()) {
      note_unused(number, line, place);
      return;
    }
    int axis = NumberedParameters::no_axis;
    for (const FanucWord& word : words) {
      if (word.letter == 'A') {
        axis = whole(word.value);
      } else if (word.letter == 'P') {
        const GivenValue given{place, axis < 0 ? fmt::format("N{} P{}", number, word.value)
                                               : fmt::format("N{} A{} P{}", number, axis, word.value)};
        if (const std::optional<double> value = draft_.number(word.value, given)) {
          parameters_.add(number, axis, {*value, given}, draft_);
        }
      }
    }
  }

  void note_unused(int number, const ConfigurationLine& line, const ConfigurationPlace& place) {
    const auto known = std::ranges::find(unmodelled_parameters, number, &UnmodelledParameter::number);
    if (known == unmodelled_parameters.end()) {
      draft_.leave_out(fmt::format("N{}", number));
    } else {
      draft_.note(Severity::info, place, "not-modelled",
                  message(NC_("core", "{} ({}) is not modelled"), line.text, known->meaning));
    }
  }

  /// Bit 0 of 1001, which is written as eight digits.
  bool is_inch_machine() {
    const NumberedParameters::Entry* unit = parameters_.find(machine_unit);
    if (unit == nullptr || std::fmod(unit->value, 10) != 1) {
      return false;
    }
    draft_.note(Severity::error, unit->given.place, "inch-system",
                NC_("core",
                    "the machine measures in inches (1001, bit 0), in which parameters are not imported; all "
                    "limits are assumed"),
                NC_("core", "write its limits into a machine file"));
    return true;
  }

  /// Number of the axis with this name, by the ASCII codes of 1020; without those, in the usual order.
  int axis_number(char axis) {
    constexpr int most_axes = 32;
    for (int i = 1; i <= most_axes; ++i) {
      const NumberedParameters::Entry* name = parameters_.find(axis_names, i);
      if (name != nullptr && name->value == static_cast<double>(axis)) {
        return i;
      }
    }
    if (parameters_.has(axis_names)) {
      return 0;
    }
    if (axis == known_axes[0].name) {
      draft_.note(Severity::info, {}, "axes-assumed",
                  NC_("core", "which axes X, Y and Z are is not told; the first three are assumed"),
                  NC_("core", "add parameter 1020"));
    }
    return static_cast<int>(*known_axes.find(axis)) + 1;
  }

  void read_axis(char axis) {
    const int number = axis_number(axis);
    const NumberedParameters::Entry* kind = parameters_.find(axis_kinds, number);
    if (number == 0 || (kind != nullptr && std::fmod(kind->value, 10) == 1)) {
      draft_.note(Severity::warning, kind == nullptr ? ConfigurationPlace() : kind->given.place,
                  "axis-skipped",
                  message(NC_("core", "there is no linear axis {}; its limits are assumed"), axis));
      return;
    }
    give(axis, "velocity", rapid_traverse, number, units::to_m, "mm/min");
    give(axis, "acceleration", acceleration_limit, number, units::to_m, "mm/s2");
    give(
        axis, "kv", loop_gain, number, [](double value) { return value / 100; }, "of 0.01/s");
    const NumberedParameters::Entry* change = parameters_.find(acceleration_change);
    if (change != nullptr && change->value > 0 && draft_.has_axis(axis, "acceleration")) {
      draft_.give_axis(axis, "jerk", draft_.axis(axis, "acceleration") / units::from_ms(change->value),
                       {change->given.place,
                        fmt::format("{} ms, in which the acceleration is reached", change->given.what)});
    }
    give_cutting_feed(axis, number);
  }

  void give(char axis, const char* key, int parameter, int number, double (*to_unit)(double),
            const char* unit) {
    if (const NumberedParameters::Entry* entry = parameters_.find(parameter, number)) {
      draft_.give_axis(axis, key, to_unit(entry->value),
                       {entry->given.place, fmt::format("{} {}", entry->given.what, unit)});
    }
  }

  /// The limit under look-ahead control has precedence: programs for short cycle times run under it.
  void give_cutting_feed(char axis, int number) {
    const NumberedParameters::Entry* plain = parameters_.find(cutting_feed, number);
    const NumberedParameters::Entry* ahead = parameters_.find(cutting_feed_ahead, number);
    const bool has_both = plain != nullptr && ahead != nullptr && plain->value > 0 && ahead->value > 0;
    const NumberedParameters::Entry* used = ahead != nullptr && ahead->value > 0 ? ahead : plain;
    if (has_both && plain->value != ahead->value) {
      draft_.note(
          Severity::info, plain->given.place, "not-modelled",
          message(NC_("core", "{} is the cutting feed without look-ahead control; that with it, {}, is used"),
                  plain->given.what, ahead->given.what));
    }
    if (used != nullptr && used->value > 0) {
      draft_.give(cutting_feed_key(axis - 'X'), units::to_m(used->value),
                  {used->given.place, fmt::format("{} mm/min", used->given.what)});
    }
  }

  MachineDraft draft_;
  NumberedParameters parameters_;
};

ImportedMachine read_fanuc(const ConfigurationSource& source, MachineDraft draft) {
  return FanucReader(std::move(draft)).read(source.text);
}

}  // namespace

const ConfigurationFormat fanuc_parameters{QT_TRANSLATE_NOOP("core", "parameters of a Fanuc"),
                                           recognised_fanuc, read_fanuc};

}  // namespace feedscope
