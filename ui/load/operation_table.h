#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <memory>

#include "core/load/load_file.h"
#include "core/program/program.h"

namespace feedscope::ui {

/// Engagement of a program's tools, one row for each operation, editable. A wrong value is refused: setData()
/// returns false, and refused() emits the reason. Cells with choices have ChoiceDelegate::choices_role.
class OperationTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { tool, lines, teeth, milling, material, first_number };

  explicit OperationTable(QObject* parent = nullptr);

  const LoadSetup& setup() const { return setup_; }
  void set_setup(LoadSetup setup);
  /// Program whose tools can be chosen, and whose radii new operations have; may be null.
  void set_program(std::shared_ptr<const Program> program);
  /// Adds an operation of the first tool without one.
  void add();
  void remove(int row);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  /// A cell has changed, or an operation was added or removed.
  void edited();
  void refused(const QString& message);

 private:
  QString text(const Engagement& operation, int column) const;
  QStringList choices(int column) const;
  QStringList tools() const;
  /// The first match, the user's materials before shipped ones; null if there is none.
  const Material* material_with(const std::string& value, std::string Material::*member) const;
  /// Empty, or the reason why the text is refused.
  QString take(Engagement& operation, int column, const QString& text) const;
  QString take_number(Engagement& operation, int column, const QString& text) const;

  LoadSetup setup_;
  std::vector<Material> materials_;  ///< shipped
  std::shared_ptr<const Program> program_;
};

}  // namespace feedscope::ui
