#include "app/workbench/feel/feel_controller.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/feel/feel_run.h"
#include "app/workbench/feel/feel_scene.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "core/base/check.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::workbench {
namespace {

constexpr int kBeatMs = 16;            // the refresh of a screen
constexpr int kLookMs = 30;            // while a device starts or stops
constexpr double kEditFadeS = 0.05;    // docs/servo.md
constexpr double kGestureFadeS = 1.0;  // a neck is not flexed faster
// Coarser than the noise of a held hand, so that a hand at rest moves nothing on the screen.
constexpr double kDepthStepMm = 0.1;
constexpr double kSpeedStepMmS = 1;

double rounded(double value, double step) { return std::round(value / step) * step; }

QString sentenceCase(QString sentence) {
  if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
  return sentence;
}

}  // namespace

FeelSettings realFeel() {
  // A device behind a driver may take seconds; the virtual one is there at once.
  FeelSettings settings;
  settings.open_device = [](const std::string& id) { return devices::open(id, devices::settingsOfProcess()); };
  settings.make_loop = threadedLoop;
  settings.is_slow = [](const std::string& id) { return id != "virtual"; };
  return settings;
}

FeelController::FeelController(SceneController& scene, FeelSettings settings, QObject* parent)
    : QObject(parent), scene_(scene), settings_(std::move(settings)) {
  beat_.setInterval(kBeatMs);
  beat_.setTimerType(Qt::PreciseTimer);
  look_.setInterval(kLookMs);
  connect(&beat_, &QTimer::timeout, this, &FeelController::beat);
  connect(&look_, &QTimer::timeout, this, &FeelController::lookAtDevice);
  connect(&scene_, &SceneController::modelChanged, this, &FeelController::onAnotherModel);
  connect(&scene_, &SceneController::modelEdited, this, &FeelController::onModel);
  connect(&scene_, &SceneController::valueChanged, this, &FeelController::onValue);
  connect(this, &FeelController::handMoved, this, &FeelController::onHandMoved);
}

FeelController::~FeelController() =
    default;  // without force: a run that goes on ends, and a device that stops is waited for

std::optional<haptics::DeviceInfo> FeelController::device() const {
  if (!run_) return std::nullopt;
  return run_->info();
}

bool FeelController::isHandLive() const { return run_ && run_->liveHand() != nullptr; }

QString FeelController::axisAdvice() const {
  return run_ && run_->info().position_axes > 1 ? text(run_->axisAdvice()) : QString();
}

QString FeelController::priorityText() const { return run_ ? run_->loop().priorityText() : QString(); }

double FeelController::depthMm() const { return latest_.depth_mm + depth_offset_mm_; }

haptics::LoopStatistics FeelController::statistics() const {
  return run_ ? run_->servo().statistics() : haptics::LoopStatistics{};
}

bool FeelController::isNeckFlexed() const {
  if (!scene_.model()) return false;
  const auto& inputs = scene_.model()->model.inputs;
  const auto input = inputNamed(scene_.model()->model, kNeckFlexionId);
  const auto postures = input ? neckPostures(inputs[*input]) : std::nullopt;
  return postures && scene_.value(*input) > (postures->upright + postures->flexed) / 2;
}

void FeelController::start(const QString& id) {
  const std::string device = id.toStdString();
  startOn({[open_device = settings_.open_device, device] { return open_device(device); },
           settings_.is_slow && settings_.is_slow(device),
           false,
           {}});
}

void FeelController::startReplay(std::unique_ptr<haptics::HapticDevice> device, RecordedForce recorded) {
  // A function can be copied, a device cannot.
  const auto opened = std::make_shared<devices::OpenedDevice>();
  opened->device = std::move(device);
  startOn({[opened]() -> base::Result<devices::OpenedDevice> { return std::move(*opened); }, false, true,
           std::move(recorded)});
}

void FeelController::startOn(Beginning beginning) {
  TACTUS_CHECK(scene_.model() != nullptr);
  if (run_) stop();
  if (state_ != FeelState::kStopped) {
    emit failed(tr("The device before is still starting or stopping; try again when it has stopped."));
    return;
  }
  auto servo_scene = servoSceneOf(scene_, kEditFadeS);
  if (!servo_scene) {
    emit failed(text(servo_scene.error().message()));
    return;
  }
  haptics::ServoOrders orders;
  orders.source = haptics::ForceSource::kInsertion;
  orders.armed = true;
  orders.scene = std::move(*servo_scene);
  orders.placement = ++placements_;
  depth_offset_mm_ = orders.scene->renderer().depth_offset_mm;
  slow_ = beginning.slow;
  const auto open =
      [open_device = beginning.open, make_loop = settings_.make_loop, grip = grip_, replay = beginning.replay,
       thermal = settings_.thermal](haptics::ServoOrders given) -> base::Result<std::unique_ptr<FeelRun>> {
    auto opened = open_device();
    if (!opened) return tl::unexpected(opened.error());
    given.enable = replay ? enableOfReplay() : enableOf(opened->device->info(), grip);
    return FeelRun::begin(std::move(*opened), make_loop, std::move(given), thermal);
  };
  if (!slow_) {
    begin(open(std::move(orders)), beginning.replay, std::move(beginning.recorded));
    return;
  }
  opening_ = std::async(std::launch::async, open, std::move(orders));
  enter(FeelState::kOpening);
  look_.start();
}

void FeelController::begin(base::Result<std::unique_ptr<FeelRun>> run, bool replay, RecordedForce recorded) {
  if (!run) {
    if (state_ != FeelState::kStopped) enter(FeelState::kStopped);
    emit failed(text(run.error().message()));
    return;
  }
  const bool waited = state_ == FeelState::kOpening;
  run_ = std::move(*run);
  replay_ = replay;
  ++runs_;
  latest_ = {};
  history_.clear();
  history_.setRecorded(std::move(recorded));
  latency_ = {};
  loop_watch_ = {};
  conditions_new_ = false;
  trip_.reset();
  held_ = false;
  target_mm_ = 0;
  placement_orders_ = 1;
  meter_.begin(placement_orders_);
  arming_ = 0;
  beat_.start();
  emit tripChanged();
  enter(FeelState::kRunning);
  if (!waited) return;
  // What changed while the device started.
  run_->orders().enable = enableOf(run_->info(), grip_);
  postScene(kEditFadeS);
}

void FeelController::stop() {
  if (state_ == FeelState::kOpening) {
    // It is ended as soon as it has started; its first orders are armed, but no hand has taken the tube.
    enter(FeelState::kStopping);
    return;
  }
  if (!run_) return;
  beat_.stop();
  run_->servo().stop();
  if (!slow_) run_->end();
  takeAll(run_->drain());
  endPlacement();
  if (slow_) {
    endInBackground(std::move(run_));
    look_.start();
  }
  run_.reset();
  latest_.force_n = latest_.source_force_n = latest_.model_force_n = latest_.stretch_mm = 0;
  latest_.phase = render::Phase::kReleased;
  latest_.enabled = false;
  held_ = false;
  enter(slow_ ? FeelState::kStopping : FeelState::kStopped);
}

void FeelController::endInBackground(std::unique_ptr<FeelRun> run) {
  // Its destructor stops loop and device.
  ending_ = std::async(
      std::launch::async, [](std::unique_ptr<FeelRun> last) { last.reset(); }, std::move(run));
}

void FeelController::lookAtDevice() {
  const auto ready = [](const auto& future) {
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  if (ready(opening_)) {
    auto run = opening_.get();
    if (state_ == FeelState::kOpening) {
      look_.stop();
      begin(std::move(run), false, {});
    } else if (run) {
      endInBackground(std::move(*run));
    } else {
      look_.stop();
      enter(FeelState::kStopped);
    }
  } else if (ready(ending_)) {
    look_.stop();
    ending_.get();
    enter(FeelState::kStopped);
  }
}

void FeelController::setGrip(const FeelGrip& grip) {
  if (grip == grip_) return;
  grip_ = grip;
  setHeld(false);
  if (run_ && !replay_) {
    run_->orders().enable = enableOf(run_->info(), grip_);
    run_->post();
  }
  emit stateChanged();
}

void FeelController::rearm() {
  if (state_ != FeelState::kTripped) return;
  run_->orders().armed = false;
  arming_ = run_->post();
  enter(FeelState::kRearming);
}

void FeelController::newPlacement() {
  if (!run_) return;
  beat();
  if (!run_) return;  // a replay may have come to its end
  endPlacement();
  run_->orders().placement = ++placements_;
  placement_orders_ = run_->post();
  meter_.begin(placement_orders_);
}

void FeelController::setHeld(bool held) {
  held_ = held && run_ != nullptr;
  if (run_) run_->servo().pedal(held_);
}

void FeelController::setTarget(double position_mm) {
  target_mm_ = position_mm;
  if (isHandLive()) run_->liveHand()->setTarget(position_mm);
}

void FeelController::setNeckFlexed(bool flexed) {
  if (!scene_.model()) return;
  const auto input = inputNamed(scene_.model()->model, kNeckFlexionId);
  const auto postures = input ? neckPostures(scene_.model()->model.inputs[*input]) : std::nullopt;
  if (!postures) return;
  flexing_ = true;
  scene_.setValue(*input, flexed ? postures->flexed : postures->upright);
  flexing_ = false;
}

void FeelController::setFollowsHand(bool follows) { follows_hand_ = follows; }

void FeelController::beat() {
  if (!run_) return;
  run_->heartbeat();
  if (conditions_new_) postScene(kEditFadeS);
  const double depth_before_mm = rounded(depthMm(), kDepthStepMm);
  const auto speedOf = [](const haptics::Sample& sample) {
    return sample.phase == render::Phase::kSlidingIn ? std::max(0.0, rounded(sample.slip_speed_mm_s, kSpeedStepMmS))
                                                     : 0;
  };
  const double speed_before_mm_s = speedOf(latest_);
  const auto samples = run_->drain();
  takeAll(samples);
  if (!watchLoop()) return;
  watchTrip();
  watchRelease();
  if (samples.empty()) return;
  const double depth_mm = rounded(depthMm(), kDepthStepMm);
  const double speed_mm_s = speedOf(latest_);
  if (depth_mm != depth_before_mm || speed_mm_s != speed_before_mm_s) emit handMoved(depth_mm, speed_mm_s);
  emit advanced();
}

void FeelController::onModel() {
  if (run_) postScene(kEditFadeS);
}

// What is felt is what is shown: the force of the model before must not go on.
void FeelController::onAnotherModel() {
  if (run_ && !postScene(kEditFadeS)) stop();
}

void FeelController::onValue(std::size_t input) {
  const std::string& id = scene_.model()->model.inputs[input].id;
  if (id == kNeckFlexionId) emit neckChanged();
  if (!run_ || id == kDepthId || id == kSpeedId) return;
  if (flexing_) {
    postScene(kGestureFadeS);
  } else {
    conditions_new_ = true;
  }
}

void FeelController::onHandMoved(double depth_mm, double speed_mm_s) {
  if (!follows_hand_) return;
  const fuzzy::ForceModel& model = scene_.model()->model;
  if (const auto speed = inputNamed(model, kSpeedId)) scene_.setValue(*speed, speed_mm_s);
  if (const auto depth = inputNamed(model, kDepthId)) scene_.setValue(*depth, depth_mm);
}

bool FeelController::postScene(double fade_s) {
  const std::uint64_t ticks_before = run_->servo().ticks();
  conditions_new_ = false;
  auto servo_scene = servoSceneOf(scene_, fade_s);
  if (!servo_scene) {
    emit failed(tr("The edit is not felt: %1").arg(text(servo_scene.error().message())));
    return false;
  }
  depth_offset_mm_ = (*servo_scene)->renderer().depth_offset_mm;
  run_->orders().scene = std::move(*servo_scene);
  latency_.posted(run_->post(), ticks_before);
  return true;
}

void FeelController::takeAll(std::span<const haptics::Sample> samples) {
  for (const haptics::Sample& sample : samples) take(sample);
  if (!samples.empty()) emit sampled(samples);
}

void FeelController::take(const haptics::Sample& sample) {
  latest_ = sample;
  history_.add(sample);
  meter_.add(sample, depthMm());
  latency_.take(sample);
}

void FeelController::watchTrip() {
  // A sample from before the arming still tells of the trip that it cleared.
  const bool armed = state_ == FeelState::kRunning && latest_.orders >= arming_;
  if (armed && latest_.trip != haptics::TripCause::kNone) {
    const std::string_view cause = haptics::describe(latest_.trip);
    trip_ = FeelTrip{sentenceCase(text(std::string(cause))), QTime::currentTime()};
    enter(FeelState::kTripped);
    emit tripChanged();
  }
  // The record of the trip, which knows value and limit, is complete 0.2 s after it.
  if (const auto record = run_->servo().takeFlightRecord(); record && trip_) {
    trip_->sentence = sentenceCase(text(haptics::sentence(record->trip)));
    const bool uncalibrated = record->trip.cause == haptics::TripCause::kDeviceFault &&
                              record->trip.value == static_cast<double>(haptics::DeviceFault::kNotCalibrated);
    if (uncalibrated) trip_->sentence += QStringLiteral("; ") + text(run_->calibrationAdvice());
    emit tripChanged();
  }
}

/// A servo that is not called cannot trip, and nothing that is asked for arrives: false ends the run.
bool FeelController::watchLoop() {
  const haptics::Trip silent = loop_watch_.look(run_->servo().ticks(), run_->loop().nowNs());
  if (!silent) return true;
  stop();
  emit failed(
      tr("The loop of the device's driver has ended: %1. Look at cable and supply of the device, then start again.")
          .arg(text(haptics::sentence(silent))));
  return false;
}

void FeelController::watchRelease() {
  if (state_ != FeelState::kRearming || latest_.orders < arming_) return;
  if (isDown(run_->orders().enable, latest_, held_)) return;
  run_->orders().armed = true;
  arming_ = run_->post();
  trip_.reset();
  emit tripChanged();
  enter(FeelState::kRunning);
}

void FeelController::endPlacement() {
  auto summary = meter_.summary();
  meter_.begin(0);
  if (!summary) return;
  summary->simulated = run_->info().simulated;
  summary->replay = replay_;
  last_placement_ = summary;
  emit placementEnded();
}

void FeelController::enter(FeelState state) {
  state_ = state;
  emit stateChanged();
}

}  // namespace tactus::workbench
