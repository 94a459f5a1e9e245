#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>
#include <optional>

#include "ui/workbench/run_list.h"

namespace feedscope::ui {

/// The setup of the current run as the machine editor shows and changes it. Every change can be undone.
class SetupEdit : public QObject {
  Q_OBJECT

 public:
  /// `runs` outlives this.
  explicit SetupEdit(RunList& runs, QObject* parent = nullptr);

  const SetupState& state() const { return runs_.current_item().setup; }
  /// The machine's file with the model; nothing edited.
  const Setup& file() const { return state().file(); }
  /// With all edits.
  Setup setup() const { return state().setup(); }
  /// Of the control [s]; none if its machine file has none.
  std::optional<double> interpolation_period() const;

  /// Whether a change is one of all runs. It is of the current one alone nevertheless where the runs are
  /// compared in what is changed, where the current run is still the same as another one, as a copy is that
  /// is to be changed, and in a run whose model or machine does not take the value.
  void set_for_all(bool all) { for_all_ = all; }
  bool for_all() const { return for_all_; }
  /// Another machine: edits go, but for those in which the runs differ.
  void set_file(const Setup& file);
  /// Another model on the same machine: edits that it reads stay.
  void set_model(const ControlModel& model);
  /// Contour tolerance [mm]. Throws as set().
  void set_tolerance(double tolerance);
  /// Throws InputError naming key, value and bound; nothing changes then.
  void set(const std::string& key, const SettingValue& value);
  /// Back to what the file says, in one step.
  void reset();

  QUndoStack& history() { return runs_.history(); }

 signals:
  void values_changed();
  /// Another run, machine or model: other keys.
  void keys_changed();

 private:
  void follow(std::size_t row, const SetupState& before);
  /// Whether `part` of a setup is the same in all runs that have it, and the current run is no copy.
  bool is_common(const std::function<bool(const SetupState&)>& same_part) const;
  bool same_in_all(const std::string& key) const;
  void put(const SetupState& state, const QString& text);
  void change(const std::function<void(SetupState&)>& change, const QString& text, bool in_all);

  RunList& runs_;
  bool for_all_ = true;
};

}  // namespace feedscope::ui
