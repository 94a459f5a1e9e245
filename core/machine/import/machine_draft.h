#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/machine/import/configuration_words.h"
#include "core/machine/import/machine_import.h"

namespace feedscope {

/// A value as a configuration gives it.
struct GivenValue {
  ConfigurationPlace place;
  std::string what;  ///< name, value and unit as they stand there: "[AXIS_X] MAX_VELOCITY = 5 inch/s"
};

/// What a machine of a kind usually has, where its configuration does not say it; `control` for the reasons.
struct UsualLimits {
  double velocity = 0;      ///< [m/min]
  double acceleration = 0;  ///< [m/s2]
  double jerk = 0;          ///< [m/s3]; 0: the control limits none
};

/// A machine under way: values with their sources, and notes on what is wrong with them. All values are in
/// the units of their keys, as in axis_specs() and the specs of settings.
class MachineDraft {
 public:
  /// `file`: what sources and messages call the file. `model_settings`: as for read_machine().
  MachineDraft(std::string file, const std::vector<SettingSpec>& model_settings);

  /// For id, name, control and reference.
  Machine& machine() { return imported_.machine; }
  const std::string& file() const { return file_; }
  /// The first of these models that is known becomes the machine's.
  void choose_model(const std::vector<std::string>& ids);

  /// A value of an axis. One that is out of bounds is an error in the notes and is not used.
  void give_axis(char axis, std::string_view key, double value, const GivenValue& given);
  void assume_axis(char axis, std::string_view key, double value, const std::string& reason);
  bool has_axis(char axis, std::string_view key) const;
  /// The value of an axis in its unit; 0 if it has none.
  double axis(char axis, std::string_view key) const;
  /// A setting; one that no model has is not used.
  void give(std::string_view key, const SettingValue& value, const GivenValue& given);
  void assume(std::string_view key, const SettingValue& value, const std::string& reason);
  bool has(std::string_view key) const { return imported_.machine.settings.has(key); }

  /// A number of the configuration; what is none is an error in the notes.
  std::optional<double> number(std::string_view text, const GivenValue& given);
  void note(Severity severity, const ConfigurationPlace& place, const char* code, Message what,
            Message hint = {});
  /// A value of the file that nothing here uses; finish() lists all of them in one note.
  void leave_out(const std::string& name);
  /// "my.ini, line 5": for messages that speak of a second place.
  std::string place_text(const ConfigurationPlace& place) const;

  /// Assumes what is missing: of an axis as another one, else as usual.
  ImportedMachine finish(std::string kind, const UsualLimits& usual);

 private:
  const SettingSpec* find_setting(std::string_view key) const;
  bool is_within(const SettingSpec& spec, const SettingValue& value, const GivenValue& given);
  void fill(std::string_view key, double usual);
  void fill_jerk(const UsualLimits& usual);
  void list_what_is_left_out();
  /// In the order of the files; the last one stands for those beyond 200.
  void close_notes();

  std::string file_;
  std::vector<SettingSpec> specs_;
  ImportedMachine imported_;
  std::vector<std::string> left_out_;  ///< each once
};

}  // namespace feedscope
