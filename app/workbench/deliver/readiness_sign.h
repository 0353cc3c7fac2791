// The state of a line of the readiness as a small round sign: a tick, an exclamation mark, a cross or dots.
#pragma once

#include <QWidget>

#include "app/workbench/deliver/readiness.h"

namespace tactus::workbench {

class ReadinessSign : public QWidget {
  Q_OBJECT

 public:
  explicit ReadinessSign(QWidget* parent = nullptr);

  void setState(Readiness state);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Readiness state_ = Readiness::kUnknown;
};

}  // namespace tactus::workbench
