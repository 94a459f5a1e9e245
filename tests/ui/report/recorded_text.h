#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QStringList>
#include <vector>

namespace feedscope::test {

/// Of a text that was painted [px].
struct TextSpan {
  double left = 0;
  double right = 0;
};

/// A paper of 96 units an inch that keeps the texts painted on it, one for each call, and nothing else.
class RecordedText : public QPaintDevice {
 public:
  const QStringList& texts() const { return engine_.texts; }
  const std::vector<TextSpan>& spans() const { return engine_.spans; }  ///< one each of texts()
  QPaintEngine* paintEngine() const override { return &engine_; }

 protected:
  int metric(PaintDeviceMetric metric) const override {
    switch (metric) {
      case PdmDpiX:
      case PdmDpiY:
      case PdmPhysicalDpiX:
      case PdmPhysicalDpiY:
        return 96;
      case PdmDepth:
        return 32;
      case PdmDevicePixelRatio:
        return 1;
      case PdmDevicePixelRatioScaled:
        return static_cast<int>(devicePixelRatioFScale());
      case PdmWidth:
      case PdmHeight:
      case PdmWidthMM:
      case PdmHeightMM:
        return 1000;
      default:
        return QPaintDevice::metric(metric);
    }
  }

 private:
  struct Engine : QPaintEngine {
    Engine() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawPath(const QPainterPath&) override {}
    void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
    void drawTextItem(const QPointF& place, const QTextItem& item) override {
      const double left = state->transform().map(place).x();
      texts.append(item.text());
      spans.push_back({left, left + item.width()});
    }
    Type type() const override { return User; }
    QStringList texts;
    std::vector<TextSpan> spans;
  };
  mutable Engine engine_;
};

}  // namespace feedscope::test
