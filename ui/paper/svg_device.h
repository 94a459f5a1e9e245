#pragma once

#include <QByteArray>
#include <QPaintDevice>
#include <QSizeF>
#include <QString>
#include <memory>

namespace feedscope::ui {

/// A paint device that writes SVG: shapes, clips and pictures directly, text as outlines, so that it does not
/// depend on installed fonts. The same painting gives the same bytes. (QSvgGenerator of Qt 6.4 drops clips
/// and refers to fonts by name.)
class SvgDevice : public QPaintDevice {
 public:
  /// `size` in units of the painter, 96 per inch. `page`: width and height for the file ("297mm").
  SvgDevice(QSizeF size, const QString& title, const QString& width, const QString& height);
  ~SvgDevice() override;

  QPaintEngine* paintEngine() const override;
  /// The file, after painting has ended.
  QByteArray svg() const;

 protected:
  int metric(PaintDeviceMetric metric) const override;

 private:
  class Engine;
  QSizeF size_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace feedscope::ui
