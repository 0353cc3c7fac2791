// Repaints or recomputes a panel only while it is visible, at most once per screen frame.
#pragma once

#include <QDeadlineTimer>
#include <QObject>
#include <QTimer>
#include <chrono>
#include <functional>

class QWidget;

namespace tactus::workbench {

/// While the panel is hidden, a request only marks it stale; `work` runs when the panel is shown again. While it is
/// visible, the event loop runs `work`: at once for the first request, then once per frame for all requests of that
/// frame. So a hidden panel computes nothing, and a drag draws only the newest state. A plot inside a panel waits until
/// the panel has computed its data, so that the plot is drawn once.
class Refresh : public QObject {
  Q_OBJECT

 public:
  static constexpr int kFrameMs = 16;  ///< a frame of a screen at 60 Hz

  /// `panel` owns this.
  Refresh(QWidget* panel, std::function<void()> work);

  /// Whether the panel is shown and its work is still to be done.
  bool isDue() const;
  /// Since when it is due: the first request after the last work.
  std::chrono::steady_clock::time_point dueSince() const { return due_since_; }
  /// Whether `work` is in progress in slices or on another thread, so that the panel shows a coarse picture.
  bool isRefining() const { return refining_ && isSeen(); }
  /// `work` calls this with true if more is to come, and with false in the end.
  void setRefining(bool refining);

 public slots:
  void request();

 signals:
  /// The work, or its last part, is done.
  void done();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isSeen() const;
  const Refresh* dueAbove() const;
  void run();

  QWidget* panel_;
  std::function<void()> work_;
  QTimer timer_;
  QDeadlineTimer next_;  ///< when the next frame begins
  bool stale_ = false;
  std::chrono::steady_clock::time_point due_since_;
  bool refining_ = false;
};

}  // namespace tactus::workbench
