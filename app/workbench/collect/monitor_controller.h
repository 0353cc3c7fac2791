// What the researcher sees of a session that is in progress: where the participant is, the force, the answers as they
// are stored, and the researcher's own notes. It reads snapshots and samples; no other thread waits for it.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/session/session_state.h"
#include "app/workbench/study/connection/session_proxy.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// The force of the last seconds, commanded and delivered, as the monitor draws it.
class ForceTrace {
 public:
  static constexpr double kSeconds = 12;
  static constexpr std::int64_t kStepNs = 5'000'000;  ///< one point for each 5 ms: 2400 points

  struct Point {
    std::int64_t time_ns = 0;
    double commanded_n = 0;  ///< requested by the source
    double delivered_n = 0;  ///< after all limits
    double position_mm = 0;
  };

  void add(std::span<const haptics::Sample> samples);
  void clear();
  /// Oldest first.
  const std::deque<Point>& points() const { return points_; }
  /// Of the newest sample; null before the first.
  const Point* newest() const { return points_.empty() ? nullptr : &points_.back(); }
  /// The newest sample was limited: the force in the hand is not the commanded one.
  bool isCut() const;

 private:
  std::deque<Point> points_;
};

/// The state of the participant's screens, in the words of the monitor.
struct NurseView {
  QString code;    ///< empty: not known yet
  QString screen;  ///< `Forces`, `Questions`, …
  QString now;     ///< what happens there: `feels 0.6 N`; may be empty
  QString device;  ///< state of the device in words
  bool simulated = false;
  bool setup_unchecked = false;  ///< a person on a device whose set-up was not checked
  bool force_off = false;        ///< the participant has switched the force off
  bool called = false;           ///< the participant has called the researcher
  bool stopped = false;          ///< stopped, withdrawn, or no consent
  bool device_trouble = false;
  bool call_seen = false;   ///< the researcher answered the call
  bool stuck = false;       ///< the device has waited long for a hand: she does not know how to hold it
  bool discomfort = false;  ///< she said that hand or arm do not feel well today
  QString reading;          ///< language and size of the text: `English, 125 %`

  bool operator==(const NurseView&) const = default;
};

/// One line of the course of the session.
struct MonitorLine {
  enum class Kind { kStage, kAnswer, kUnscored, kNote, kCall };
  Kind kind = Kind::kStage;
  std::int64_t utc_ms = 0;
  QString text;

  bool operator==(const MonitorLine&) const = default;
};

/// Thread: gui.
class MonitorController : public QObject {
  Q_OBJECT

 public:
  /// `session` and `study` outlive this. `now_ms`: the wall clock.
  MonitorController(SessionProxy& session, StudyConnection& study, std::function<std::int64_t()> now_ms,
                    QObject* parent = nullptr);

  const NurseView& nurse() const { return nurse_; }
  const ForceTrace& trace() const { return trace_; }
  /// Oldest first.
  const std::vector<MonitorLine>& lines() const { return lines_; }
  /// Things done of things planned in the present part; both 0 where there is nothing to count.
  session::Share share() const;
  /// Since the session began; nothing without one.
  std::optional<int> minutes() const;
  /// The researcher has paused the session.
  bool isPaused() const;
  bool canPause() const;
  /// What the disk says; empty: all is well.
  QString failure() const { return session_.failure(); }

  void show(const NurseView& nurse);
  void add(std::span<const haptics::Sample> samples);
  /// A sentence of the participant's screens for the researcher.
  void say(const QString& sentence);

 public slots:
  void pause();
  void goOn();
  /// The researcher has seen the participant's call.
  void answerCall() { emit callAnswered(); }
  /// Stores the researcher's words in the log of the session. Nothing for empty ones, or without a session.
  void note(const QString& words);

 signals:
  /// `nurse`, `share` or the pause changed.
  void changed();
  void lineAdded();
  void callAnswered();
  /// New samples are in the trace. At most 60 times a second.
  void traced();

 private:
  void onSession();
  void compare(const SessionSnapshot& before, const SessionSnapshot& now);
  void compareStrokes(const SessionSnapshot& before, const SessionSnapshot& now);
  void compareReplies(const SessionSnapshot& before, const SessionSnapshot& now);
  void readJudgement(const study::RecordId& session);
  void addLine(MonitorLine::Kind kind, const QString& text);

  SessionProxy& session_;
  StudyConnection& study_;
  const std::function<std::int64_t()> now_ms_;
  NurseView nurse_;
  ForceTrace trace_;
  std::vector<MonitorLine> lines_;
  std::shared_ptr<const SessionSnapshot> seen_;
  bool paused_here_ = false;
};

}  // namespace tactus::workbench
