#include "core/machine/import/marlin_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "core/base/translatable.h"
#include "core/base/units.h"
#include "core/machine/import/machine_draft.h"

namespace feedscope {
namespace {

constexpr std::array report_codes{"M92", "M201", "M203", "M204", "M205", "M566"};

/// Command such as "M203 X500 Y500" after a prefix of firmware or host such as "Recv: echo:  ".
struct ReportedCommand {
  std::string code;
  std::vector<std::string_view> words;  ///< after the code
};

bool is_code(std::string_view word) {
  return word.size() > 1 && word.size() < 6 && (word.front() == 'M' || word.front() == 'G') &&
         std::ranges::all_of(word.substr(1), [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
}

std::optional<ReportedCommand> reported_command(std::string_view line) {
  line = line.substr(0, line.find(';'));
  if (const std::size_t echo = line.rfind("echo:"); echo != std::string_view::npos) {
    line = line.substr(echo + 5);
  }
  std::vector<std::string_view> words = words_of_line(line);
  const auto code = std::ranges::find_if(words, is_code);
  if (code == words.end()) {
    return std::nullopt;
  }
  ReportedCommand command{std::string(*code), {}};
  command.words.assign(code + 1, words.end());
  return command;
}

std::size_t recognised_report(std::string_view text) {
  std::set<std::string> codes;
  std::size_t count = 0;
  for (const ConfigurationLine& line : lines_of(text)) {
    const std::optional<ReportedCommand> command = reported_command(line.text);
    if (!command) {
      continue;
    }
    constexpr std::array motions{"G0", "G1", "G2", "G3", "G00", "G01", "G02", "G03"};
    if (std::ranges::find(motions, command->code) != motions.end()) {
      return 0;  // a program that sets limits
    }
    if (std::ranges::find(report_codes, command->code) != report_codes.end()) {
      codes.insert(command->code);
      ++count;
    }
  }
  return codes.size() > 1 ? count : 0;
}

class MarlinReader {
 public:
  explicit MarlinReader(MachineDraft draft) : draft_(std::move(draft)) {}

  ImportedMachine read(std::string_view text) {
    for (const ConfigurationLine& line : lines_of(text)) {
      read_line(line);
    }
    const bool is_duet = find("M566", 'X') != nullptr || find("M566", 'Y') != nullptr;
    Machine& machine = draft_.machine();
    machine.control = is_duet ? "RepRapFirmware" : "Marlin";
    machine.reference = fmt::format("{}, settings of the machine's {}", draft_.file(), machine.control);
    draft_.choose_model({"klipper", "grbl"});
    read_velocities(is_duet);
    read_accelerations();
    read_corners(is_duet);
    assume_rest();
    for (const auto& [name, value] : values_) {
      if (!value.used) {
        draft_.leave_out(fmt::format("{} {}", name.first, name.second));
      }
    }
    return draft_.finish(marlin_report.kind, {9, 1, 0});
  }

 private:
  struct Value {
    double number;
    GivenValue given;
    bool used = false;
  };

  void read_line(const ConfigurationLine& line) {
    const std::optional<ReportedCommand> command = reported_command(line.text);
    if (!command) {
      return;  // headings and output of hosts
    }
    if (command->code == "G20" || command->code == "G21") {
      unit_ = command->code == "G20" ? units::from_inch(1) : 1;
      return;
    }
    if (std::ranges::find(report_codes, command->code) == report_codes.end()) {
      draft_.leave_out(command->code);  // temperatures, drivers, levelling
      return;
    }
    for (const std::string_view word : command->words) {
      read_word(command->code, word, {line.number, ""});
    }
  }

  void read_word(const std::string& code, std::string_view word, const ConfigurationPlace& place) {
    const char letter = in_upper_case(word).front();
    if (letter < 'A' || letter > 'Z') {
      draft_.note(Severity::info, place, "not-understood",
                  message(NC_("core", "{}: '{}' is not a value; it is skipped"), code, word));
      return;
    }
    if (letter == 'E') {
      draft_.leave_out(code + " E");
      return;
    }
    const GivenValue given{place, fmt::format("{} {}{}", code, unit_ == 1 ? "" : "[inch] ", word)};
    const std::optional<double> number = draft_.number(word.substr(1), given);
    if (!number) {
      return;
    }
    const bool is_time = code == "M205" && (letter == 'B' || letter == 'S' || letter == 'T');
    const Value value{is_time ? *number : *number * unit_, given};
    const auto [before, is_first] = values_.try_emplace({code, letter}, value);
    if (!is_first && before->second.number != value.number) {
      draft_.note(Severity::warning, place, "given-twice",
                  message(NC_("core", "{}, but {} in {}; {} is used"), given.what, before->second.given.what,
                          draft_.place_text(before->second.given.place), word),
                  NC_("core", "remove one of the two"));
    }
    before->second = value;
  }

  const Value* find(const std::string& code, char letter) {
    const auto found = values_.find({code, letter});
    if (found == values_.end()) {
      return nullptr;
    }
    found->second.used = true;
    return &found->second;
  }

  /// Smaller one of the values of X and Y; null if there is none.
  const Value* least_of_plane(const std::string& code) {
    const Value* x = find(code, 'X');
    const Value* y = find(code, 'Y');
    return x == nullptr || (y != nullptr && y->number < x->number) ? y : x;
  }

  void read_velocities(bool is_duet) {
    const auto in_m_min = [&](const Value& value) {
      return is_duet ? units::to_m(value.number) : units::to_m_min(value.number);
    };
    const char* unit = is_duet ? " mm/min" : " mm/s";
    for (const AxisInfo& axis : known_axes) {
      if (const Value* value = find("M203", axis.name)) {
        draft_.give_axis(axis.name, "velocity", in_m_min(*value),
                         {value->given.place, value->given.what + unit});
      }
    }
    if (const Value* value = least_of_plane("M203")) {
      draft_.give("max_velocity_m_min", in_m_min(*value), {value->given.place, value->given.what + unit});
    }
    if (const Value* value = find("M203", 'Z')) {
      draft_.give("max_z_velocity_m_min", in_m_min(*value), {value->given.place, value->given.what + unit});
    }
  }

  void read_accelerations() {
    for (const AxisInfo& axis : known_axes) {
      if (const Value* value = find("M201", axis.name)) {
        draft_.give_axis(axis.name, "acceleration", units::to_m(value->number),
                         {value->given.place, value->given.what + " mm/s2"});
      }
    }
    if (const Value* value = find("M201", 'Z')) {
      draft_.give("max_z_acceleration_m_s2", units::to_m(value->number),
                  {value->given.place, value->given.what + " mm/s2"});
    }
    path_ = find("M204", 'P');
    path_ = path_ == nullptr ? find("M204", 'S') : path_;
    const Value* plane = least_of_plane("M201");
    if (path_ != nullptr && plane != nullptr && plane->number < path_->number) {
      draft_.note(Severity::warning, path_->given.place, "limits-contradict",
                  message(NC_("core", "{} exceeds {} ({}); the lower one is used"), path_->given.what,
                          plane->given.what, draft_.place_text(plane->given.place)));
      path_ = plane;
    }
    path_ = path_ == nullptr ? plane : path_;
    if (path_ != nullptr) {
      draft_.give("max_acceleration_m_s2", units::to_m(path_->number),
                  {path_->given.place, path_->given.what + " mm/s2"});
    }
    const Value* travel = find("M204", 'T');
    if (travel != nullptr && path_ != nullptr && travel->number != path_->number) {
      draft_.note(
          Severity::info, travel->given.place, "not-modelled",
          message(
              NC_("core", "acceleration of travel moves {} is not modelled: they have that of the others"),
              travel->given.what));
    }
  }

  /// Junction deviation or the older jerk setting (a jump of velocity), as the equivalent square corner
  /// velocity at 90 degrees: with a deviation d and an acceleration a, v^2 = a d s/(1 - s), s = sin 45
  /// degrees, or a d/(sqrt 2 - 1).
  void read_corners(bool is_duet) {
    const char* key = "square_corner_velocity_mm_s";
    const Value* deviation = find("M205", 'J');
    const Value* jump = least_of_plane(is_duet ? "M566" : "M205");
    if (deviation != nullptr && deviation->number > 0 && path_ != nullptr && path_->number > 0) {
      draft_.assume(
          key, std::sqrt(path_->number * deviation->number / (std::numbers::sqrt2 - 1)),
          fmt::format("{}: junction deviation {}, as the corner of 90 degrees is as fast with {}",
                      draft_.place_text(deviation->given.place), deviation->given.what, path_->given.what));
    } else if (jump != nullptr && jump->number >= 0) {
      constexpr double minute = 60;  // [s]
      draft_.assume(
          key, is_duet ? jump->number / minute : jump->number,
          fmt::format("{}: {} {}, reached in a corner of 90 degrees; other corners differ",
                      draft_.place_text(jump->given.place), jump->given.what, is_duet ? "mm/min" : "mm/s"));
    } else {
      draft_.assume(key, 5.0, fmt::format("{} gives no usable junction deviation or jump", draft_.file()));
    }
  }

  void assume_rest() {
    const std::string& control = draft_.machine().control;
    draft_.assume("minimum_cruise_ratio", 0.0,
                  fmt::format("{} keeps no part of a way for constant speed", control));
    draft_.assume("arc_resolution_mm", 1.0, "default of Marlin: longest chord of an arc");
    draft_.assume("refuse", "off", fmt::format("{} keeps G words modal, unlike Klipper", control));
    draft_.note(
        Severity::warning, {}, "not-modelled",
        message(NC_("core",
                    "there is no model of {}: Klipper's runs its limits; its look-ahead has no end, while "
                    "that of the firmware has some 16 blocks, so that short blocks may take longer there"),
                control));
  }

  MachineDraft draft_;
  double unit_ = 1;  ///< [mm]
  std::map<std::pair<std::string, char>, Value> values_;
  const Value* path_ = nullptr;  ///< acceleration along the path
};

ImportedMachine read_marlin(const ConfigurationSource& source, MachineDraft draft) {
  return MarlinReader(std::move(draft)).read(source.text);
}

}  // namespace

const ConfigurationFormat marlin_report{QT_TRANSLATE_NOOP("core", "listing of Marlin settings"),
                                        recognised_report, read_marlin};

}  // namespace feedscope
