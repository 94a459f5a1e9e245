#include "core/machine/import/grbl_listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/machine/import/machine_draft.h"

namespace feedscope {
namespace {

/// Parts of "$110=5000 (x max rate)".
struct GrblSetting {
  std::string name;  ///< "110", or a path of FluidNC, "/axes/x/steps_per_mm"
  std::string value;
  std::string comment;  ///< without parentheses
};

/// Setting in a line, after any prefix of a sender; none without one.
std::optional<GrblSetting> grbl_setting(std::string_view line) {
  const std::size_t begin = line.find('$');
  const std::size_t sign = line.find('=', std::min(begin, line.size()));
  if (begin == std::string_view::npos || sign == std::string_view::npos) {
    return std::nullopt;
  }
  GrblSetting setting;
  setting.name = without_blanks(line.substr(begin + 1, sign - begin - 1));
  std::string_view value = without_blanks(line.substr(sign + 1));
  if (const std::size_t comment = value.find_first_of("(;"); comment != std::string_view::npos) {
    setting.comment = without_blanks(value.substr(comment + 1));
    setting.comment.resize(std::min(setting.comment.rfind(')'), setting.comment.size()));
    value = without_blanks(value.substr(0, comment));
  }
  setting.value = value;
  const bool numbered = !setting.name.empty() && setting.name.size() <= 4 &&
                        std::ranges::all_of(setting.name, [](char c) { return c >= '0' && c <= '9'; });
  return numbered || setting.name.starts_with("/axes/") ? std::optional(setting) : std::nullopt;
}

std::size_t recognised_grbl(std::string_view text) {
  std::size_t count = 0;
  for (const ConfigurationLine& line : lines_of(text)) {
    count += grbl_setting(line.text) ? 1 : 0;
  }
  return count > 2 ? count : 0;
}

/// Settings of grbl that have no effect on times of motion, or none on axes X, Y and Z.
bool is_without_effect(int number) {
  constexpr std::array known{0, 2, 3, 4, 5, 6, 10, 13, 20, 21, 22, 23, 24, 25, 26, 27, 30, 31};
  return std::ranges::find(known, number) != known.end() || (number >= 130 && number <= 138);
}

/// Parts of "[OPT:V,15,128]": options, blocks of the planner, bytes of the line buffer.
std::vector<std::string> parts_of(std::string_view text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',' || c == ']' || c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

class GrblReader {
 public:
  explicit GrblReader(MachineDraft draft) : draft_(std::move(draft)) {}

  ImportedMachine read(std::string_view text) {
    for (const ConfigurationLine& line : lines_of(text)) {
      read_line(line);
    }
    Machine& machine = draft_.machine();
    machine.control = firmware_;
    machine.reference =
        fmt::format("{}, listing of the settings of the machine's {}", draft_.file(), firmware_);
    draft_.choose_model({"grbl"});
    complete();
    return draft_.finish(grbl_listing.kind, {5, 0.4, 0});
  }

 private:
  void read_line(const ConfigurationLine& line) {
    const ConfigurationPlace place{line.number, ""};
    find_firmware(line.text);
    if (const std::optional<GrblSetting> setting = grbl_setting(line.text)) {
      read_setting(*setting, place);
    } else if (const std::size_t options = line.text.find("[OPT:"); options != std::string_view::npos) {
      read_options(line.text.substr(options + 1), place);
    } else if (!is_chatter(line.text)) {
      draft_.note(Severity::info, place, "not-understood",
                  message(NC_("core", "'{}' is not a setting; it is skipped"), line.text));
    }
  }

  void find_firmware(std::string_view line) {
    const std::string upper = in_upper_case(line);
    if (upper.find("GRBLHAL") != std::string::npos) {
      firmware_ = "grblHAL";
    } else if (upper.find("FLUIDNC") != std::string::npos) {
      firmware_ = "FluidNC";
    } else if (upper.find("GRBL 0.") != std::string::npos) {
      firmware_ = "grbl 0.9";
    }
  }

  /// Other lines written by the control and by senders.
  static bool is_chatter(std::string_view line) {
    const std::string upper = in_upper_case(line);
    return line.empty() || line.front() == '#' || line.front() == ';' || line.front() == '(' ||
           line.front() == '<' || line.front() == '[' || upper.starts_with("OK") ||
           upper.starts_with("GRBL") || upper.find("$$") != std::string::npos ||
           upper.find("$I") != std::string::npos || upper.find("[MSG") != std::string::npos ||
           upper.find("[VER") != std::string::npos || upper.find("GRBL ") != std::string::npos ||
           upper.starts_with(">>>") || line.starts_with("$N");
  }

  void read_options(std::string_view text, const ConfigurationPlace& place) {
    const std::vector<std::string> parts = parts_of(text);
    constexpr std::size_t at = 2;  // after OPT and the letters
    const GivenValue given{place, fmt::format("[{}: blocks of the planner", text)};
    if (parts.size() > at + 1) {
      if (const std::optional<double> blocks = draft_.number(parts[at], given)) {
        draft_.give("buffer_blocks", *blocks, given);
      }
    }
  }

  void read_setting(const GrblSetting& setting, const ConfigurationPlace& place) {
    note_if_repeated(setting, place);
    if (setting.name.front() == '/') {
      firmware_ = "FluidNC";
      read_path(setting, place);
      return;
    }
    int number = 0;
    std::from_chars(setting.name.data(), setting.name.data() + setting.name.size(), number);
    const GivenValue given{place, given_text(setting)};
    if (number == 0 && setting.comment.find("step/mm") != std::string::npos) {
      draft_.note(Severity::error, place, "old-release",
                  NC_("core", "the settings are numbered as in grbl 0.8 and before, which is not supported"),
                  NC_("core", "update the control, or write its values into a machine file"));
      old_ = true;
    }
    if (!old_) {
      read_number(number, setting, given);
    }
  }

  static std::string given_text(const GrblSetting& setting) {
    return fmt::format("${} = {}", setting.name, setting.value);
  }

  void read_number(int number, const GrblSetting& setting, const GivenValue& given) {
    constexpr int first_axis = 100;
    constexpr int group = 10;  // $100, $110, $120: a group of settings, by axis
    if (number >= first_axis && number < 130) {
      read_axis(number % group, static_cast<std::size_t>((number - first_axis) / group), setting, given);
    } else if (number == 1) {
      give("idle_delay_ms", setting, given, number_of(setting, given) == 255);
    } else if (number == 11) {
      give("junction_deviation_mm", setting, given);
    } else if (number == 12) {
      give("arc_tolerance_mm", setting, given);
    } else if (number == 398) {
      give("buffer_blocks", setting, given);
    } else if (number == 32) {
      if (number_of(setting, given).value_or(0) == 1) {
        draft_.note(
            Severity::warning, given.place, "not-modelled",
            NC_("core",
                "laser mode ($32 = 1) is not modelled: with a laser, changes of S do not stop the motion"));
      }
    } else if (is_without_effect(number)) {
      draft_.leave_out(fmt::format("${}", number));
    } else {
      draft_.note(Severity::info, given.place, "not-understood",
                  NC_("core", "a setting that no model here uses; skipped"));
    }
  }

  std::optional<double> number_of(const GrblSetting& setting, const GivenValue& given) {
    return draft_.number(setting.value, given);
  }

  /// `never`: the motors stay energised, so there is no wait.
  void give(const char* key, const GrblSetting& setting, const GivenValue& given, bool never = false) {
    if (const std::optional<double> value = never ? std::optional(0.0) : number_of(setting, given)) {
      draft_.give(key, *value, given);
    }
  }

  void read_axis(int place, std::size_t group, const GrblSetting& setting, const GivenValue& given) {
    struct Quantity {
      const char* key;
      const char* unit;
      double (*to_unit)(double);  ///< to the unit of the key
    };
    constexpr std::array quantities{Quantity{"steps_per_mm", "steps/mm", units::as_it_is},
                                    Quantity{"velocity", "mm/min", units::to_m},
                                    Quantity{"acceleration", "mm/s2", units::to_m}};
    if (place >= static_cast<int>(known_axes.size())) {
      draft_.note(Severity::info, given.place, "axis-skipped",
                  NC_("core", "axes other than X, Y and Z are not part of the simulation; skipped"));
      return;
    }
    const Quantity& quantity = quantities[group];
    if (const std::optional<double> value = number_of(setting, given)) {
      draft_.give_axis(known_axes[static_cast<std::size_t>(place)].name, quantity.key,
                       quantity.to_unit(*value),
                       {given.place, fmt::format("{} {}", given.what, quantity.unit)});
    }
  }

  /// Reads a path such as "$/axes/x/max_rate_mm_per_min=5000".
  void read_path(const GrblSetting& setting, const ConfigurationPlace& place) {
    const std::array keys{std::string_view("steps_per_mm"), std::string_view("max_rate_mm_per_min"),
                          std::string_view("acceleration_mm_per_sec2")};
    constexpr std::string_view begin = "/axes/";
    const std::string_view rest = std::string_view(setting.name).substr(begin.size());
    const auto key = std::ranges::find(keys, rest.substr(std::min<std::size_t>(2, rest.size())));
    const auto axis = rest.empty() ? std::nullopt : known_axes.find(in_upper_case(rest).front());
    const GivenValue given{place, given_text(setting)};
    if (key == keys.end() || !axis) {
      draft_.note(Severity::info, place, "not-understood",
                  NC_("core", "a setting that no model here uses; skipped"));
      return;
    }
    read_axis(static_cast<int>(*axis), static_cast<std::size_t>(key - keys.begin()), setting, given);
  }

  void note_if_repeated(const GrblSetting& setting, const ConfigurationPlace& place) {
    const auto [before, is_first] = before_.try_emplace(setting.name, std::pair(setting.value, place));
    if (!is_first && before->second.first != setting.value) {
      draft_.note(Severity::warning, place, "given-twice",
                  message(NC_("core", "${} = {}, but {} in {}; {} is used"), setting.name, setting.value,
                          before->second.first, draft_.place_text(before->second.second), setting.value),
                  NC_("core", "remove one of the two"));
      before->second = {setting.value, place};
    }
  }

  /// Fills in defaults of the firmware for settings missing in the listing.
  void complete() {
    const bool is_grbl = firmware_.starts_with("grbl ");
    const auto assume = [&](const char* key, double value, const char* setting) {
      if (!draft_.has(key)) {
        draft_.assume(key, value,
                      fmt::format("{} does not give {}: default of grbl 1.1", draft_.file(), setting));
      }
    };
    assume("junction_deviation_mm", 0.01, "$11");
    assume("arc_tolerance_mm", 0.002, "$12");
    assume("idle_delay_ms", 25, "$1");
    if (!draft_.has("buffer_blocks")) {
      constexpr double of_grbl = 15;
      constexpr double of_others = 100;
      draft_.assume("buffer_blocks", is_grbl ? of_grbl : of_others,
                    is_grbl
                        ? "planner buffer of grbl: 16 blocks, one of which stays empty; $I tells another one"
                        : fmt::format("a longer planner buffer than that of grbl, as {} has; [OPT:...] of $I "
                                      "tells it",
                                      firmware_));
    }
    if (!is_grbl) {
      draft_.note(
          Severity::info, {}, "not-modelled",
          message(
              NC_("core", "{} is simulated as grbl with its values; what it does otherwise is not modelled"),
              firmware_));
    }
  }

  MachineDraft draft_;
  std::string firmware_ = "grbl 1.1";
  bool old_ = false;  ///< numbered as before 0.9
  std::map<std::string, std::pair<std::string, ConfigurationPlace>> before_;
};

ImportedMachine read_grbl(const ConfigurationSource& source, MachineDraft draft) {
  return GrblReader(std::move(draft)).read(source.text);
}

}  // namespace

const ConfigurationFormat grbl_listing{QT_TRANSLATE_NOOP("core", "listing of grbl settings"), recognised_grbl,
                                       read_grbl};

}  // namespace feedscope
