#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "ui/workbench/setup_edit.h"

namespace feedscope::ui {

/// A table over values of a SetupEdit. A wrong value is refused: setData() returns false, refused() says why.
///
/// Numbers are shown with the locale's decimal sign; point and comma are both read. Edited values are bold,
/// assumed ones in italics; the tool tip explains a value and names its source.
///
/// A table shows the state it was last told of: whoever hears of a change first may make a view ask for cells
/// (a field that is disabled passes the focus on) before the table itself has heard.
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
  /// Key of the value in a cell; none for cells that only explain.
  virtual std::optional<std::string> key_at(const QModelIndex& index) const = 0;
  /// Key that the whole row, or else the cell, is about.
  virtual std::string topic_of(const QModelIndex& index) const = 0;
  virtual QString caption(const QModelIndex& index) const = 0;
  virtual void reload() = 0;
  QString explanation(const std::string& key) const;

  SetupEdit& edit_;
  SetupState state_;
};

/// What differs from the machine file, a line each: "X Jerk: 15 → 20 m/s³".
QStringList changes_of(const SetupState& state);

/// What axes have: a row a key of `specs`, a column an axis.
class AxisTable : public SetupTable {
  Q_OBJECT

 public:
  /// `specs`: of axis_specs(), its limits or its drives; outlives this.
  AxisTable(SetupEdit& edit, const std::vector<SettingSpec>& specs, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Cell of a key such as "X.jerk"; invalid if it is not here.
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

/// Settings that the chosen model reads: title, value, unit, range.
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
  /// Whether a setting of a row may be without a value, and is.
  bool is_unset(int row) const;

 private:
  std::optional<std::string> key_at(const QModelIndex& index) const override;
  std::string topic_of(const QModelIndex& index) const override;
  QString caption(const QModelIndex& index) const override;
  void reload() override;

  std::vector<SettingSpec> specs_;
};

}  // namespace feedscope::ui
