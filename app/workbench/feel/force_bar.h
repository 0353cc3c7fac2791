// The force on the hand as a bar on the scale of the trace, with the force cap of the servo.
#pragma once

#include <QWidget>
#include <functional>

namespace tactus::workbench {

class ForceBar : public QWidget {
  Q_OBJECT

 public:
  explicit ForceBar(QWidget* parent = nullptr);

  /// `force_n` fills the bar. A mark shows `friction_n`, the requested force, if the limits reduced it.
  void setForces(double force_n, double friction_n);
  /// Sets the end of the scale, > 0, and the largest force that the servo gives. A cap behind the end is only named.
  void setScale(double full_n, double cap_n);
  /// A higher bar, to be read from afar.
  void setLarge(bool large);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {100, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintScale(QPainter& painter, const QRectF& scale, const std::function<double(double)>& x_of) const;

  double force_n_ = 0;
  double friction_n_ = 0;
  double full_n_ = 2;
  double cap_n_ = 2;
  int bar_height_;  ///< px
};

}  // namespace tactus::workbench
