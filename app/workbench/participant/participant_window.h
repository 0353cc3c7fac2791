// The window of the nurse: full screen, one screen at a time, and a red button "Force off" that nothing covers. It
// opens no other window: what asks her something lies inside, as a cover over the screen and below the button.
#pragma once

#include <QObject>
#include <QWidget>
#include <functional>
#include <optional>

#include "app/workbench/participant/screens/panels.h"

class QKeyEvent;
class QLineEdit;
class QMouseEvent;
class QScreen;

namespace tactus::workbench {

class DeviceSession;

/// The way back to the research mode: asks for the study's passphrase, over the nurse's screen.
class LeavePanel : public nurse::PanelCard {
  Q_OBJECT

 public:
  explicit LeavePanel(const nurse::Look& look, QWidget* parent = nullptr);

  /// What was typed is not the passphrase.
  void refuse();

 signals:
  void entered(const QString& passphrase);
  /// Back to the participant.
  void stay();

 private:
  void followLook();

  QLineEdit* passphrase_;
  nurse::Label* wrong_;
};

/// Esc means "Force off" in the whole program: in any window, whatever has the keyboard.
class ForceOffKeys : public QObject {
  Q_OBJECT

 public:
  explicit ForceOffKeys(QObject* parent = nullptr);

  /// Watches the keys of the whole program, or stops. While it watches, nothing else gets Esc.
  void setOn(bool on);

 signals:
  /// Esc went down. A held key asks once.
  void pressed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool on_ = false;
};

namespace nurse {
class Button;
class Look;
}  // namespace nurse

/// Why the force was taken away.
enum class ForceOffCause {
  kButton,
  kEscape,
  kDeactivated,  ///< another window or program has the keyboard
  kScreenGone,   ///< a screen was disconnected
  kClosing,      ///< the desktop wants to close the window
};

class ParticipantWindow : public QWidget {
  Q_OBJECT

 public:
  /// `force_off`: takes the force away at once, in any state and any number of times. It is called before anything is
  /// shown. `look` outlives this.
  ParticipantWindow(nurse::Look& look, std::function<void()> force_off);
  ~ParticipantWindow() override;

  /// Fills `screen` of the desktop. From now on Esc means "Force off" in the whole program.
  void showOn(QScreen& screen);
  /// Closes the window without a question.
  void leave();

  /// Shows `screen`, which belongs to the window from now on; the one before is deleted.
  void setScreen(QWidget* screen);
  QWidget* screen() const { return screen_; }
  /// Lays `cover` over the screen, which takes no keys and touches until `uncover`.
  void cover(QWidget* cover);
  void uncover();
  bool isCovered() const { return cover_ != nullptr || question_ != nullptr; }
  /// Lays a question for the researcher over everything but "Force off", until `endQuestion`.
  void askResearcher(QWidget* question);
  void endQuestion();

  nurse::Button& forceOffButton() { return *force_off_button_; }
  nurse::Button& pauseButton() { return *pause_button_; }
  /// A device may give a force: the red button stands in the corner, else a quiet one for a pause. Esc takes the force
  /// away in any case.
  void setArmed(bool armed);

 signals:
  /// The force is off; time to ask what she wants.
  void forceOff(tactus::workbench::ForceOffCause cause);
  /// She wants to pause where no device is armed.
  void pauseAsked();
  /// The researcher wants to leave for the research mode; offered while the screen is covered.
  void leaveAsked();

 protected:
  bool event(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void takeForceAway(ForceOffCause cause);
  void put(QWidget*& place, QWidget* widget);
  void arrange();
  QWidget* top() const;
  void giveFocus();

  nurse::Look& look_;
  const std::function<void()> force_off_;
  ForceOffKeys* keys_;
  nurse::Button* force_off_button_;
  nurse::Button* pause_button_;
  nurse::Button* leave_button_;
  QWidget* screen_ = nullptr;
  QWidget* cover_ = nullptr;
  QWidget* question_ = nullptr;
  bool armed_ = true;
  bool leaving_ = false;
};

// Mouse, touch and keyboard instead of a hand on the virtual device. A drag over the free area of the screen holds
// the handle and moves it, forward to the right; letting go takes it back to the start. Space holds, the arrows move.

namespace nurse {
class Look;
}

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
