#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "ui/workbench/setup_edit.h"

namespace feedscope::ui {

/// A table of values in a SetupEdit. A wrong value is refused: setData() returns false, and refused() emits
/// the reason.
///
/// Numbers have the locale's decimal sign; input accepts point and comma. Edited values are bold, assumed
/// ones in italics; the tooltip explains a value and its source.
///
/// A table shows the last state that it has received: an earlier receiver of a change may make a view request
/// cells (a field that is disabled passes the focus on) before the table has been notified.
class SetupTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  /// `edit` outlives this.
  explicit SetupTable(SetupEdit& edit, QObject* parent = nullptr);

  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  void refused(const QModelIndex& index, const QString& message);

 protected:
  const SetupState& state() const { return state_; }

 private:
  /// Key of the value in a cell; none for cells with explanations only.
  virtual std::optional<std::string> key_at(const QModelIndex& index) const = 0;
  /// Key that the whole row, or else the cell, belongs to.
  virtual std::string topic_of(const QModelIndex& index) const = 0;
  virtual QString caption(const QModelIndex& index) const = 0;
  virtual void reload() = 0;
  QString explanation(const std::string& key) const;

  SetupEdit& edit_;
  SetupState state_;
};

/// Differences from the machine file, one line each: "X Jerk: 15 → 20 m/s³".
QStringList changes_of(const SetupState& state);

/// Values of axes: a row for each key of `specs`, a column for each axis.
class AxisTable : public SetupTable {
  Q_OBJECT

 public:
  /// `specs`: of axis_specs(), its limits or its drives; outlives this.
  AxisTable(SetupEdit& edit, const std::vector<SettingSpec>& specs, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Cell of a key such as "X.jerk"; invalid if it is not in this table.
  QModelIndex index_of(const std::string& key) const;
  /// Whether any cell has a value.
  bool has_values() const;

 private:
  const AxisList& axes() const;
  std::optional<std::string> key_at(const QModelIndex& index) const override;
  std::string topic_of(const QModelIndex& index) const override;
  QString caption(const QModelIndex&) const override { return {}; }
  void reload() override {}

  const std::vector<SettingSpec>& specs_;
};

/// Settings of the chosen model: title, value, unit, range.
class SettingsTable : public SetupTable {
  Q_OBJECT

 public:
  enum Column { title, value, unit, range, columns };

  explicit SettingsTable(SetupEdit& edit, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Row of a setting, -1 if the model does not read it.
  int row_of(const std::string& key) const;
  /// Whether a setting of a row is optional and has no value.
  bool is_unset(int row) const;

 private:
  std::optional<std::string> key_at(const QModelIndex& index) const override;
  std::string topic_of(const QModelIndex& index) const override;
  QString caption(const QModelIndex& index) const override;
  void reload() override;

  std::vector<SettingSpec> specs_;
};

}  // namespace feedscope::ui
