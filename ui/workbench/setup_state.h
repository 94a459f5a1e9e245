#pragma once

#include <map>
#include <string>

#include "core/analysis/run/run.h"

namespace feedscope::ui {

/// A machine's file with a control model, and changes to them.
///
/// Keys are those of --set: "X.jerk" for an axis limit, "alpha" for a setting. Values are in the key's unit.
class SetupState {
 public:
  explicit SetupState(Setup file) : file_(std::move(file)) {}
  /// `file` with the differences in `asked` as edits. Both have the same model.
  static SetupState between(Setup file, const Setup& asked);

  const Setup& file() const { return file_; }
  /// The setup with all edits.
  Setup setup() const;
  /// Differences from the file.
  const std::map<std::string, SettingValue>& edits() const { return edits_; }
  bool edited(const std::string& key) const { return edits_.contains(key); }

  /// Description of an editable key. Throws InputError for an unknown key.
  SettingSpec spec(const std::string& key) const;
  SettingValue value(const std::string& key) const;
  SettingValue file_value(const std::string& key) const;
  /// Source of the file's number; empty for a fallback of the model.
  Provenance provenance(const std::string& key) const;

  /// Throws InputError with key, value and bound; the file's own value is not stored as an edit.
  void set(const std::string& key, const SettingValue& value);
  /// Sets the contour tolerance [mm], which also replaces the program's. Throws as set().
  void set_tolerance(double tolerance);
  /// Sets another model on the same machine; keeps the edits that it reads.
  void set_model(const ControlModel& model);
  void reset() { edits_.clear(); }
  /// Restores the file's value.
  void reset(const std::string& key) { edits_.erase(key); }
  /// The machine with all edits, including its control settings, and this model as its own.
  Machine machine() const;

  bool operator==(const SetupState& other) const { return file_ == other.file_ && edits_ == other.edits_; }

 private:
  Setup file_;
  std::map<std::string, SettingValue> edits_;
};

/// Key of an axis limit: 'X', "jerk" -> "X.jerk".
std::string axis_key(char axis, const std::string& limit);

}  // namespace feedscope::ui
