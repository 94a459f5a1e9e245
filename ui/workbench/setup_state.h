#pragma once

#include <map>
#include <string>

#include "core/analysis/run.h"

namespace feedscope::ui {

/// A machine's file with a control model, and what has been changed on top of them.
///
/// Keys are those of --set: "X.jerk" for an axis limit, "alpha" for a setting. Values are in the key's unit.
class SetupState {
 public:
  explicit SetupState(Setup file) : file_(std::move(file)) {}
  /// `file` with what differs in `asked` as edits. Both have the same model.
  static SetupState between(Setup file, const Setup& asked);

  const Setup& file() const { return file_; }
  /// With all edits.
  Setup setup() const;
  /// What differs from the file.
  const std::map<std::string, SettingValue>& edits() const { return edits_; }
  bool edited(const std::string& key) const { return edits_.contains(key); }

  /// What can be said of a key that can be edited. Throws InputError for an unknown key.
  SettingSpec spec(const std::string& key) const;
  SettingValue value(const std::string& key) const;
  SettingValue file_value(const std::string& key) const;
  /// Source of the file's number; empty where the model's fallback stands.
  Provenance provenance(const std::string& key) const;

  /// Throws InputError naming key, value and bound; the file's own value is no edit.
  void set(const std::string& key, const SettingValue& value);
  /// Contour tolerance [mm], in place of the program's own too. Throws as set().
  void set_tolerance(double tolerance);
  /// Another model on the same machine: edits that it reads stay.
  void set_model(const ControlModel& model);
  void reset() { edits_.clear(); }
  /// The file's own value again.
  void reset(const std::string& key) { edits_.erase(key); }
  /// The machine with all edits, its control settings among them, and the model as its own.
  Machine machine() const;

  bool operator==(const SetupState& other) const { return file_ == other.file_ && edits_ == other.edits_; }

 private:
  Setup file_;
  std::map<std::string, SettingValue> edits_;
};

/// Key of an axis limit: 'X', "jerk" -> "X.jerk".
std::string axis_key(char axis, const std::string& limit);

}  // namespace feedscope::ui
