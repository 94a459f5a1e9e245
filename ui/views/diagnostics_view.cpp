#include "ui/views/diagnostics_view.h"

#include <QHeaderView>
#include <QStyle>

namespace feedscope::ui {

namespace {

constexpr std::size_t most_entries = 1000;
enum Column { place, message, hint };

QStyle::StandardPixmap icon_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return QStyle::SP_MessageBoxCritical;
    case Severity::warning:
      return QStyle::SP_MessageBoxWarning;
    case Severity::info:
      break;
  }
  return QStyle::SP_MessageBoxInformation;
}

}  // namespace

DiagnosticsView::DiagnosticsView(QWidget* parent) : QTreeWidget(parent) {
  setHeaderLabels({tr("Line"), tr("Message"), tr("What to do")});
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setFrameShape(QFrame::NoFrame);
  header()->setSectionResizeMode(place, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(message, QHeaderView::Stretch);
  header()->setSectionResizeMode(hint, QHeaderView::Stretch);
  header()->setStretchLastSection(false);
  connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
    const uint line = item->data(place, Qt::UserRole).toUInt();
    if (line > 0) {
      emit line_chosen(line);
    }
  });
}

void DiagnosticsView::set_diagnostics(const std::vector<Diagnostic>& diagnostics) {
  clear();
  const std::size_t listed = std::min(diagnostics.size(), most_entries);
  for (std::size_t i = 0; i < listed; ++i) {
    add(diagnostics[i]);
  }
  if (listed < diagnostics.size()) {
    add_message(Severity::info, tr("and %1 more").arg(diagnostics.size() - listed));
  }
}

void DiagnosticsView::add_message(Severity severity, const QString& message) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.message = message.toStdString();
  add(diagnostic);
}

void DiagnosticsView::add(const Diagnostic& diagnostic) {
  auto* item = new QTreeWidgetItem(this);
  item->setIcon(place, style()->standardIcon(icon_of(diagnostic.severity)));
  if (diagnostic.line > 0) {
    item->setText(place, diagnostic.column > 0
                             ? QStringLiteral("%1:%2").arg(diagnostic.line).arg(diagnostic.column)
                             : QString::number(diagnostic.line));
  }
  item->setData(place, Qt::UserRole, diagnostic.line);
  item->setText(message, QString::fromStdString(diagnostic.message));
  item->setToolTip(message, QString::fromStdString(diagnostic.message));
  item->setText(hint, QString::fromStdString(diagnostic.hint));
  item->setToolTip(hint, QString::fromStdString(diagnostic.hint));
}

}  // namespace feedscope::ui
