#include "core/machine/import/heidenhain_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/machine/import/numbered_parameters.h"

namespace feedscope {
namespace {

constexpr int tnc_rapid = 1010;
constexpr int tnc_acceleration = 1060;
constexpr int tnc_path_acceleration = 1061;
constexpr int tnc_axis_jerk = 1085;
constexpr int tnc_path_jerk = 1090;

/// Parts of "MP1010.0 : 30000".
struct TncParameter {
  int number = 0;
  int index = NumberedParameters::no_axis;
  std::string_view value;
};

std::optional<TncParameter> tnc_parameter(std::string_view line) {
  if (!line.starts_with("MP")) {
    return std::nullopt;
  }
  line.remove_prefix(2);
  TncParameter parameter;
  const auto number = std::from_chars(line.data(), line.data() + line.size(), parameter.number);
  if (number.ec != std::errc()) {
    return std::nullopt;
  }
  line.remove_prefix(static_cast<std::size_t>(number.ptr - line.data()));
  if (line.starts_with('.')) {
    const auto index = std::from_chars(line.data() + 1, line.data() + line.size(), parameter.index);
    if (index.ec != std::errc()) {
      return std::nullopt;
    }
    line.remove_prefix(static_cast<std::size_t>(index.ptr - line.data()));
  }
  line = without_blanks(line.substr(0, line.find(';')));
  if (line.empty() || (line.front() != ':' && line.front() != '=')) {
    return std::nullopt;
  }
  parameter.value = without_blanks(line.substr(1));
  return parameter;
}

std::size_t recognised_tnc(std::string_view text) {
  std::size_t parameters = 0;
  std::size_t others = 0;
  for (const ConfigurationLine& line : lines_of(text)) {
    if (tnc_parameter(line.text)) {
      ++parameters;
    } else if (!line.text.empty() && line.text.front() != ';') {
      ++others;
    }
  }
  return parameters > others ? parameters : 0;
}

class TncReader {
 public:
  explicit TncReader(MachineDraft draft) : draft_(std::move(draft)) {}

  ImportedMachine read(std::string_view text) {
    for (const ConfigurationLine& line : lines_of(text)) {
      read_line(line);
    }
    Machine& machine = draft_.machine();
    machine.control = "Heidenhain";
    machine.reference = fmt::format("{}, machine parameters of the machine's Heidenhain", draft_.file());
    draft_.choose_model({"ward"});
    draft_.note(Severity::info, {}, "axes-assumed", NC_("core", "indices 0, 1 and 2 are taken as X, Y and Z"),
                NC_("core", "exchange the axes in the machine file where that is not so"));
    for (int i = 0; i < static_cast<int>(known_axes.size()); ++i) {
      read_axis(known_axes[static_cast<std::size_t>(i)].name, i);
    }
    if (const NumberedParameters::Entry* path = parameters_.find(tnc_path_acceleration, 0)) {
      draft_.note(
          Severity::info, path->given.place, "not-modelled",
          message(NC_("core",
                      "the acceleration along the path, {} m/s2, is not modelled: those of the axes hold"),
                  path->given.what));
    }
    return draft_.finish(heidenhain_parameters.kind, {30, 3, 40});
  }

 private:
  void read_line(const ConfigurationLine& line) {
    const ConfigurationPlace place{line.number, ""};
    const std::optional<TncParameter> parameter = tnc_parameter(line.text);
    if (!parameter) {
      if (!line.text.empty() && line.text.front() != ';') {
        draft_.note(Severity::info, place, "not-understood",
                    message(NC_("core", "'{}' is not a machine parameter; it is skipped"), line.text));
      }
      return;
    }
    const bool used = parameter->number == tnc_rapid || parameter->number == tnc_acceleration ||
                      parameter->number == tnc_path_acceleration || parameter->number == tnc_axis_jerk ||
                      parameter->number == tnc_path_jerk;
    const GivenValue given{
        place, parameter->index < 0
                   ? fmt::format("MP{} = {}", parameter->number, parameter->value)
                   : fmt::format("MP{}.{} = {}", parameter->number, parameter->index, parameter->value)};
    if (!used) {
      draft_.leave_out(fmt::format("MP{}", parameter->number));
    }
    if (const auto value = used ? draft_.number(parameter->value, given) : std::nullopt) {
      parameters_.add(parameter->number, parameter->index, {*value, given}, draft_);
    }
  }

  void read_axis(char axis, int index) {
    give(axis, "velocity", parameters_.find(tnc_rapid, index), units::to_m, "mm/min");
    give(axis, "acceleration", parameters_.find(tnc_acceleration, index), units::as_it_is, "m/s2");
    const NumberedParameters::Entry* jerk = parameters_.find(tnc_axis_jerk, index);
    const NumberedParameters::Entry* path = parameters_.find(tnc_path_jerk, 0);
    if (jerk == nullptr || jerk->value == 0 || (path != nullptr && path->value < jerk->value)) {
      jerk = path;  // maximum for all axes
    }
    give(axis, "jerk", jerk, units::as_it_is, "m/s3");
  }

  void give(char axis, const char* key, const NumberedParameters::Entry* entry, double (*to_unit)(double),
            const char* unit) {
    if (entry != nullptr) {
      draft_.give_axis(axis, key, to_unit(entry->value),
                       {entry->given.place, fmt::format("{} {}", entry->given.what, unit)});
    }
  }

  MachineDraft draft_;
  NumberedParameters parameters_;
};

ImportedMachine read_tnc(const ConfigurationSource& source, MachineDraft draft) {
  return TncReader(std::move(draft)).read(source.text);
}

}  // namespace

const ConfigurationFormat heidenhain_parameters{
    QT_TRANSLATE_NOOP("core", "machine parameters of a Heidenhain"), recognised_tnc, read_tnc};

}  // namespace feedscope
