// Shows the nurse's screens in their window: the widget of each screen of the course, the panels of "Force off", and
// what the person does as calls of the course. The one place where screens and course meet.
#pragma once

#include <QObject>
#include <QPointer>
#include <QSet>
#include <cstdint>
#include <optional>

#include "app/workbench/participant/kit/participant_state.h"

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
  /// Makes the screen that shows `state`, and connects what is its own.
  nurse::ScreenFrame* made(const ParticipantState& state);
  void end();
  void frameWasPainted();
  bool isHers(const QObject& watched) const;
  void tellHeld();
  void tellMeans(const QEvent& event);

  ParticipantController& course_;
  nurse::Look& look_;
  ParticipantWindow& window_;
  QPointer<nurse::ScreenFrame> shown_;
  std::optional<ParticipantScreen> shows_;  ///< the screen of the course that made `shown_`
  int review_page_ = 0;
  std::uint64_t painted_ = 0;  ///< the last serial whose first frame was painted
  bool frame_pending_ = false;
  QSet<int> keys_;  ///< down
  QString cover_;   ///< which panel covers the screen
};

}  // namespace tactus::workbench
