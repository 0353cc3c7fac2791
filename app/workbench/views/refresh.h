// Work of a panel that waits until somebody can see it, and then happens at most once per frame of the screen.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>

class QWidget;

namespace tactus::workbench {

/// While the panel is hidden, a request only makes it stale, and `work` is done when it is shown again. While it is
/// visible, requests are answered from the event loop, the first at once and the others with the next frame, all
/// requests of a frame together. What is hidden computes nothing, and a drag draws what is newest.
class Refresh : public QObject {
  Q_OBJECT

 public:
  static constexpr int kFrameMs = 16;  ///< a frame of a screen at 60 Hz

  /// `panel` owns this.
  Refresh(QWidget* panel, std::function<void()> work);

 public slots:
  void request();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void run();

  QWidget* panel_;
  std::function<void()> work_;
  QTimer timer_;
  QElapsedTimer since_last_;
  bool stale_ = false;
};

}  // namespace tactus::workbench
