// How long an edit takes until the screen shows it.
#pragma once

#include <QElapsedTimer>
#include <QList>
#include <QObject>
#include <QPointer>
#include <cstddef>
#include <optional>
#include <vector>

class QWidget;

namespace tactus::workbench {

class Refresh;

/// Measures from the moment an edit is sent to the moment when every plot that is shown has been painted with it; work
/// that panels do through a Refresh is waited for, and so is the paint event after it. What is hidden does not count.
/// An edit that is sent before the one before it is on the screen is shown together with it, and the time of the older
/// one counts. Measuring costs nothing between edits. Thread: gui.
class FrameClock : public QObject {
  Q_OBJECT

 public:
  /// A series of times, of this session.
  struct Times {
    double last_ms = 0;
    double median_ms = 0;
    double largest_ms = 0;
    std::size_t edits = 0;
  };

  /// `root`: the part of the window whose panels count; it outlives this.
  explicit FrameClock(const QWidget& root, QObject* parent = nullptr);

  /// Until all plots have been painted, a surface or map that refines in slices at least coarsely. Nothing before the
  /// first edit.
  std::optional<Times> painted() const { return timesOf(painted_ms_); }
  /// Until all plots have been painted at their finest.
  std::optional<Times> finest() const { return timesOf(finest_ms_); }

 public slots:
  /// An edit is being sent.
  void begin();
  /// It has been sent: whoever shows it knows.
  void sent();

 signals:
  void measured();

 protected:
  bool event(QEvent* event) override;

 private:
  bool isWaiting() const;
  void lookLater();
  void look();
  void stop();
  static std::optional<Times> timesOf(const std::vector<double>& all_ms);

  const QWidget& root_;
  QElapsedTimer clock_;               ///< valid while an edit is on its way
  QList<QPointer<Refresh>> watched_;  ///< of the panels, while an edit is on its way
  bool coarse_ = false;               ///< painted, and panels refine
  bool looking_ = false;
  std::vector<double> painted_ms_;
  std::vector<double> finest_ms_;
};

}  // namespace tactus::workbench
