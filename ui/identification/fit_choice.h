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

/// Which control models are fitted, the machine that is begun with, and the numbers that are to be found:
/// those that are usual for the models, unless ticks say otherwise.
class FitChoice : public QWidget {
  Q_OBJECT

 public:
  /// `workbench` outlives this.
  explicit FitChoice(Workbench& workbench, QWidget* parent = nullptr);

  /// One a model that is ticked.
  const std::vector<IdentificationStart>& starts() const { return starts_; }
  /// Why there are none, for the user; empty: there are, or nothing is ticked.
  QString problem() const { return problem_; }
  /// The run that is begun with stays, whichever becomes the current one.
  void hold_run();
  /// The current run is begun with again.
  void follow_current_run();
  FitChoiceState state() const;
  /// A run that is not there any more: the current one.
  void set_state(const FitChoiceState& state);
  /// The axes whose set and actual positions are recorded: their drives can be found, too.
  void set_recorded_drives(const std::string& axes);
  /// Offers the machines that there are now.
  void read_machines();

  QComboBox& machines() { return *machines_; }
  QListWidget& models() { return *models_; }
  QTreeWidget& parameters() { return *parameters_; }
  /// In the order in which Tab goes through them.
  QList<QWidget*> keyboard_way() const { return keyboard_way_; }
  /// Ticks those that are usual again, or none.
  void tick_usual();
  void tick_none();

 signals:
  void changed();

 protected:
  /// The wheel scrolls the panel, and does not choose machines on its way.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void list_machines();
  void follow_runs();
  void choose_machine(int index);
  void refresh();
  void list_parameters();
  /// What can be found on a setup; `usual`: of these what is found unasked.
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
  std::map<std::string, bool> wanted_;  ///< keys that the user has ticked or not
  std::string recorded_drives_;         ///< names of axes
  std::vector<IdentificationStart> starts_;
  QString problem_;
  std::vector<MachineChoice> choices_;
};

}  // namespace feedscope::ui
