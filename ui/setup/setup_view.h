#pragma once

#include "core/analysis/notes/remarks.h"
#include "ui/setup/setup_tables.h"
#include "ui/workbench/panel.h"

class QLabel;
class QTableView;
class QToolButton;

namespace feedscope::ui {

/// The machine editor: axis limits and settings of the chosen model. A wrong entry is refused, with the
/// reason below the tables, where the meaning and the source of the chosen value also appear.
class SetupView : public Panel {
  Q_OBJECT

 public:
  /// `edit` outlives this.
  explicit SetupView(SetupEdit& edit, QWidget* parent = nullptr);

  void follow(Workbench& workbench) override;
  /// Whether changes apply to all runs or to the current one; shared by all editors.
  QAction* for_all() const { return for_all_; }
  QTableView* axes() { return axes_; }
  QTableView* drives() { return drives_; }
  QTableView* settings() { return settings_; }
  QToolButton* show_drives() { return show_drives_; }
  QToolButton* unset() { return unset_; }
  /// The meaning of the chosen value, or the reason why an entry was refused.
  QString message() const;
  /// Goes to the cell of a key, as of --set; ignores an unknown key.
  void show_key(const std::string& key);
  /// Differences from the machine file; empty if there are none.
  QString changes() const;
  /// Parts of the program that the model does not follow; empty: none.
  void show_remarks(const std::vector<Remark>& remarks);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void explain(const QModelIndex& index);
  void refuse(QTableView* table, const QModelIndex& index, const QString& message);
  void fit_tables();
  void fit_type();
  void fit_settings();
  void fit_names();
  void show_changes();
  static QString unset_tip(bool has_rotary_axes);
  void hide_unset();
  void hide_drives();

  void show_scope(std::size_t runs);

  SetupEdit& edit_;
  QAction* for_all_;
  QToolButton* scope_;
  AxisTable* axis_model_;
  AxisTable* drive_model_;
  SettingsTable* settings_model_;
  QLabel* machine_;
  QLabel* remarks_;
  QTableView* axes_;
  QTableView* drives_;
  QTableView* settings_;
  QToolButton* show_drives_;  ///< shows drives even if no axis has one
  QToolButton* unset_;        ///< shows settings without a value
  QLabel* help_;
  QLabel* changes_;
  QPersistentModelIndex explained_;
};

}  // namespace feedscope::ui
