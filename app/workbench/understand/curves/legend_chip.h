// One entry of the legend of the curves: a sample of the line and its name, checked while the line is visible.
#pragma once

#include <QAbstractButton>

#include "app/workbench/plot/plot_menu.h"

namespace tactus::workbench {

class LegendChip : public QAbstractButton {
  Q_OBJECT

 public:
  LegendChip(LegendEntry look, const QString& tip, QWidget* parent);

  /// Changes the name of the line.
  void setName(const QString& name);
  /// Shown instead of the name where that does not fit.
  void setBrief(const QString& brief);
  /// Changes the colors of the line.
  void setLook(LegendEntry look);

  QSize sizeHint() const override;
  /// With the beginning of a long name.
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  LegendEntry look_;
  QString brief_;
};

}  // namespace tactus::workbench
