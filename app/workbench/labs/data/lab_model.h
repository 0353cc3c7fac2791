// The averaged model of the open study with the labs' settings, and everything that led to it.
#pragma once

#include <QObject>
#include <QSet>
#include <QString>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

#include "app/workbench/base/worker.h"
#include "app/workbench/labs/data/lab_data.h"

namespace tactus::workbench {

// A computation of a lab on a thread of its own. It starts again when the study or a setting changes, runs only while
// it is wanted, tells how far it is, and can be canceled.

/// Thread: gui. Only the work itself runs on the other thread.
class LabWork : public QObject {
  Q_OBJECT

 public:
  /// Takes a result over. Runs in this thread; may be empty.
  using Deliver = std::function<void()>;
  /// What a run of the work reads and tells.
  struct Run {
    std::shared_ptr<const LabStudy> study;  ///< never null
    elicitation::BuildSettings settings;    ///< a clustering with them ends early if the run is stopped
    std::stop_token stop;
    /// Tells the share that is done, [0, 1]. Thread: any.
    std::function<void(double)> progress;
    /// Says what is done from now on, e.g. `Comparing clusters and levels`, in place of what the screen says of the
    /// whole work. Thread: any.
    std::function<void(QString)> say;
    /// Hands over a first or better result before the end. Thread: any.
    std::function<void(Deliver)> hand;
    /// The same for what is worth seeing even if a setting has moved meanwhile, so that plots follow a slider that is
    /// faster than they are; `current`: none has. Not after another study or a cancel. Thread: any.
    std::function<void(std::function<void(bool current)>)> show;
    /// Whether not even `show` would deliver. Thread: any.
    std::function<bool()> given_up;
  };
  /// Reads nothing but its run and what it owns. Returns the last result.
  using Work = std::function<Deliver(const Run&)>;

  /// `data` outlives this.
  LabWork(LabData& data, Work work, QObject* parent = nullptr);

  /// Runs while wanted, at once if something changed meanwhile; what runs is dropped when it is not wanted any more.
  void setWanted(bool wanted);
  /// Changes of the settings alone start no run: for work that reads none of them, or hears of them in another way.
  void ignoreSettings();
  bool isWanted() const { return wanted_; }
  bool isBusy() const { return background_.isBusy(); }
  /// Stopped by `cancel`; a change or `restart` starts again.
  bool isCanceled() const { return canceled_; }
  /// The share that is done, [0, 1].
  double progress() const { return progress_; }
  /// What the run last said of itself; empty if nothing.
  const QString& doing() const { return doing_; }

 public slots:
  void restart();
  void cancel();

 signals:
  /// `isBusy`, `isCanceled`, `progress` or `doing` changed. Comes after what a result delivers.
  void changed();

 private:
  void begin();
  Background::Deliver perform(Run& run, std::uint64_t number, const std::stop_token& stop);

  LabData& data_;
  Work work_;
  bool wanted_ = false;
  bool stale_ = true;
  bool canceled_ = false;
  double progress_ = 0;
  QString doing_;
  std::uint64_t newest_ = 0;               ///< the number of the run that counts
  std::atomic<std::uint64_t> oldest_ = 0;  ///< of the first run that may still `show` something
  std::shared_ptr<const LabStudy> of_;     ///< the study of that run
  CallQueue answers_;
  Background background_;  ///< last: its end waits for the work, which answers to all above
};

/// Thread: gui.
class LabModel : public QObject {
  Q_OBJECT

 public:
  /// `data` outlives this.
  explicit LabModel(LabData& data, QObject* parent = nullptr);

  /// Of the newest build; null if there is none, or it failed. While another one runs, the last one stays.
  const std::shared_ptr<const elicitation::BuiltModel>& built() const { return built_; }
  /// The study that `built` was made from, with the settings that made it.
  const std::shared_ptr<const LabStudy>& builtFrom() const { return from_; }
  const elicitation::BuildSettings& builtWith() const { return with_; }
  /// One sentence: why no model can be built; empty if one can.
  const QString& failure() const { return failure_; }
  const LabWork& work() const { return work_; }
  LabWork& work() { return work_; }

  /// Builds while at least one asker wants it. An asker that ends wants nothing.
  void setWanted(QObject& asker, bool wanted);

 signals:
  /// `built` or `failure` changed.
  void builtChanged();

 private:
  /// The newest model of the work's thread, whose clusters serve the next one. It keeps no study alive.
  struct Kept {
    std::weak_ptr<const LabStudy> study;
    elicitation::SpeedTermSettings with;
    std::shared_ptr<const elicitation::BuiltModel> built;
  };
  LabWork::Deliver build(const LabWork::Run& run);

  std::shared_ptr<const elicitation::BuiltModel> built_;
  std::shared_ptr<const LabStudy> from_;
  elicitation::BuildSettings with_;
  QString failure_;
  QSet<QObject*> askers_;
  Kept kept_;     ///< of the work's thread alone
  LabWork work_;  ///< last: its end waits for a build, which answers to all above
};

}  // namespace tactus::workbench
