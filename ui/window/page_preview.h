#pragma once

#include <QImage>
#include <QList>
#include <QScrollArea>

class QLabel;
class QVBoxLayout;

namespace feedscope::ui {

/// Pages below one another, as wide as there is room.
class PagePreview : public QScrollArea {
  Q_OBJECT

 public:
  explicit PagePreview(QWidget* parent = nullptr);

  /// Stays at the same place of the text where it can.
  void set_pages(const QList<QImage>& pages);
  qsizetype count() const { return pages_.size(); }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  QVBoxLayout* column_;
  QList<QImage> pages_;
  QList<QLabel*> labels_;
};

}  // namespace feedscope::ui
