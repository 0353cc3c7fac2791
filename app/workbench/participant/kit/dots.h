// One dot for each stroke to do; those that are recorded are filled and have a tick.
#pragma once

#include <QWidget>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

class Dots : public QWidget {
  Q_OBJECT

 public:
  explicit Dots(const Look& look, QWidget* parent = nullptr);

  void setCount(int filled, int all);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow();

  const Look& look_;
  int filled_ = 0;
  int all_ = 0;
};

}  // namespace tactus::workbench::nurse
