#pragma once

#include <QImage>
#include <QList>
#include <QScrollArea>

class QLabel;
class QVBoxLayout;

namespace feedscope::ui {

/// Pages one below the other, as wide as the room permits.
class PagePreview : public QScrollArea {
  Q_OBJECT

 public:
  explicit PagePreview(QWidget* parent = nullptr);

  /// Keeps the place in the text if possible.
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
