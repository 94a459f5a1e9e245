#pragma once

#include <QList>
#include <QString>
#include <QWidget>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ui/identification/identification_state.h"
#include "ui/workbench/workbench.h"

class QComboBox;
class QListWidget;
class QTreeWidget;
class QTreeWidgetItem;

namespace feedscope::ui {

/// Choice of the control models to fit, the initial machine, and the numbers to identify: the usual ones of
/// the models, unless ticks select others.
class FitChoice : public QWidget {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit FitChoice(Workbench& workbench, QWidget* parent = nullptr);

  /// One for each ticked model.
  const std::vector<IdentificationStart>& starts() const { return starts_; }
  /// Reason why there are none, for the user; empty if there are, or nothing is ticked.
  QString problem() const { return problem_; }
  /// Keeps the initial run when another one becomes current.
  void hold_run();
  /// Starts from the current run again.
  void follow_current_run();
  FitChoiceState state() const;
  /// Replaces a run that no longer exists by the current one.
  void set_state(const FitChoiceState& state);
  /// The axes with recorded set and actual positions: their drives can be identified, too.
  void set_recorded_drives(const std::string& axes);
  /// Updates the list of machines.
  void read_machines();

  QComboBox& machines() { return *machines_; }
  QListWidget& models() { return *models_; }
  QTreeWidget& parameters() { return *parameters_; }
  /// In tab order.
  QList<QWidget*> keyboard_way() const { return keyboard_way_; }
  /// Ticks the usual numbers again, or none.
  void tick_usual();
  void tick_none();

 signals:
  void changed();

 protected:
  /// Lets the wheel scroll the panel instead of changing the machine under the pointer.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void list_machines();
  void follow_runs();
  void choose_machine(int index);
  void refresh();
  void list_parameters();
  /// Numbers that can be identified on a setup; `usual`: only those that are by default.
  std::vector<FitParameter> offered(const Setup& setup, bool usual) const;
  void fit_heights();
  std::vector<std::string> ticked_models() const;
  Setup setup_of(const std::string& model) const;
  bool is_wanted(const std::string& key, bool usual) const;
  std::size_t begun_row() const;

  Workbench& workbench_;
  QComboBox* machines_;
  QListWidget* models_;
  QTreeWidget* parameters_;
  QList<QWidget*> keyboard_way_;
  int held_run_ = 0;                    ///< id of a run; 0: the current one
  QString machine_;                     ///< key of a machine; empty: a run
  bool typical_ = false;                ///< a typical machine of each model
  bool own_models_ = false;             ///< ticked by the user
  std::map<std::string, bool> wanted_;  ///< keys that the user has ticked or unticked
  std::string recorded_drives_;         ///< names of axes
  std::vector<IdentificationStart> starts_;
  QString problem_;
  std::vector<MachineChoice> choices_;
};

}  // namespace feedscope::ui
