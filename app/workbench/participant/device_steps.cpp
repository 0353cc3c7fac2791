// The steps of the nurse's course with the device in her hand: its check, the insertions, the forces, her own model.
#include <algorithm>
#include <utility>

#include "app/workbench/participant/participant_steps.h"
#include "app/workbench/participant/questions.h"
#include "experiments/force_series.h"

namespace tactus::workbench {

struct ParticipantController::DeviceSteps {
  class Check;
  class Speed;
  class Force;
  class Own;
};

class ParticipantController::DeviceSteps::Check final : public Step {
 public:
  using Step::Step;

  void ask() override {
    course_.check_.begin();
    clock_.begin();
  }
  void show(ParticipantState& state) override {
    state.can_go_on =
        state.device == DeviceStep::kReady || state.device == DeviceStep::kWrong || state.device == DeviceStep::kLost;
    state.waits = clock_.wait();
  }
  void next() override {
    if (course_.state_.device == DeviceStep::kReady) {
      course_.passed_.device = true;
    } else {
      course_.startDevice();
    }
  }
  void sampled(std::span<const haptics::Sample> samples) override {
    const bool waits = clock_.add(samples, course_.check_.step() == DeviceStep::kHold);
    if (course_.check_.add(samples) || waits) course_.look();
  }

 private:
  HoldClock clock_;
};

class ParticipantController::DeviceSteps::Speed final : public Step {
 public:
  using Step::Step;
  using Note = SpeedState::Note;

  void close() override { capture_.close(); }
  void show(ParticipantState& state) override {
    const experiments::SpeedPlan& plan = *course_.at()->speed;
    state.speed = {QString::fromStdString(plan.level), plan.number - 1, plan.count,
                   note_ == Note::kStart && !at_start_ && !capture_.isOpen() ? Note::kReturn : note_};
    state.can_go_on = false;  // the hand does
    state.waits = clock_.wait();
  }
  void sampled(std::span<const haptics::Sample> samples) override {
    const session::SessionSettings& settings = *course_.at()->settings;
    if (clock_.add(samples, capture_.isOpen())) course_.look();
    const bool was_at_start = std::exchange(at_start_, samples.back().position_mm <= settings.force.start_zone_mm);
    if (!capture_.isOpen() && at_start_ && !course_.proxy_.isMovingOn() &&
        course_.gate_.isSettled(course_.now_().monotonic_ns)) {
      capture_.open(settings.speed.stroke);  // what was said of the last one stays until the hand moves
      course_.look();
    } else if (auto stroke = capture_.add(samples)) {
      note_ = noteOf(stroke->stroke.verdict);
      course_.proxy_.addStroke(course_.at()->step, std::move(*stroke));
      course_.look();
    } else if (at_start_ != was_at_start) {
      if (!at_start_ && capture_.isOpen()) note_ = Note::kStart;
      course_.look();
    }
  }

 private:
  SpeedCapture capture_;
  Note note_ = Note::kStart;
  bool at_start_ = false;  ///< the handle is where an insertion begins
  HoldClock clock_;
};

class ParticipantController::DeviceSteps::Force final : public Step {
 public:
  using Step::Step;

  bool beginsForce() override {
    if (course_.correcting_ || course_.at()->part != session::SessionPart::kForce) return false;
    trial().begin(*course_.at()->force);
    return true;
  }
  void ask() override {
    if (!course_.correcting_) return;
    course_.chosen_ = wordOf(*course_.at()->judged);
    stops_ = stopped_;
  }
  void close() override { asks_if_sure_ = stops_ = false; }
  void show(ParticipantState& state) override {
    using Phase = ForceState::Phase;
    const bool correcting = course_.correcting_;
    ForceState out;
    out.chosen = course_.chosen_;
    out.lit = course_.lit_.id();
    out.again = course_.at()->force->attempt > 1 || trial().isRepeated();
    out.before = correcting;
    switch (trial().phase()) {
      case ForceTrial::Phase::kNone:
      case ForceTrial::Phase::kPause:
        out.phase = Phase::kPause;
        out.warm = trial().isWarm();
        break;
      case ForceTrial::Phase::kWait:
      case ForceTrial::Phase::kRise: out.phase = Phase::kFeel; break;
      case ForceTrial::Phase::kFelt: out.phase = trial().wasPushed() ? Phase::kAnswer : Phase::kFeel; break;
    }
    if (correcting) out.phase = Phase::kAnswer;
    out.waits_for_push = out.phase == Phase::kFeel && push_clock_.wait() != HoldWait::kNot;
    out.sure = out.phase == Phase::kAnswer && asks_if_sure_;
    out.asks_stop = asksStop();
    out.stops = stops_;
    state.waits = out.phase != Phase::kFeel ? HoldWait::kNot : std::max(clock_.wait(), push_clock_.wait());
    state.can_go_on = out.phase == Phase::kAnswer && !out.chosen.isEmpty();
    state.can_go_back = correcting || course_.at()->judged;
    state.force = std::move(out);
  }
  void choose(const QString& id) override {
    if (!mayAnswer()) return;
    if (asksStop() && id == QLatin1String("would_stop")) stops_ = !stops_;
    if (!course_.answerOf(id)) return;
    asks_if_sure_ = asks_if_sure_ && id == course_.chosen_;
    course_.chosen_ = id;
  }
  void next() override {
    if (course_.correcting_) return correct();
    if (endsTheSeries() && !std::exchange(asks_if_sure_, !asks_if_sure_)) {
      course_.askAnew();
      return;
    }
    judge();
  }
  void back() override { course_.correcting_ = !course_.correcting_; }
  void sampled(std::span<const haptics::Sample> samples) override {
    if (trial().phase() == ForceTrial::Phase::kNone || !course_.gate_.isSettled(course_.now_().monotonic_ns)) return;
    using Phase = ForceTrial::Phase;
    const bool unheld = clock_.add(samples, trial().phase() == Phase::kWait);
    const bool rises = trial().phase() == Phase::kRise || trial().phase() == Phase::kFelt;
    const bool unpushed = push_clock_.add(samples, rises && !trial().wasPushed(), HoldClock::WaitsFor::kPush);
    if (trial().add(samples) || unheld || unpushed) course_.look();
  }
  void pressed(ButtonPress press) override { press == ButtonPress::kTap ? course_.lightNext() : course_.answerLit(); }

 private:
  HoldClock clock_;
  HoldClock push_clock_;
  bool asks_if_sure_ = false;  ///< whether it is larger than all that she meets: the series would end
  bool stops_ = false;         ///< she would stop at this force
  bool stopped_ = false;       ///< at the force before

  ForceTrial& trial() { return course_.trial_; }
  bool asksStop() const { return course_.about().stop_question; }
  bool mayAnswer() { return course_.correcting_ || trial().wasPushed(); }
  /// Also of a catch trial, which must look the same.
  bool endsTheSeries() const {
    return course_.chosen_ == QLatin1String("beyond_practice") &&
           course_.at()->force->step.series == experiments::kAscending;
  }

  void judge() {
    experiments::ForceAnswer answer = trial().measured();
    std::optional<session::AnswerInput> input;
    if (const auto option = course_.answerOf(course_.chosen_)) {
      answer.kind = option->kind;
      if (option->kind == study::ForceJudgement::Kind::kTerm) answer.term = option->id;
      input = course_.answerInput();
      if (asksStop()) answer.would_stop = stops_;
    }
    stopped_ = stops_;
    trial().cancel();
    course_.proxy_.judge(course_.at()->step, answer, std::move(input));
  }
  void correct() {
    if (course_.chosen_ != wordOf(*course_.at()->judged) || stops_ != stopped_) {
      course_.proxy_.correctJudgement(course_.at()->step, *course_.answerOf(course_.chosen_), course_.answerInput(),
                                      asksStop() ? std::optional(stops_) : std::nullopt);
    }
    stopped_ = stops_;
    course_.correcting_ = false;
  }
};

class ParticipantController::DeviceSteps::Own final : public Step {
 public:
  using Step::Step;

  void ask() override { course_.feelOwnModel(); }
  std::string question() const override { return std::to_string(own().region()); }
  void show(ParticipantState& state) override {
    state.own = own().state(course_.hasDevice());
    state.own.chosen = course_.chosen_;
    state.can_go_on = !state.own.unavailable.isEmpty() || (state.own.ready && !course_.chosen_.isEmpty());
  }
  void choose(const QString& id) override {
    const bool compares =
        id == QLatin1String("lighter") || id == QLatin1String("right") || id == QLatin1String("heavier");
    if (id == QLatin1String("cant_tell") || (compares && own().wasFelt())) course_.chosen_ = id;
  }
  void next() override {
    if (own().isThere()) course_.proxy_.note(own().say(course_.chosen_));
    course_.passed_.own_model = !own().isThere() || own().isDone();
  }
  void sampled(std::span<const haptics::Sample> samples) override {
    const bool before = own().wasFelt();
    own().look(samples);
    if (own().wasFelt() != before) course_.look();
  }
  void pressed(ButtonPress press) override {
    if (press == ButtonPress::kTap) course_.mark();
  }

 private:
  OwnModelTrial& own() const { return *course_.own_; }
};

void ParticipantController::addDeviceSteps(ParticipantController& course, Steps& steps) {
  steps[ParticipantScreen::kDeviceCheck] = std::make_unique<DeviceSteps::Check>(course);
  steps[ParticipantScreen::kSpeed] = std::make_unique<DeviceSteps::Speed>(course);
  steps[ParticipantScreen::kForce] = std::make_unique<DeviceSteps::Force>(course);
  steps[ParticipantScreen::kOwnModel] = std::make_unique<DeviceSteps::Own>(course);
}

}  // namespace tactus::workbench
