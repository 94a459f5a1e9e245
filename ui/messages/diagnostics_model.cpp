#include "ui/messages/diagnostics_model.h"

#include <QLocale>
#include <algorithm>
#include <utility>

#include "ui/language/in_language.h"

namespace feedscope::ui {

void DiagnosticsModel::set_program(std::shared_ptr<const Program> program) {
  beginResetModel();
  program_ = std::move(program);
  messages_.clear();
  rows_ = program_ == nullptr ? std::vector<DiagnosticRow>() : diagnostic_rows(program_->diagnostics);
  endResetModel();
}

void DiagnosticsModel::add_message(Severity severity, const QString& text) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.message = Message::as_written(text.toStdString());
  const int row = rowCount();
  beginInsertRows({}, row, row);
  messages_.push_back(std::move(diagnostic));
  endInsertRows();
}

int DiagnosticsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size() + messages_.size());
}

int DiagnosticsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

const Diagnostic& DiagnosticsModel::at(int row) const {
  const auto i = static_cast<std::size_t>(row);
  return i < rows_.size() ? program_->diagnostics[rows_[i].index] : messages_[i - rows_.size()];
}

QString DiagnosticsModel::place_text(const Diagnostic& diagnostic) {
  if (diagnostic.line == 0) {
    return {};
  }
  QStringList parts;
  if (!diagnostic.file.empty()) {
    parts.append(QString::fromStdString(diagnostic.file).section('/', -1));
  }
  parts.append(QString::number(diagnostic.line));
  if (diagnostic.column > 0) {
    parts.append(QString::number(diagnostic.column));
  }
  return parts.join(':');
}

QString DiagnosticsModel::message_text(int row) const {
  const QString text = in_language(at(row).message);
  const auto i = static_cast<std::size_t>(row);
  return i < rows_.size() && rows_[i].more > 0
             ? tr("%1 (%2 more up to line %3)")
                   .arg(text, QLocale().toString(static_cast<qulonglong>(rows_[i].more)),
                        QString::number(rows_[i].last_line))
             : text;
}

QVariant DiagnosticsModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const Diagnostic& diagnostic = at(index.row());
  const bool in_program = diagnostic.file.empty();
  switch (role) {
    case severity_role:
      return static_cast<int>(diagnostic.severity);
    case line_role:
      return in_program ? diagnostic.line : 0U;
    case byte_role:
      return in_program ? diagnostic.column : 0U;
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
      break;
    default:
      return {};
  }
  switch (index.column()) {
    case place:
      return place_text(diagnostic);
    case message:
      return message_text(index.row());
    default:
      return in_language(diagnostic.hint);
  }
}

QVariant DiagnosticsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case place:
      return tr("Line");
    case message:
      return tr("Message");
    default:
      return tr("What to do");
  }
}

void DiagnosticsFilter::set_least(Severity severity) {
  least_ = severity;
  invalidateFilter();
}

bool DiagnosticsFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const QModelIndex index = sourceModel()->index(row, 0, parent);
  return index.data(DiagnosticsModel::severity_role).toInt() >= static_cast<int>(least_);
}

/// Place of a row; line 0 for a row without one.
TextPlace DiagnosticsFilter::place_of(int row) const {
  const QModelIndex there = index(row, 0);
  const uint column = there.data(DiagnosticsModel::byte_role).toUInt();
  return {there.data(DiagnosticsModel::line_role).toUInt(), column > 0 ? column - 1 : 0};
}

int DiagnosticsFilter::next_row(int row, TextPlace place, bool forward) const {
  std::vector<int> rows;
  for (int i = 0; i < rowCount(); ++i) {
    if (place_of(i).line > 0) {
      rows.push_back(i);
    }
  }
  if (rows.empty()) {
    return -1;
  }
  const bool on_it = row >= 0 && row < rowCount() && place_of(row).line == place.line;
  const auto before = [&](int other) { return on_it ? other < row : place_of(other) < place; };
  const auto up_to = [&](int other) { return on_it ? other <= row : place_of(other) <= place; };
  if (forward) {
    const auto found = std::ranges::find_if_not(rows, up_to);
    return found == rows.end() ? rows.front() : *found;
  }
  const auto found = std::ranges::find_if_not(rows, before);
  return found == rows.begin() ? rows.back() : *(found - 1);
}

}  // namespace feedscope::ui
