#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <memory>
#include <vector>

#include "core/program/program.h"
#include "ui/messages/diagnostic_rows.h"
#include "ui/shared/text_place.h"

namespace feedscope::ui {

/// Reader's messages on a program, as diagnostic_rows(), then messages of the application. Messages on
/// subprogram files follow those on the program.
class DiagnosticsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { place, message, hint, columns };
  enum Role {
    severity_role = Qt::UserRole,  ///< int of a Severity
    line_role,                     ///< uint, in the program's own text; 0: none
    byte_role,                     ///< uint, 1-based column; 0: the line as a whole
  };

  using QAbstractTableModel::QAbstractTableModel;

  /// Replaces all entries; null: none.
  void set_program(std::shared_ptr<const Program> program);
  void add_message(Severity severity, const QString& text);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  const Diagnostic& at(int row) const;
  QString message_text(int row) const;
  static QString place_text(const Diagnostic& diagnostic);

  std::shared_ptr<const Program> program_;
  std::vector<DiagnosticRow> rows_;  ///< of the program's diagnostics
  std::vector<Diagnostic> messages_;
};

/// Omits messages below the chosen severity.
class DiagnosticsFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;

  void set_least(Severity severity);
  /// The row after (or before) a place in the program that has a line, around the ends; -1 if no row has one.
  /// From a row on the place's own line, the row next to that one.
  int next_row(int row, TextPlace place, bool forward) const;

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  TextPlace place_of(int row) const;

  Severity least_ = Severity::info;
};

}  // namespace feedscope::ui
