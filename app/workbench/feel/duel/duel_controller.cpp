#include "app/workbench/feel/duel/duel_controller.h"

#include <QTimer>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/feel/procedure.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/shown_procedure.h"
#include "app/workbench/study/connection/study_connection.h"
#include "experiments/two_interval.h"

namespace tactus::workbench {
namespace {

using base::Result;
using experiments::DuelForce;
using experiments::DuelRun;
using study::DuelRule;

// The tube starts this far in front of the way, so that the hand has overcome the static friction at its beginning.
constexpr double kLeadMm = 5;
constexpr double kLeastMoveMm = 1;  // a hand that lets go before has not begun
constexpr int kOwnJndTrials = 40;
constexpr double kSPerNs = 1e-9;
// A stroke with less than the model's force says nothing of the model.
constexpr std::uint32_t kHoldsBack = haptics::kLimitedByCap | haptics::kLimitedByFadeIn | haptics::kLimitedByThermal |
                                     haptics::kLimitedByStaleDevice | haptics::kLimitedByGui | haptics::kLimitedByGap;

std::vector<double> pointOf(const DuelSetup& setup) {
  std::vector<double> point;
  for (const fuzzy::Variable& input : setup.a->model.inputs) {
    const auto found = setup.conditions.find(input.id);
    point.push_back(fuzzy::roleOf(input) == fuzzy::Role::kRate ? setup.speed_mm_s
                    : found == setup.conditions.end()          ? 0
                                                               : found->second);
  }
  return point;
}

/// The rms of F / JND(F) along the stroke: a force that grows by the share x differs by x times this.
double jndsOf(const DuelSetup& setup) {
  const auto depth = fuzzy::wayOf(setup.a->model.inputs);
  auto twice = editing::ready(withScaledForce(setup.a->model, 2));
  if (!depth || !twice) return 0;
  return elicitation::strokeDifference(setup.a->compiled, (*twice)->compiled, pointOf(setup), *depth, setup.from_mm,
                                       setup.to_mm)
      .rms_jnd;
}

}  // namespace

fuzzy::ForceModel withScaledForce(fuzzy::ForceModel model, double factor) {
  const auto scale = [factor](std::vector<fuzzy::Term>& terms) {
    for (fuzzy::Term& term : terms) {
      for (double& point : term.points) point *= factor;
    }
  };
  model.output.min *= factor;
  model.output.max *= factor;
  model.default_force_n *= factor;
  scale(model.output.terms);
  for (fuzzy::Expert& expert : model.experts) {
    for (fuzzy::TermOverride& own : expert.overrides) {
      if (own.variable == model.output.id) scale(own.terms);
    }
  }
  return model;
}

std::optional<DuelForecast> duelForecast(const DuelSetup& setup) {
  const auto depth = fuzzy::wayOf(setup.a->model.inputs);
  if (!depth || !(setup.to_mm > setup.from_mm)) return std::nullopt;
  DuelForecast out;
  out.difference = elicitation::strokeDifference(setup.a->compiled, setup.b->compiled, pointOf(setup), *depth,
                                                 setup.from_mm, setup.to_mm);
  if (out.difference.places == 0) return std::nullopt;
  const double share = experiments::shareRight(out.difference.rms_jnd);
  if (const auto test = experiments::smallestTest(share)) out.test = *test;
  return out;
}

DuelController::DuelController(DeviceSession& device, StudyConnection& study, const FeelStore& felt, QObject* parent)
    : QObject(parent), device_(device), study_(study), felt_(felt) {
  connect(&device_, &DeviceSession::stateChanged, this, &DuelController::onState);
  connect(&device_, &DeviceSession::sampled, this, &DuelController::look);
  connect(&device_, &DeviceSession::advanced, this, [this] {
    if (device_.user() == this) emit moved();
  });
  connect(&device_, &DeviceSession::failed, this, [this](const QString& sentence) {
    if (device_.user() != this || state_ == State::kIdle || state_ == State::kDone) return;
    enter(State::kInterrupted);
    emit failed(sentence);
  });
}

DuelController::~DuelController() {
  disconnect(&device_, nullptr, this, nullptr);
  if (device_.user() == this) device_.stop();
}

Result<std::shared_ptr<const haptics::ServoScene>> DuelController::sceneOf(const DuelForce& force) const {
  if (force.heavier_jnd == 0) return force.is_b ? scene_b_ : scene_a_;
  TACTUS_TRY(const auto heavier, editing::ready(withScaledForce(setup_.a->model, 1 + force.heavier_jnd * per_jnd_)));
  haptics::SceneSettings settings;
  settings.known_cost_s = scene_a_->costS();
  return haptics::ServoScene::make(heavier->model, heavier->compiled, setup_.conditions, settings);
}

Result<void> DuelController::prepare(const DuelSetup& setup) {
  if (device_.state() != DeviceSession::State::kStopped) {
    return base::fail(base::ErrorCode::kData, tr("the device").toStdString(), tr("in use").toStdString(),
                      tr("a device that is stopped").toStdString());
  }
  setup_ = setup;
  TACTUS_TRY(scene_a_, haptics::ServoScene::make(setup.a->model, setup.a->compiled, setup.conditions));
  TACTUS_TRY(scene_b_, haptics::ServoScene::make(setup.b->model, setup.b->compiled, setup.conditions));
  const double jnds = jndsOf(setup);
  per_jnd_ = jnds > 0 ? 1 / jnds : 0;
  strokes_[0] = strokes_[1] = 0;
  ended_ns_.reset();
  return {};
}

Result<void> DuelController::begin(const DuelSetup& setup, const QString& id, std::uint64_t seed) {
  if (auto ok = prepare(setup); !ok) return tl::unexpected(ok.error());
  const auto forecast = duelForecast(setup);
  study::DuelStart start;
  start.entry = entry();
  start.a = setup.a_name;
  start.b = setup.rule == DuelRule::kOwnJnd ? setup.a_name : setup.b_name;
  start.question = setup.question;
  start.rule = setup.rule;
  start.from_mm = setup.from_mm;
  start.to_mm = setup.to_mm;
  start.speed_mm_s = setup.speed_mm_s;
  start.seed = seed;
  start.setting.conditions = setup.conditions;
  start.setting.model = setup.a_name.name;
  start.setting.model_version = setup.a_name.version;
  if (setup.rule == DuelRule::kOwnJnd) {
    start.trials = kOwnJndTrials;
  } else if (!forecast || !forecast->test) {
    return base::fail(base::ErrorCode::kData, tr("the two models").toStdString(),
                      tr("no difference that a hand could feel").toStdString(),
                      tr("another stroke, or other versions").toStdString());
  } else {
    start.predicted_jnd = forecast->difference.rms_jnd;
    start.sought_jnd = forecast->difference.rms_jnd;
    start.expects_b = setup.question == study::DuelQuestion::kMoreReal || forecast->difference.mean_n > 0;
    start.trials = setup.rule == DuelRule::kFixed
                       ? forecast->test->trials
                       : std::max(experiments::kMostSequentialTrials, 2 * forecast->test->trials);
  }
  TACTUS_TRY(auto run, DuelRun::create(start));
  run_ = std::move(run);
  resumed_ = false;
  kept_ = study_.takesOrders();
  this->start(id);
  return {};
}

Result<void> DuelController::resume(const DuelSetup& setup, const store::StoredDuel& stored, const QString& id) {
  DuelSetup as_before = setup;
  as_before.conditions = stored.start.setting.conditions;
  as_before.from_mm = stored.start.from_mm;
  as_before.to_mm = stored.start.to_mm;
  as_before.speed_mm_s = stored.start.speed_mm_s;
  if (auto ok = prepare(as_before); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(auto run, DuelRun::create(stored.start, stored.answers));
  run_ = std::move(run);
  resumed_ = true;
  kept_ = study_.takesOrders();
  start(id);
  return {};
}

void DuelController::start(const QString& id) {
  device_id_ = id;
  enter(State::kStarting);
  ForceOrders nothing;
  device_.start(id, nothing, this);
}

void DuelController::onState() {
  if (device_.user() != this || state_ == State::kIdle || state_ == State::kDone) return;
  switch (device_.state()) {
    case DeviceSession::State::kRunning:
      if (state_ != State::kStarting && state_ != State::kInterrupted) return;
      if (visit_.run != device_.runs()) {
        const haptics::DeviceInfo info = *device_.device();
        visit_ = {device_.runs(), felt_.who(),    study::momentNow(), deviceText(info),
                  info.id,        info.simulated, info.friction_in_n};
        if (!std::exchange(resumed_, true)) {
          study::DuelStart start = run_->start();
          start.setting.device = visit_.device;
          start.setting.simulated = info.simulated;
          start.gives_force = !info.simulated && info.max_force_n > 0;
          run_ = *DuelRun::create(start);
          keep(start);
        }
      }
      takeNext();
      return;
    case DeviceSession::State::kStopped:
    case DeviceSession::State::kTripped: enter(State::kInterrupted); return;
    case DeviceSession::State::kOpening:
    case DeviceSession::State::kRearming:
    case DeviceSession::State::kStopping: return;
  }
}

// No force until the next stroke.
void DuelController::free() {
  orders_ = 0;
  device_.setForce({});
}

void DuelController::takeNext() {
  free();
  began_mm_.reset();
  began_ns_.reset();
  if (run_->stage() == DuelRun::Stage::kFinished) {
    keep(endOf(*run_));
    enter(State::kDone);
    device_.stop();
  } else if (run_->stage() == DuelRun::Stage::kQuestion) {
    asked_ns_ = device_.latest().time_ns;
    enter(State::kQuestion);
  } else {
    enter(run_->restFirst() && state_ == State::kQuestion ? State::kRest : State::kLetGo);
  }
}

void DuelController::giveStroke() {
  const auto scene = sceneOf(run_->felt());
  if (!scene) {
    emit failed(text(scene.error().message()));
    QTimer::singleShot(0, this, &DuelController::stop);  // the device is handing out its samples
    return;
  }
  offset_mm_ = (*scene)->renderer().depth_offset_mm;
  ForceOrders force;
  force.source = haptics::ForceSource::kInsertion;
  force.scene = *scene;
  force.scale = deviceScaleOf(shownProcedure());
  force.placement = device_.newNumber();
  force.start_depth_mm = run_->start().from_mm - kLeadMm - offset_mm_;
  orders_ = device_.setForce(force).value_or(0);
  enter(State::kPush);
}

std::optional<double> DuelController::depthMm() const {
  if (state_ != State::kPush) return std::nullopt;
  return device_.latest().depth_mm + offset_mm_;
}

std::optional<double> DuelController::promptMm() const {
  if (state_ != State::kPush || !began_ns_) return std::nullopt;
  const study::DuelStart& start = run_->start();
  const double passed_s = static_cast<double>(device_.latest().time_ns - *began_ns_) * kSPerNs;
  return std::min(start.to_mm, start.from_mm + passed_s * start.speed_mm_s);
}

void DuelController::look(std::span<const haptics::Sample> samples) {
  if (device_.user() != this) return;
  for (const haptics::Sample& sample : samples) onSample(sample);
}

void DuelController::onSample(const haptics::Sample& sample) {
  if (state_ == State::kLetGo && !sample.enabled) return giveStroke();
  if (state_ != State::kPush || sample.orders < orders_ || sample.source != haptics::ForceSource::kInsertion) return;
  const double depth_mm = sample.depth_mm + offset_mm_;
  if (!sample.enabled) {
    if (began_mm_ && depth_mm > *began_mm_ + kLeastMoveMm) endStroke(depth_mm, sample.time_ns);
    return;
  }
  if (!began_mm_) {
    began_mm_ = depth_mm;
    held_back_ = false;
  }
  if (!began_ns_ && depth_mm >= run_->start().from_mm) began_ns_ = sample.time_ns;
  if (began_ns_ && (sample.limited & kHoldsBack) != 0) held_back_ = true;
  if (depth_mm >= run_->start().to_mm) endStroke(depth_mm, sample.time_ns);
}

void DuelController::endStroke(double reached_mm, std::int64_t time_ns) {
  if (held_back_) {
    free();
    began_mm_.reset();
    began_ns_.reset();
    return enter(State::kLetGo);
  }
  const study::DuelStart& start = run_->start();
  experiments::DuelStroke stroke;
  stroke.from_mm = *began_mm_;
  stroke.to_mm = reached_mm;
  if (began_ns_ && time_ns > *began_ns_) {
    stroke.mean_mm_s =
        (std::min(reached_mm, start.to_mm) - start.from_mm) / (static_cast<double>(time_ns - *began_ns_) * kSPerNs);
  }
  if (ended_ns_ && began_ns_) stroke.pause_s = static_cast<double>(*began_ns_ - *ended_ns_) * kSPerNs;
  ended_ns_ = time_ns;
  const DuelForce force = run_->felt();
  if (auto record = run_->stroke(stroke)) {
    keep(std::move(*record));
  } else if (force.heavier_jnd == 0) {
    ++strokes_[force.is_b ? 1 : 0];
  }
  takeNext();
}

void DuelController::answer(study::DuelChoice choice) {
  if (state_ != State::kQuestion) return;
  keep(run_->answer(choice, static_cast<double>(device_.latest().time_ns - asked_ns_) * kSPerNs));
  takeNext();
}

void DuelController::goOn() {
  if (state_ == State::kRest) {
    takeNext();
  } else if (state_ == State::kInterrupted && device_.state() == DeviceSession::State::kTripped) {
    device_.rearm();
  } else if (state_ == State::kInterrupted && device_.state() == DeviceSession::State::kStopped) {
    start(device_id_);
  }
}

void DuelController::stop() {
  if (state_ == State::kIdle) return;
  enter(State::kIdle);
  if (device_.user() == this) device_.stop();
}

std::optional<editing::Felt> DuelController::feltOpenModel() const {
  if (!run_ || !run_->start().gives_force || !setup_.open_is_b) return std::nullopt;
  editing::Felt out;
  out.strokes = strokes_[*setup_.open_is_b ? 1 : 0];
  if (out.strokes == 0) return std::nullopt;
  out.device = run_->start().setting.device;
  const auto depth = fuzzy::wayOf(setup_.a->model.inputs);
  for (const DepthRegion& region : depthRegions(setup_.a->model.inputs[*depth])) {
    if (region.to_mm > setup_.from_mm && region.from_mm < setup_.to_mm)
      out.regions.push_back(region.label.toStdString());
  }
  return out;
}

void DuelController::enter(State state) {
  state_ = state;
  emit changed();
}

study::Entry DuelController::entry() {
  study::Entry out;
  out.id = ids_.next();
  out.when = study::momentNow();
  out.entered_by = felt_.who() ? study::EnteredBy::kParticipant : study::EnteredBy::kResearcher;
  return out;
}

template <class Record>
void DuelController::keep(Record record) {
  if (!kept_) return;
  if (!study_.takesOrders()) {  // closed since
    kept_ = false;
    return;
  }
  if constexpr (!std::is_same_v<Record, study::DuelStart>) record.entry = entry();
  const auto shared = std::make_shared<Record>(std::move(record));
  study_.order(
      [shared, visit = visit_, sessions = sessions_](store::StudyFile& file, study::RecordIds& ids) -> Result<void> {
        TACTUS_TRY(shared->entry.session, sessions->sessionOf(visit, file, ids));
        return store::append(file, *shared);
      },
      {},
      [this](const QString& sentence) {
        kept_ = false;
        emit failed(DuelController::tr("The comparison is not kept in the study: %1").arg(sentence));
      });
}

}  // namespace tactus::workbench
