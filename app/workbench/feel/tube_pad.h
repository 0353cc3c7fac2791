// The pad on which the mouse is the hand: left and right moves the tube along its axis, the mouse button holds it. It
// shows how far the tube lags behind the cursor, which is how a virtual device shows a force.
#pragma once

#include <QWidget>
#include <optional>

class QPainter;

namespace tactus::workbench {

class TubePad : public QWidget {
  Q_OBJECT

 public:
  explicit TubePad(QWidget* parent = nullptr);

  struct Reading {
    double hand_mm = 0;    ///< along the axis
    double tube_mm = 0;    ///< the point of the tube that the hand holds
    double target_mm = 0;  ///< target at the cursor
    bool live = false;     ///< mouse and keyboard drive the hand
    bool held = false;     ///< the hand holds the tube
    bool latch = false;    ///< a first press holds the tube, a second one releases it
    bool running = false;
    bool replay = false;            ///< a recording moves the tube
    bool armed = false;             ///< a recording waits for the next start
    std::optional<int> recorded_s;  ///< length of the current recording, s

    bool operator==(const Reading&) const = default;
  };
  void setReading(const Reading& reading);
  /// True: the hint is in the tool tip alone.
  void setLow(bool low);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {200, sizeHint().height()}; }

 signals:
  void targetMoved(double position_mm);
  void gripped(bool held);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  double xOf(double position_mm) const;
  double positionAt(double x) const;
  QString hint() const;
  void paintRecording(QPainter& painter) const;

  Reading reading_;
  bool pressed_ = false;  ///< with the mouse
  bool low_ = false;
};

}  // namespace tactus::workbench
