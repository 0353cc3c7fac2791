// Mouse, touch and keyboard instead of a hand on the virtual device. A drag over the free area of the screen holds
// the handle and moves it, forward to the right; letting go takes it back to the start. Space holds, the arrows move.
#pragma once

#include <QObject>
#include <optional>

class QKeyEvent;
class QMouseEvent;

namespace tactus::workbench {

namespace nurse {
class Look;
}

class DeviceSession;
class ParticipantWindow;

class VirtualHand : public QObject {
  Q_OBJECT

 public:
  /// Does nothing while another device than the virtual one runs. All outlive this.
  VirtualHand(ParticipantWindow& window, const nurse::Look& look, DeviceSession& device);

  /// Whether the screen asks for the hand: only then are Space and the arrows the hand's. A hand that holds the handle
  /// keeps it until it lets go: she feels a force also while the screen asks how large it is.
  void setWanted(bool wanted);
  /// Lets go at once, and goes back to the start.
  void letGo();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(const QMouseEvent& event);
  void follow(const QEvent& event);
  void drag(const QMouseEvent& event);
  bool key(const QKeyEvent& event, bool down);
  void moveTo(double position_mm);
  bool holds() const { return from_px_ || space_; }

  ParticipantWindow& window_;
  const nurse::Look& look_;
  DeviceSession& device_;
  bool wanted_ = false;
  bool space_ = false;             ///< is down, and holds
  std::optional<double> from_px_;  ///< where a drag began
};

}  // namespace tactus::workbench
