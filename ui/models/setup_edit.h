#pragma once

#include <QObject>
#include <QUndoStack>
#include <map>
#include <string>

#include "core/analysis/run.h"

namespace feedscope::ui {

/// Machine and control settings of the run, as edited on top of what the machine's file says.
///
/// Keys are those of --set: "X.jerk" for an axis limit, "alpha" for a setting. Values are in the key's unit.
class SetupEdit : public QObject {
  Q_OBJECT

 public:
  explicit SetupEdit(Setup file, QObject* parent = nullptr);

  /// Another machine: edits and history go.
  void set_file(Setup file);
  /// Another model on the same machine: edits that it reads stay, the history goes.
  void set_model(const ControlModel& model);

  const Setup& file() const { return file_; }
  /// With all edits.
  Setup setup() const;

  /// Specs of the keys that can be edited. Throws InputError for an unknown key.
  SettingSpec spec(const std::string& key) const;
  SettingValue value(const std::string& key) const;
  SettingValue file_value(const std::string& key) const;
  bool edited(const std::string& key) const { return edits_.contains(key); }
  /// Source of the file's number; empty where the model's fallback stands.
  Provenance provenance(const std::string& key) const;

  /// Undoable. Throws InputError naming key, value and bound; nothing changes then.
  void set(const std::string& key, const SettingValue& value);
  QUndoStack& history() { return history_; }

 signals:
  void values_changed();
  /// Another machine or model: other keys.
  void keys_changed();

 private:
  class Edit;
  void put(const std::string& key, const SettingValue& value);

  Setup file_;
  std::map<std::string, SettingValue> edits_;  ///< what differs from the file
  QUndoStack history_;
};

/// Key of an axis limit: 'X', "jerk" -> "X.jerk".
std::string axis_key(char axis, const std::string& limit);

}  // namespace feedscope::ui
