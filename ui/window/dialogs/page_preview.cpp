#include "ui/window/dialogs/page_preview.h"

#include <QLabel>
#include <QResizeEvent>
#include <QScrollBar>
#include <QVBoxLayout>

namespace feedscope::ui {

namespace {

constexpr int gap = 10;  // [pixels]

}  // namespace

PagePreview::PagePreview(QWidget* parent) : QScrollArea(parent) {
  auto* pages = new QWidget(this);
  column_ = new QVBoxLayout(pages);
  column_->setContentsMargins(gap, gap, gap, gap);
  column_->setSpacing(gap);
  column_->addStretch();
  setWidget(pages);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // else the widths of pages and bar would alternate
  setBackgroundRole(QPalette::Dark);
  pages->setBackgroundRole(QPalette::Dark);
  setAccessibleName(tr("Preview of the report"));
}

void PagePreview::set_pages(const QList<QImage>& pages) {
  const int place = verticalScrollBar()->value();
  pages_ = pages;
  while (labels_.size() > pages_.size()) {
    delete labels_.takeLast();
  }
  while (labels_.size() < pages_.size()) {
    labels_.append(new QLabel(widget()));
    column_->insertWidget(static_cast<int>(labels_.size()) - 1, labels_.last(), 0, Qt::AlignHCenter);
  }
  for (qsizetype i = 0; i < labels_.size(); ++i) {
    labels_[i]->setAccessibleName(tr("Page %1").arg(i + 1));
  }
  fit();
  verticalScrollBar()->setValue(place);
}

void PagePreview::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fit();
}

void PagePreview::fit() {
  const double ratio = devicePixelRatioF();
  const int width = std::max(1, static_cast<int>((viewport()->width() - 2 * gap) * ratio));
  for (qsizetype i = 0; i < labels_.size(); ++i) {
    const QImage& page = pages_[i];
    QPixmap shown =
        QPixmap::fromImage(page.width() > width ? page.scaledToWidth(width, Qt::SmoothTransformation) : page);
    shown.setDevicePixelRatio(ratio);
    labels_[i]->setPixmap(shown);
  }
}

}  // namespace feedscope::ui
