// Work of a panel that waits until somebody can see it, and then happens at most once per frame of the screen.
#pragma once

#include <QDeadlineTimer>
#include <QObject>
#include <QTimer>
#include <functional>

class QWidget;

namespace tactus::workbench {

/// While the panel cannot be seen, a request only makes it stale, and `work` is done when it is shown again. While it
/// can, requests are answered from the event loop, the first at once and the others with the next frame, all requests
/// of a frame together. What is hidden computes nothing, and a drag draws what is newest. A plot inside a panel waits
/// until the panel has computed what the plot will show, so that it is drawn once.
class Refresh : public QObject {
  Q_OBJECT

 public:
  static constexpr int kFrameMs = 16;  ///< a frame of a screen at 60 Hz

  /// `panel` owns this.
  Refresh(QWidget* panel, std::function<void()> work);

  /// The panel is shown, and its work is still to be done.
  bool isDue() const;
  /// The work goes on in slices: what is shown is coarse.
  bool isRefining() const { return refining_ && isSeen(); }
  /// `work` says so where it has more slices to do, and again after the last one.
  void setRefining(bool refining);

 public slots:
  void request();

 signals:
  /// The work, or its last slice, is done.
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
  bool refining_ = false;
};

}  // namespace tactus::workbench
