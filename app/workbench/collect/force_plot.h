// Draws a ForceTrace: the commanded force as a band, the delivered force as a line.
#pragma once

#include <QWidget>

namespace tactus::workbench {

class ForceTrace;

class ForcePlot : public QWidget {
  Q_OBJECT

 public:
  explicit ForcePlot(const ForceTrace& trace, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {480, 200}; }
  QSize minimumSizeHint() const override { return {240, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const ForceTrace& trace_;
};

}  // namespace tactus::workbench
