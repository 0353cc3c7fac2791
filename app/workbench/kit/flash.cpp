#include "app/workbench/kit/flash.h"

#include <QWidget>

namespace tactus::workbench {
namespace {

constexpr int kFadesMs = 900;  // long enough to find it with the eyes, short enough not to be in the way

}  // namespace

Flash::Flash(QWidget* widget) : QObject(widget) {
  fading_.setDuration(kFadesMs);
  fading_.setStartValue(1.0);
  fading_.setEndValue(0.0);
  connect(&fading_, &QVariantAnimation::valueChanged, this, [this, widget](const QVariant& value) {
    strength_ = value.toDouble();
    widget->update();
  });
}

void Flash::start() {
  fading_.stop();
  strength_ = 1;
  fading_.start();
}

}  // namespace tactus::workbench
