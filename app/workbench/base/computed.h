// A value that follows its inputs: another thread computes it, and only while a view or another value holds it.
// Example: Computed<Place, double> force([this] { return place_; },
//                                        [model](const Place& at, const auto&) { return forceAt(*model, at); });
#pragma once

#include <QObject>
#include <QSet>
#include <QString>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "app/workbench/base/worker.h"

namespace tactus::workbench {

/// Is kept current while it is held: by a view that is on the screen, or by a value that is computed from it.
/// Thread: gui.
class Held : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// A holder that ends lets go.
  void hold(QObject& holder, bool held = true);
  bool isHeld() const { return !holders_.isEmpty(); }

 protected:
  /// The first holder came, or the last one went.
  virtual void followHolders() = 0;

 private:
  QSet<QObject*> holders_;
};

/// What is the same for every Computed. Thread: gui.
class Computation : public Held {
  Q_OBJECT

 public:
  bool isBusy() const { return background_.isBusy(); }
  /// Stopped by `cancel`; a change of the inputs starts again.
  bool isCanceled() const { return canceled_; }
  /// The share that is done, [0, 1].
  double progress() const { return progress_; }
  /// What the run last said of itself; empty if nothing.
  const QString& doing() const { return doing_; }
  /// Holds `need`, which outlives this, while this is held.
  void needs(Held& need) { needs_.push_back(&need); }

 public slots:
  /// The inputs are others: computes again, at once or as soon as this is held. The old value stays until then.
  void refresh();
  /// The same where the inputs are about something else: what runs shows nothing more.
  void renew();
  /// The same; there is no value until the new one comes.
  void forget();
  void cancel();

 signals:
  /// The value or the failure is another.
  void valueChanged();
  /// `isBusy`, `isCanceled`, `progress` or `doing` changed. Comes after `valueChanged`.
  void changed();

 protected:
  using Deliver = std::function<void()>;
  using Job = std::function<Deliver(std::uint64_t number, const std::stop_token& stop)>;

  using Held::Held;
  void followHolders() override;
  /// Computes with the inputs of now; empty if there are none.
  virtual Job job() = 0;
  /// Without value and failure.
  virtual void clear() = 0;

  /// Calls `deliver` in this thread while the run counts; with `older`, also where inputs have moved since. Thread:
  /// any.
  void post(std::uint64_t number, bool older, std::function<void(bool current)> deliver);
  void tellProgress(std::uint64_t number, double share);
  void say(std::uint64_t number, const QString& doing);
  bool isGivenUp(std::uint64_t number) const { return number < oldest_; }

 private:
  void begin();
  void drop();

  std::vector<Held*> needs_;
  bool stale_ = true;
  bool canceled_ = false;
  double progress_ = 0;
  QString doing_;
  std::uint64_t newest_ = 0;               ///< the number of the run that counts
  std::atomic<std::uint64_t> oldest_ = 0;  ///< of the first run that may still `show` something
  CallQueue answers_;
  Background background_;  ///< last: its end waits for the run, which answers to all above
};

/// What a run tells before its end. Thread: any.
template <class T>
struct RunOf {
  std::stop_token stop;
  std::function<void(double share)> progress;
  /// Says what is done from now on, e.g. `Comparing clusters and levels`, in place of what the screen says of the
  /// whole.
  std::function<void(QString)> say;
  /// Hands over a first or better value.
  std::function<void(T)> hand;
  /// The same for what is worth seeing even if inputs have moved meanwhile, so that plots follow a slider that is
  /// faster than they are. Not after `renew` or `cancel`.
  std::function<void(T)> show;
  /// Whether not even `show` would deliver.
  std::function<bool()> given_up;
};

/// Nothing is computed while it is not held; the newest inputs win. The function runs in the other thread and reads
/// nothing but the inputs and what it owns, so that it may outlive all that is on the screen. Thread: gui.
template <class Inputs, class T>
class Computed : public Computation {
 public:
  /// The value; null keeps the last one (the run was stopped, or has handed all over). Or one sentence: why there is
  /// none.
  using Answer = tl::expected<std::shared_ptr<const T>, QString>;
  using Function = std::function<Answer(const Inputs&, const RunOf<T>&)>;

  /// `inputs`: those of now, called in this thread; nothing: nothing can be computed.
  Computed(std::function<std::optional<Inputs>()> inputs, Function function, QObject* parent = nullptr)
      : Computation(parent), inputs_(std::move(inputs)), function_(std::move(function)) {}

  /// The newest; null if there is none.
  const std::shared_ptr<const T>& value() const { return value_; }
  /// The inputs that gave it.
  const std::shared_ptr<const Inputs>& of() const { return of_; }
  /// `value` is of the newest inputs. Set by each new value, not by `refresh`.
  bool isCurrent() const { return current_; }
  /// One sentence; empty if the last run had none.
  const QString& failure() const { return failure_; }

 protected:
  void clear() override {
    if (value_ != nullptr || !failure_.isEmpty()) take(nullptr, nullptr, false);
  }
  Job job() override {
    auto now = inputs_();
    if (!now) return {};
    return [this, of = std::make_shared<const Inputs>(std::move(*now)), function = function_](
               std::uint64_t number, const std::stop_token& stop) -> Deliver {
      const auto hand = [this, of, number](bool older) {
        return [this, of, number, older](T value) {
          post(number, older, [this, of, value = std::make_shared<const T>(std::move(value))](bool current) {
            take(value, of, current);
          });
        };
      };
      const RunOf<T> run{stop,
                         [this, number](double share) { tellProgress(number, share); },
                         [this, number](const QString& doing) { say(number, doing); },
                         hand(false),
                         hand(true),
                         [this, number] { return isGivenUp(number); }};
      auto answer = function(*of, run);
      if (answer && *answer == nullptr) return {};
      return [this, of, answer = std::move(answer)] {
        answer ? take(*answer, of, true) : take(nullptr, of, true, answer.error());
      };
    };
  }

 private:
  void take(std::shared_ptr<const T> value, std::shared_ptr<const Inputs> of, bool current,
            const QString& failure = {}) {
    value_ = std::move(value);
    of_ = std::move(of);
    current_ = current;
    failure_ = failure;
    emit valueChanged();
  }

  std::function<std::optional<Inputs>()> inputs_;
  Function function_;
  std::shared_ptr<const T> value_;
  std::shared_ptr<const Inputs> of_;
  bool current_ = false;
  QString failure_;
};

}  // namespace tactus::workbench
