// Measures the time from an edit to its display.
#pragma once

#include <QLabel>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QTimer>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

class QWidget;

namespace tactus::workbench {

class Refresh;

/// Measures from the sending of an edit until every visible plot has been painted with it. That includes the work of
/// panels through a Refresh, and the paint event after it. Hidden panels do not count. If a second edit is sent before
/// the panels worked for the first, both are shown together, and the time of the first counts; what the first lacks of
/// its finest picture then is of no account. Costs nothing between edits.
/// Thread: gui.
class FrameClock : public QObject {
  Q_OBJECT

 public:
  /// Times since the program started.
  struct Times {
    double last_ms = 0;
    double median_ms = 0;
    double largest_ms = 0;
    std::size_t edits = 0;
  };

  /// The time in ns since any fixed moment; never goes back.
  using Now = std::function<std::int64_t()>;

  /// `root`: the part of the window whose panels count. It outlives this.
  explicit FrameClock(const QWidget& root, QObject* parent = nullptr, Now now = steadyTime());

  /// The time until all plots were painted. A surface or map that refines in slices counts from its coarse picture on.
  /// Nothing before the first edit.
  std::optional<Times> painted() const { return timesOf(painted_ms_); }
  /// The time until all plots were painted at their finest.
  std::optional<Times> finest() const { return timesOf(finest_ms_); }

 public slots:
  /// An edit is being sent.
  void begin();
  /// The edit has been sent: all receivers know about it.
  void sent();

 signals:
  /// An edit is painted at its finest.
  void measured();
  /// An edit is painted, finely or coarsely.
  void shown();

 protected:
  bool event(QEvent* event) override;

 private:
  using Time = std::chrono::steady_clock::time_point;
  /// An edit that is not painted yet.
  struct Edit {
    std::int64_t begun_ns = 0;  ///< of `now_`
    Time begun;                 ///< what asks for work between these two, the edit itself asked for
    Time sent;
  };

  bool isFor(const Refresh& due, std::size_t edit) const;
  void lookLater();
  void look();
  void stop();
  double msSince(std::int64_t begun_ns) const;
  static Now steadyTime();
  static std::optional<Times> timesOf(const std::vector<double>& all_ms);

  const QWidget& root_;
  Now now_;
  std::optional<Edit> sending_;            ///< the edit that is being sent
  std::vector<Edit> edits_;                ///< sent and not painted yet, oldest first
  std::optional<std::int64_t> coarse_ns_;  ///< when the edit began that is painted coarsely; panels still refine
  QList<QPointer<Refresh>> watched_;       ///< of the panels, while an edit is not on the screen yet
  bool looking_ = false;
  std::vector<double> painted_ms_;
  std::vector<double> finest_ms_;
};

// The strip's label for the time from the last edit to the plots.

class FrameStatus : public QLabel {
  Q_OBJECT

 public:
  /// `clock` outlives this.
  explicit FrameStatus(const FrameClock& clock, QWidget* parent = nullptr);

 protected:
  bool event(QEvent* event) override;

 private:
  void showLast();
  QString explanation() const;

  const FrameClock& clock_;
  QTimer calm_;
};

}  // namespace tactus::workbench
