#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/machine/import/configuration_words.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// A value from a configuration.
struct GivenValue {
  ConfigurationPlace place;
  std::string what;  ///< name, value and unit as written: "[AXIS_X] MAX_VELOCITY = 5 inch/s"
};

/// Usual limits of a kind of machine, for values missing in its configuration; `control` for the reasons.
struct UsualLimits {
  double velocity = 0;      ///< [m/min]
  double acceleration = 0;  ///< [m/s2]
  double jerk = 0;          ///< [m/s3]; 0: the control has no jerk limit
};

/// A machine under construction: values with their sources, and notes on problems with them. All values are
/// in the units of their keys, as in axis_specs() and the specs of settings.
class MachineDraft {
 public:
  /// `file`: name of the file in sources and messages. `model_settings`: as for read_machine().
  MachineDraft(std::string file, const std::vector<SettingSpec>& model_settings);

  /// For id, name, control and reference.
  Machine& machine() { return imported_.machine; }
  const std::string& file() const { return file_; }
  /// Selects the first known one of these models.
  void choose_model(const std::vector<std::string>& ids);

  /// Sets a value of an axis. A value out of bounds is an error in the notes and is not used.
  void give_axis(char axis, std::string_view key, double value, const GivenValue& given);
  void assume_axis(char axis, std::string_view key, double value, const std::string& reason);
  bool has_axis(char axis, std::string_view key) const;
  /// Value of an axis in its unit; 0 if it has none.
  double axis(char axis, std::string_view key) const;
  /// Sets a setting; one that no model has is not used.
  void give(std::string_view key, const SettingValue& value, const GivenValue& given);
  void assume(std::string_view key, const SettingValue& value, const std::string& reason);
  bool has(std::string_view key) const { return imported_.machine.settings.has(key); }

  /// Parses a number of the configuration; an invalid one is an error in the notes.
  std::optional<double> number(std::string_view text, const GivenValue& given);
  void note(Severity severity, const ConfigurationPlace& place, const char* code, Message what,
            Message hint = {});
  /// Records an unused value of the file; finish() lists all of them in one note.
  void leave_out(const std::string& name);
  /// Place as text for messages about a second place: "my.ini, line 5".
  std::string place_text(const ConfigurationPlace& place) const;

  /// Assumes missing values: those of another axis, else the usual ones.
  ImportedMachine finish(std::string kind, const UsualLimits& usual);

 private:
  const SettingSpec* find_setting(std::string_view key) const;
  bool is_within(const SettingSpec& spec, const SettingValue& value, const GivenValue& given);
  void fill(std::string_view key, double usual);
  void fill_jerk(const UsualLimits& usual);
  void list_what_is_left_out();
  /// Sorts the notes in the order of the files; the last one replaces those beyond 200.
  void close_notes();

  std::string file_;
  std::vector<SettingSpec> specs_;
  ImportedMachine imported_;
  std::vector<std::string> left_out_;  ///< without duplicates
};

}  // namespace feedscope
