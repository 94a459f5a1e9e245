#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>
#include <optional>

#include "ui/workbench/run_list.h"

namespace feedscope::ui {

/// The setup of the current run in the machine editor. Every change can be undone.
class SetupEdit : public QObject {
  Q_OBJECT

 public:
  /// `runs` outlives this.
  explicit SetupEdit(RunList& runs, QObject* parent = nullptr);

  const SetupState& state() const { return runs_.current_item().setup; }
  /// The machine's file with the model, without edits.
  const Setup& file() const { return state().file(); }
  /// The setup with all edits.
  Setup setup() const { return state().setup(); }
  /// Of the control [s]; none if its machine file has none.
  std::optional<double> interpolation_period() const;

  /// Whether a change applies to all runs. It nevertheless applies to the current run only if the runs differ
  /// in the changed value or in this limit of another axis, if the current run equals another one (such as a
  /// copy to be changed), and not to runs whose model or machine does not take the value.
  void set_for_all(bool all) { for_all_ = all; }
  bool for_all() const { return for_all_; }
  /// Sets another machine; discards edits except those in which the runs differ.
  void set_file(const Setup& file);
  /// Sets another model on the same machine; keeps the edits that it reads.
  void set_model(const ControlModel& model);
  /// Sets the contour tolerance [mm]. Throws as set().
  void set_tolerance(double tolerance);
  /// Throws InputError with key, value and bound; nothing changes then.
  void set(const std::string& key, const SettingValue& value);
  /// Restores the file's values, in one step.
  void reset();

  QUndoStack& history() { return runs_.history(); }

 signals:
  void values_changed();
  /// The run, machine or model has changed, and the keys with it.
  void keys_changed();

 private:
  void follow(std::size_t row, const SetupState& before);
  /// Whether `part` of a setup is equal in all runs that have it, and the current run is not a copy.
  bool is_common(const std::function<bool(const SetupState&)>& same_part) const;
  bool same_in_all(const std::string& key) const;
  void put(const SetupState& state, const QString& text);
  void change(const std::function<void(SetupState&)>& change, const QString& text, bool in_all);

  RunList& runs_;
  bool for_all_ = true;
};

}  // namespace feedscope::ui
