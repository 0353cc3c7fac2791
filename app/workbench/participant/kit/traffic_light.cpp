#include "app/workbench/participant/kit/traffic_light.h"

#include <QPainter>

#include "app/workbench/participant/kit/colors.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kLampMm = 20;
constexpr double kPaddingMm = 4;
constexpr QColor kStopColor(0x9B, 0x1C, 0x1C);
constexpr QColor kWaitColor(0xFF, 0xC2, 0x47);
constexpr QColor kReadyColor(0x1B, 0x6E, 0x3C);

void drawSign(QPainter& painter, Light lamp, const QRectF& box) {
  const double width = box.width() / 10;
  painter.setPen(QPen(lamp == Light::kWait ? colors::kInk : QColor(Qt::white), width, Qt::SolidLine, Qt::RoundCap));
  const double d = box.width() * 0.2;
  const QPointF c = box.center();
  switch (lamp) {
    case Light::kStop:
      painter.drawLine(c + QPointF(-d, -d), c + QPointF(d, d));
      painter.drawLine(c + QPointF(-d, d), c + QPointF(d, -d));
      break;
    case Light::kWait:
      for (const double x : {-1.1, 0.0, 1.1}) painter.drawPoint(c + QPointF(x * d, 0));
      break;
    case Light::kReady:
      drawTick(painter, box, width);
      break;
  }
}

}  // namespace

TrafficLight::TrafficLight(const Look& look, QWidget* parent) : QWidget(parent), look_(look) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(&look, &Look::changed, this, [this] {
    updateGeometry();
    update();
  });
}

void TrafficLight::setLight(Light light) {
  if (light == light_) return;
  light_ = light;
  update();
}

QSize TrafficLight::sizeHint() const {
  const int lamp = look_.mm(kLampMm);
  const int padding = look_.mm(kPaddingMm);
  return {lamp + 2 * padding, 3 * lamp + 4 * padding};
}

void TrafficLight::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double padding = look_.mm(kPaddingMm);
  const double lamp = look_.mm(kLampMm);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors::kInk);
  painter.drawRoundedRect(rect(), (lamp + 2 * padding) / 2, (lamp + 2 * padding) / 2);
  double y = padding;
  for (const Light each : {Light::kStop, Light::kWait, Light::kReady}) {
    const QRectF box(padding, y, lamp, lamp);
    const QColor on = each == Light::kStop ? kStopColor : each == Light::kWait ? kWaitColor : kReadyColor;
    const bool lit = each == light_;
    painter.setPen(lit ? QPen(Qt::white, lamp / 16) : QPen(colors::kMutedInk, 1.5));
    painter.setBrush(lit ? QBrush(on) : QBrush(colors::kInk));
    painter.drawEllipse(box.adjusted(1, 1, -1, -1));
    if (lit) drawSign(painter, each, box);
    y += lamp + padding;
  }
}

}  // namespace tactus::workbench::nurse
