#include "tests/gui/text_recorder.h"

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QWidget>

namespace tactus::tests {
namespace {

class Engine : public QPaintEngine {
 public:
  Engine(std::vector<WrittenText>& texts, QRectF all) : QPaintEngine(AllFeatures), texts_(texts), all_(all) {}

  bool begin(QPaintDevice* /*device*/) override { return true; }
  bool end() override { return true; }
  void updateState(const QPaintEngineState& /*state*/) override {}
  void drawPixmap(const QRectF& /*to*/, const QPixmap& /*pixmap*/, const QRectF& /*from*/) override {}
  void drawPath(const QPainterPath& /*path*/) override {}
  void drawPolygon(const QPointF* /*points*/, int /*count*/, PolygonDrawMode /*mode*/) override {}
  Type type() const override { return User; }

  void drawTextItem(const QPointF& at, const QTextItem& item) override {
    const QTransform transform = state->transform();
    const QRectF box(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent());
    QRectF clip = all_;
    if (!systemClip().isEmpty()) clip &= systemClip().boundingRect();
    if (painter()->hasClipping()) clip &= transform.mapRect(painter()->clipBoundingRect());
    texts_.push_back({item.text(), transform.mapRect(box), clip, item.font()});
  }

 private:
  std::vector<WrittenText>& texts_;
  QRectF all_;
};

class Device : public QPaintDevice {
 public:
  Device(QSize size, std::vector<WrittenText>& texts)
      : size_(size), engine_(std::make_unique<Engine>(texts, QRectF(QPointF(), size))) {}

  QPaintEngine* paintEngine() const override { return engine_.get(); }

 protected:
  int metric(PaintDeviceMetric metric) const override {
    constexpr int kDots = 96;
    switch (metric) {
      case PdmWidth: return size_.width();
      case PdmHeight: return size_.height();
      case PdmWidthMM: return size_.width() * 254 / 10 / kDots;
      case PdmHeightMM: return size_.height() * 254 / 10 / kDots;
      case PdmDpiX:
      case PdmDpiY:
      case PdmPhysicalDpiX:
      case PdmPhysicalDpiY: return kDots;
      case PdmDevicePixelRatio: return 1;
      case PdmDevicePixelRatioScaled: return static_cast<int>(devicePixelRatioFScale());
      default: return 24;
    }
  }

 private:
  QSize size_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace

std::vector<WrittenText> textsOf(QWidget& widget) {
  std::vector<WrittenText> texts;
  Device device(widget.size(), texts);
  widget.render(&device);
  return texts;
}

}  // namespace tactus::tests
