// The force on the hand as a bar, up to the force cap of the servo.
#pragma once

#include <QWidget>

namespace tactus::workbench {

class ForceBar : public QWidget {
  Q_OBJECT

 public:
  explicit ForceBar(QWidget* parent = nullptr);

  /// `force_n` fills the bar. A mark shows `friction_n`, the requested force, if the limits reduced it.
  void setForces(double force_n, double friction_n);
  /// Sets the end of the scale, > 0.
  void setFullScale(double full_n);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {100, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double force_n_ = 0;
  double friction_n_ = 0;
  double full_n_ = 2;
};

}  // namespace tactus::workbench
