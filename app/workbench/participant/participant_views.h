// Shows the nurse's screens in their window: the widget of each screen of the course, the panels of "Force off", and
// what the person does as calls of the course. The one place where screens and course meet.
#pragma once

#include <QObject>
#include <QPointer>
#include <QSet>
#include <cstdint>
#include <functional>

#include "app/workbench/participant/participant_state.h"

class QWidget;

namespace tactus::workbench {

namespace nurse {
class Look;
class ScreenFrame;
}  // namespace nurse

class ParticipantController;
class ParticipantWindow;

class ParticipantViews : public QObject {
  Q_OBJECT

 public:
  /// All of them outlive this.
  ParticipantViews(ParticipantController& course, nurse::Look& look, ParticipantWindow& window);

 signals:
  /// She is done, and the window may close or wait for the next participant.
  void finished();

 protected:
  /// First frames of a screen, and which keys, buttons and touches are down.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show();
  void showOverlay();
  /// The screen of this kind; a new one is given to `made` and shown.
  template <class Screen>
  Screen* screen(const std::function<void(Screen&)>& made);
  void showWelcome();
  void showConsent();
  void showAboutYou();
  void showDeviceCheck();
  void showStrokes();
  void showForce();
  void showRest();
  void showGlossary();
  void showQuestion();
  void showReview();
  void showScale();
  void showOwnModel();
  void showThanks();
  void showStopped();
  void goOnWith(nurse::ScreenFrame& made);
  void end();
  void frameWasPainted();
  bool isHers(const QObject& watched) const;
  void tellHeld();
  void tellMeans(const QEvent& event);

  ParticipantController& course_;
  nurse::Look& look_;
  ParticipantWindow& window_;
  QPointer<nurse::ScreenFrame> shown_;
  bool entering_code_ = false;  ///< at the welcome
  int review_page_ = 0;
  std::uint64_t painted_ = 0;  ///< the last serial whose first frame was painted
  bool frame_pending_ = false;
  QSet<int> keys_;  ///< down
  QString cover_;   ///< which panel covers the screen
};

}  // namespace tactus::workbench
