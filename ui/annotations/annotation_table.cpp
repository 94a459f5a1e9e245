#include "ui/annotations/annotation_table.h"

#include <utility>

namespace feedscope::ui {

AnnotationTable::AnnotationTable(AnnotationList& list, QObject* parent)
    : QAbstractTableModel(parent), list_(list), rows_(static_cast<int>(list.items().size())) {
  connect(&list_, &AnnotationList::changed, this, [this] {
    const int rows = static_cast<int>(list_.items().size());
    if (rows != rows_) {
      beginResetModel();
      rows_ = rows;
      endResetModel();
    } else if (rows > 0) {
      emit dataChanged(index(0, 0), index(rows - 1, columns - 1));
    }
  });
}

void AnnotationTable::set_toolpath(std::shared_ptr<const Toolpath> toolpath) {
  toolpath_ = std::move(toolpath);
  if (rows_ > 0) {
    emit dataChanged(index(0, line), index(rows_ - 1, line));
  }
}

void AnnotationTable::set_teller(std::function<QString(const Annotation&)> teller) {
  teller_ = std::move(teller);
  refresh_texts();
}

void AnnotationTable::refresh_texts() {
  if (rows_ > 0) {
    emit dataChanged(index(0, text), index(rows_ - 1, text));
  }
}

int AnnotationTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : rows_;
}

int AnnotationTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

QVariant AnnotationTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_) {
    return {};
  }
  const Annotation& annotation = list_.items()[static_cast<std::size_t>(index.row())];
  if (role == Qt::DecorationRole && index.column() == kind) {
    return annotation.colour;
  }
  if (role == Qt::TextAlignmentRole && index.column() == line) {
    return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (role == Qt::ToolTipRole && index.column() == text) {
    return annotation.text;
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (index.column()) {
    case kind:
      return annotation_title(annotation.kind);
    case line:
      return line_of(annotation);
    default:
      return (teller_ ? teller_(annotation) : QString(annotation.text)).replace('\n', QStringLiteral(" · "));
  }
}

QVariant AnnotationTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case kind:
      return tr("Kind");
    case line:
      return tr("Line");
    default:
      return tr("Text");
  }
}

QString AnnotationTable::line_of(const Annotation& annotation) const {
  const bool known = toolpath_ != nullptr && annotation.place.segment < toolpath_->segments.size();
  return known ? QString::number(toolpath_->segments[annotation.place.segment].line) : QString();
}

}  // namespace feedscope::ui
