#pragma once

#include <QByteArray>
#include <QPaintDevice>
#include <QSizeF>
#include <QString>
#include <memory>

namespace feedscope::ui {

/// A paint device that writes SVG: shapes, clips and pictures as they are, text as outlines, so that it looks
/// the same where the fonts are missing. The same painting gives the same bytes. (QSvgGenerator of Qt 6.4
/// drops clips and names fonts instead.)
class SvgDevice : public QPaintDevice {
 public:
  /// `size` in units of the painter, 96 an inch. `page`: width and height as the file names them ("297mm").
  SvgDevice(QSizeF size, const QString& title, const QString& width, const QString& height);
  ~SvgDevice() override;

  QPaintEngine* paintEngine() const override;
  /// The file, once painting has ended.
  QByteArray svg() const;

 protected:
  int metric(PaintDeviceMetric metric) const override;

 private:
  class Engine;
  QSizeF size_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace feedscope::ui
