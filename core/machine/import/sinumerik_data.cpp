#include "core/machine/import/sinumerik_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/machine/import/machine_draft.h"

namespace feedscope {
namespace {

/// Parts of "N32300 $MA_MAX_AX_ACCEL[0,AX1]=4".
struct MachineDatum {
  std::string name;                  ///< "MA_MAX_AX_ACCEL"
  std::vector<std::string> indices;  ///< "0", "AX1"
  std::string value;                 ///< without quotes
  std::string text;                  ///< as written, without the number at the start
  ConfigurationPlace place;
  bool used = false;
};

std::vector<std::string> between_commas(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.emplace_back(without_blanks(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

/// `line`: the datum, possibly after a block number.
std::optional<MachineDatum> machine_datum(const ConfigurationLine& line) {
  std::string_view text = line.text;
  if (text.starts_with('N')) {
    text = without_blanks(text.substr(std::min(text.find_first_not_of("0123456789", 1), text.size())));
  }
  constexpr std::array begins{"$MN_", "$MC_", "$MA_", "$SC_"};
  const bool is_one = std::ranges::any_of(begins, [&](const char* begin) { return text.starts_with(begin); });
  const std::size_t sign = text.find('=');
  if (!is_one || sign == std::string_view::npos) {
    return std::nullopt;
  }
  MachineDatum datum;
  datum.place.line = line.number;
  const std::string_view name = without_blanks(text.substr(1, sign - 1));
  const std::size_t open = name.find('[');
  datum.name = name.substr(0, open);
  if (open != std::string_view::npos) {
    datum.indices = between_commas(name.substr(open + 1, name.find(']') - open - 1));
  }
  std::string_view value = text.substr(sign + 1);
  value = without_blanks(value.substr(0, value.find(';')));
  datum.text = fmt::format("${} = {}", name, value);
  if (value.size() > 1 && (value.front() == '"' || value.front() == '\'')) {
    value = value.substr(1, std::min(value.find(value.front(), 1), value.size()) - 1);
  }
  datum.value = value;
  return datum;
}

std::size_t recognised_data(std::string_view text) {
  std::size_t data = 0;
  std::size_t others = 0;
  for (const ConfigurationLine& line : lines_of(text)) {
    if (machine_datum(line)) {
      ++data;
    } else if (!line.text.empty() && line.text.front() != ';' && line.text.front() != '%') {
      ++others;
    }
  }
  return data > others ? data : 0;
}

/// A datum that is used for an axis; tables of the control contain values by dynamic mode or parameter set.
struct AxisDatum {
  const char* name;
  const char* key;  ///< of axis_specs()
  const char* unit;
  double (*to_unit)(double);
};

constexpr double kv_in_1_s(double value) {
  return value * 1000 / 60;  // from m/min over mm
}
constexpr double seconds_in_ms(double value) {
  return units::to_ms(value);
}

constexpr std::array axis_data{
    AxisDatum{"MA_MAX_AX_VELO", "velocity", "mm/min", units::to_m},
    AxisDatum{"MA_MAX_AX_ACCEL", "acceleration", "m/s2", units::as_it_is},
    AxisDatum{"MA_MAX_AX_JERK", "jerk", "m/s3", units::as_it_is},
    AxisDatum{"MA_POSCTRL_GAIN", "kv", "1000/min", kv_in_1_s},
};

class SinumerikReader {
 public:
  explicit SinumerikReader(MachineDraft draft) : draft_(std::move(draft)) {}

  ImportedMachine read(std::string_view text) {
    for (const ConfigurationLine& line : lines_of(text)) {
      if (std::optional<MachineDatum> datum = machine_datum(line)) {
        add(std::move(*datum));
      } else {
        note_other_line(line);
      }
    }
    Machine& machine = draft_.machine();
    machine.control = "Siemens Sinumerik";
    machine.reference = fmt::format("{}, machine data of the machine's Sinumerik", draft_.file());
    draft_.choose_model({"essid"});
    if (const MachineDatum* scaling = find("MN_SCALING_SYSTEM_IS_METRIC");
        scaling != nullptr && scaling->value == "0") {
      draft_.note(
          Severity::error, scaling->place, "inch-system",
          NC_("core",
              "the basic system is inch, in which machine data are not imported; all limits are assumed"),
          NC_("core", "export the machine data with MD10240 = 1"));
      return finish();
    }
    for (const AxisInfo& axis : known_axes) {
      read_axis(axis.name);
    }
    read_control();
    return finish();
  }

 private:
  void add(MachineDatum datum) {
    std::string key = datum.name;
    for (const std::string& index : datum.indices) {
      key += '|' + in_upper_case(index);
    }
    const auto [before, is_first] = data_.try_emplace(std::move(key), datum);
    if (!is_first && before->second.value != datum.value) {
      draft_.note(Severity::warning, datum.place, "given-twice",
                  message(NC_("core", "{}, but {} in {}; {} is used"), datum.text, before->second.value,
                          draft_.place_text(before->second.place), datum.value),
                  NC_("core", "remove one of the two"));
      before->second = std::move(datum);
    }
  }

  void note_other_line(const ConfigurationLine& line) {
    const std::string_view text = line.text;
    constexpr std::array usual{"CHANDATA", "M17", "M30", "M02", "M2"};
    const bool known = text.empty() || text.front() == ';' || text.front() == '%' ||
                       std::ranges::any_of(usual, [&](const char* one) { return text.starts_with(one); });
    if (!known) {
      draft_.note(Severity::info, {line.number, ""}, "not-understood",
                  message(NC_("core", "'{}' is no machine datum; skipped"), text));
    }
  }

  const MachineDatum* find(const std::string& key) {
    const auto found = data_.find(key);
    if (found == data_.end()) {
      return nullptr;
    }
    found->second.used = true;
    return &found->second;
  }

  ImportedMachine finish() {
    for (const auto& [key, datum] : data_) {
      if (!datum.used) {
        draft_.leave_out(datum.text.substr(0, datum.text.find(" = ")));
      }
    }
    return draft_.finish(sinumerik_data.kind, {30, 3, 50});
  }

  /// Index of a value in a table of names, such as the geometry axes; none if it is not there.
  std::optional<std::size_t> place_in(const std::string& table, char axis) {
    constexpr std::size_t longest = 31;
    for (std::size_t i = 0; i < longest; ++i) {
      const MachineDatum* name = find(fmt::format("{}|{}", table, i));
      if (name != nullptr && in_upper_case(name->value) == std::string(1, axis)) {
        return i;
      }
    }
    return std::nullopt;
  }

  /// A 1-based number of a table; 0 if it has none.
  std::size_t number_in(const std::string& table, std::size_t place) {
    const MachineDatum* entry = find(fmt::format("{}|{}", table, place));
    std::size_t number = 0;
    if (entry != nullptr) {
      std::from_chars(entry->value.data(), entry->value.data() + entry->value.size(), number);
    }
    return number;
  }

  /// Names of the machine axis that moves a geometry axis: from the tables of the channel, else its own name,
  /// else from the order of the axes.
  std::vector<std::string> machine_axis(char axis) {
    std::optional<std::size_t> channel_axis = place_in("MC_AXCONF_CHANAX_NAME_TAB", axis);
    if (const auto geometry = place_in("MC_AXCONF_GEOAX_NAME_TAB", axis)) {
      const std::size_t assigned = number_in("MC_AXCONF_GEOAX_ASSIGN_TAB", *geometry);
      channel_axis = assigned > 0 ? std::optional(assigned - 1) : channel_axis;
    }
    std::size_t number = channel_axis ? number_in("MC_AXCONF_MACHAX_USED", *channel_axis) : 0;
    const std::size_t usual = *known_axes.find(axis) + 1;
    if (number == 0) {
      number = usual;
      assumed_axes_ = true;
    }
    std::vector<std::string> names{fmt::format("AX{}", number)};
    if (const MachineDatum* name = find(fmt::format("MN_AXCONF_MACHAX_NAME_TAB|{}", number - 1))) {
      names.push_back(in_upper_case(name->value));
    }
    names.push_back(fmt::format("{}1", axis));
    names.emplace_back(1, axis);
    return names;
  }

  /// Datum of an axis in its first row: [AX1], [0,AX1].
  const MachineDatum* of_axis(const std::string& name, const std::vector<std::string>& axis) {
    for (const std::string& one : axis) {
      const MachineDatum* datum = find(fmt::format("{}|{}", name, one));
      datum = datum == nullptr ? find(fmt::format("{}|0|{}", name, one)) : datum;
      if (datum != nullptr) {
        return datum;
      }
    }
    return nullptr;
  }

  std::optional<double> number(const MachineDatum& datum, const char* unit = "") {
    return draft_.number(datum.value, given(datum, unit));
  }
  static GivenValue given(const MachineDatum& datum, const char* unit = "") {
    return {datum.place, fmt::format("{} {}", datum.text, unit)};
  }

  void read_axis(char axis) {
    const std::vector<std::string> names = machine_axis(axis);
    const MachineDatum* rotary = of_axis("MA_IS_ROT_AX", names);
    if (rotary != nullptr && (rotary->value == "1" || in_upper_case(rotary->value) == "TRUE")) {
      draft_.note(
          Severity::warning, rotary->place, "axis-skipped",
          message(NC_("core", "machine axis {} would be {} but is a rotary axis; its limits are assumed"),
                  names.front(), axis));
      return;
    }
    for (const AxisDatum& wanted : axis_data) {
      const MachineDatum* datum = of_axis(wanted.name, names);
      if (const std::optional<double> value = datum == nullptr ? std::nullopt : number(*datum, wanted.unit)) {
        draft_.give_axis(axis, wanted.key, wanted.to_unit(*value), given(*datum, wanted.unit));
        note_other_modes(*datum);
      }
    }
    read_drive(axis, names);
    if (assumed_axes_ && !std::exchange(told_, true)) {
      draft_.note(Severity::info, {}, "axes-assumed",
                  NC_("core", "which machine axes X, Y and Z are is not told; AX1, AX2 and AX3 are assumed"),
                  NC_("core", "add MD20050 to MD20080 of the channel"));
    }
  }

  /// Notes other values in rows for other dynamic modes: DYNPOS, DYNROUGH, DYNSEMIFIN, DYNFINISH.
  void note_other_modes(const MachineDatum& used) {
    constexpr std::array modes{"DYNNORM", "DYNPOS", "DYNROUGH", "DYNSEMIFIN", "DYNFINISH"};
    if (used.indices.size() < 2 || used.name == "MA_POSCTRL_GAIN") {
      return;
    }
    for (std::size_t mode = 1; mode < modes.size(); ++mode) {
      const MachineDatum* other =
          find(fmt::format("{}|{}|{}", used.name, mode, in_upper_case(used.indices.back())));
      if (other != nullptr && other->value != used.value) {
        draft_.note(Severity::info, other->place, "other-mode",
                    message(NC_("core", "{} holds with {}; the value of DYNNORM, {}, is used"), other->text,
                            std::string_view(modes[mode]), used.value),
                    NC_("core", "change it in the machine file for programs that finish with another mode"));
      }
    }
  }

  /// Feed-forward and lag of an axis with a gain.
  void read_drive(char axis, const std::vector<std::string>& names) {
    if (!draft_.has_axis(axis, "kv")) {
      return;
    }
    const MachineDatum* mode = of_axis("MA_FFW_MODE", names);
    const MachineDatum* weight = of_axis("MA_VELO_FFW_WEIGHT", names);
    if (mode != nullptr && mode->value == "0") {
      draft_.give_axis(axis, "velocity_feedforward", 0, given(*mode));
    } else if (const auto share = weight == nullptr ? std::nullopt : number(*weight)) {
      draft_.give_axis(axis, "velocity_feedforward", *share, given(*weight, "(with FFWON)"));
    }
    const MachineDatum* lag = of_axis("MA_EQUIV_SPEEDCTRL_TIME", names);
    if (const auto time = lag == nullptr ? std::nullopt : number(*lag, "s")) {
      draft_.give_axis(axis, "velocity_lag", seconds_in_ms(*time), given(*lag, "s"));
    }
  }

  void read_control() {
    give("MN_IPO_CYCLE_TIME", "interpolation_period_s", "s");
    give("MC_LOOKAH_NUM_CHECKED_BLOCKS", "lookahead_blocks", "");
    give("MC_COMPRESS_BLOCK_PATH_LIMIT", "compressor_block_mm", "mm");
    const MachineDatum* jerk = find("MC_MAX_PATH_JERK");
    jerk = jerk == nullptr ? find("MC_MAX_PATH_JERK|0") : jerk;
    if (const auto value = jerk == nullptr ? std::nullopt : number(*jerk, "m/s3")) {
      draft_.give("curvilinear_jerk_m_s3", *value, given(*jerk, "m/s3"));
    }
    const MachineDatum* tolerance = find("SC_SMOOTH_CONTUR_TOL");
    for (const AxisInfo& axis : known_axes) {
      const MachineDatum* other = of_axis("MA_COMPRESS_POS_TOL", machine_axis(axis.name));
      tolerance = tolerance == nullptr ? other : tolerance;
    }
    if (const auto value = tolerance == nullptr ? std::nullopt : number(*tolerance, "mm")) {
      draft_.give("contour_tolerance_mm", *value, given(*tolerance, "mm"));
    }
  }

  void give(const char* name, const char* key, const char* unit) {
    const MachineDatum* datum = find(name);
    if (const auto value = datum == nullptr ? std::nullopt : number(*datum, unit)) {
      draft_.give(key, *value, given(*datum, unit));
    }
  }

  MachineDraft draft_;
  std::map<std::string, MachineDatum> data_;  ///< by name and indices, "MA_MAX_AX_ACCEL|0|AX1"
  bool assumed_axes_ = false;
  bool told_ = false;
};

ImportedMachine read_sinumerik(const ConfigurationSource& source, MachineDraft draft) {
  return SinumerikReader(std::move(draft)).read(source.text);
}

}  // namespace

const ConfigurationFormat sinumerik_data{QT_TRANSLATE_NOOP("core", "machine data of a Sinumerik"),
                                         recognised_data, read_sinumerik};

}  // namespace feedscope
