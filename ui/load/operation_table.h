#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <memory>

#include "core/load/load_file.h"
#include "core/program/program.h"

namespace feedscope::ui {

/// How the tools of a program are engaged, a row an operation, to be edited. A wrong value is refused:
/// setData() returns false, refused() says why. Cells with choices have ChoiceDelegate::choices_role.
class OperationTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { tool, lines, teeth, milling, material, first_number };

  explicit OperationTable(QObject* parent = nullptr);

  const LoadSetup& setup() const { return setup_; }
  void set_setup(LoadSetup setup);
  /// Whose tools can be chosen, and whose radii a new operation begins with; may be null.
  void set_program(std::shared_ptr<const Program> program);
  /// An operation of the first tool that has none.
  void add();
  void remove(int row);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  /// By a cell, or an operation that has come or gone.
  void edited();
  void refused(const QString& message);

 private:
  QString text(const Engagement& operation, int column) const;
  QStringList choices(int column) const;
  QStringList tools() const;
  /// The first one, own ones before shipped ones; null if there is none.
  const Material* material_with(const std::string& value, std::string Material::*member) const;
  /// Empty, or why the text is not taken.
  QString take(Engagement& operation, int column, const QString& text) const;
  QString take_number(Engagement& operation, int column, const QString& text) const;

  LoadSetup setup_;
  std::vector<Material> materials_;  ///< shipped ones
  std::shared_ptr<const Program> program_;
};

}  // namespace feedscope::ui
