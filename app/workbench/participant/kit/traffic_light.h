// A traffic light that also those read who see no colors: each lamp has its place and its sign.
#pragma once

#include <QWidget>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

enum class Light {
  kStop,   ///< a cross: call the researcher
  kWait,   ///< a hand at work: do what the sentence says
  kReady,  ///< a tick
};

class TrafficLight : public QWidget {
  Q_OBJECT

 public:
  explicit TrafficLight(const Look& look, QWidget* parent = nullptr);

  void setLight(Light light);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Look& look_;
  Light light_ = Light::kWait;
};

}  // namespace tactus::workbench::nurse
