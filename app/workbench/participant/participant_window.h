// The window of the nurse: full screen, one screen at a time, and a red button "Force off" that nothing covers. It
// opens no other window: what asks her something lies inside, as a cover over the screen and below the button.
#pragma once

#include <QWidget>
#include <functional>

class QScreen;

namespace tactus::workbench {

namespace nurse {
class Button;
class Look;
}  // namespace nurse

class ForceOffKeys;

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

 signals:
  /// The force is off; time to ask what she wants.
  void forceOff(tactus::workbench::ForceOffCause cause);
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
  nurse::Button* leave_button_;
  QWidget* screen_ = nullptr;
  QWidget* cover_ = nullptr;
  QWidget* question_ = nullptr;
  bool leaving_ = false;
};

}  // namespace tactus::workbench
