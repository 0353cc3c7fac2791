#include "app/workbench/feel/feel_controller.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"
#include "core/fuzzy/force_model.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/render/low_pass.h"

namespace tactus::workbench {

double ForceCost::of(const OpenModel& open) {
  Shape shape = shapeOf(open.model);
  // A cost above the budget is measured again: the machine may have been busy.
  const bool known = measurements_ > 0 && shape == shape_;
  if (known && cost_s_ <= haptics::SceneSettings().largest_cost_s) return cost_s_;
  shape_ = std::move(shape);
  cost_s_ = haptics::measuredCostS(open.compiled);
  ++measurements_;
  return cost_s_;
}

ForceCost::Shape ForceCost::shapeOf(const fuzzy::ForceModel& model) {
  Shape out;
  const auto add = [&out](const std::vector<fuzzy::Term>& terms, bool of_output) {
    out.numbers.push_back(terms.size());
    for (const fuzzy::Term& term : terms) {
      out.numbers.push_back(static_cast<std::size_t>(term.shape));
      if (of_output) out.output_points.insert(out.output_points.end(), term.points.begin(), term.points.end());
    }
  };
  out.numbers.push_back(static_cast<std::size_t>(model.implication));
  for (const fuzzy::Variable& input : model.inputs) add(input.terms, false);
  add(model.output.terms, true);
  for (const fuzzy::Expert& expert : model.experts) {
    out.numbers.push_back(
        static_cast<std::size_t>(std::count_if(expert.rules.begin(), expert.rules.end(), fuzzy::takesPart)));
    for (const fuzzy::TermOverride& own : expert.overrides) add(own.terms, own.variable == model.output.id);
  }
  return out;
}

void FeelLatency::onSample(const haptics::Sample& sample) {
  for (; !pending_.empty() && pending_.front().number <= sample.orders; pending_.pop_front()) {
    EditLatency latency = value_.value_or(EditLatency{});
    latency.last_ticks = sample.tick - pending_.front().ticks_before;
    latency.longest_ticks = std::max(latency.longest_ticks, latency.last_ticks);
    value_ = latency;
  }
}

namespace {

constexpr double kEditFadeS = 0.05;    // docs/servo.md
constexpr double kGestureFadeS = 1.0;  // a patient does not move faster
// Coarser than the noise of a held hand, so that a hand at rest moves nothing on the screen.
constexpr double kFollowS = 0.1;  // of the speed that the curves follow
constexpr double kDepthStepMm = 0.1;
constexpr double kSpeedStepMmS = 1;

double rounded(double value, double step) { return std::round(value / step) * step; }

/// The model of `scene` with its values of the conditions; the hand moves the others. The difference to the
/// scene before fades out within `fade_s`. `cost_s`: of one force of the model. Refused: what the servo refuses
/// (haptics::ServoScene::make). A model must be open. It is not compiled again.
base::Result<std::shared_ptr<const haptics::ServoScene>> servoSceneOf(const SceneController& scene, double fade_s,
                                                                      double cost_s) {
  const OpenModel& open = *scene.model();
  const fuzzy::ForceModel& model = open.model;
  haptics::Conditions conditions;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (!isMovedByHand(model.inputs[i])) conditions[model.inputs[i].id] = scene.value(i);
  }
  haptics::SceneSettings settings;
  settings.fade_s = fade_s;
  settings.known_cost_s = cost_s;
  return haptics::ServoScene::make(model, open.compiled, conditions, settings);
}

}  // namespace

FeelController::FeelController(SceneController& scene, DeviceSession& session, QObject* parent)
    : QObject(parent), scene_(scene), session_(session) {
  force_.source = haptics::ForceSource::kInsertion;
  connect(&session_, &DeviceSession::began, this, &FeelController::onBegan);
  connect(&session_, &DeviceSession::beating, this, &FeelController::onBeating);
  connect(&session_, &DeviceSession::sampled, this, &FeelController::onSampled);
  connect(&session_, &DeviceSession::advanced, this, &FeelController::onAdvanced);
  connect(&session_, &DeviceSession::ending, this, &FeelController::endPlacement);
  connect(&session_, &DeviceSession::stateChanged, this, [this] {
    if (before_ && isOwnRun() && session_.state() == State::kStopped) putBack();
    emit stateChanged();
  });
  connect(&session_, &DeviceSession::failed, this, [this](const QString& sentence) {
    if (isOwnRun()) emit failed(sentence);
  });
  connect(&scene_, &SceneController::modelChanged, this, &FeelController::onAnotherModel);
  connect(&scene_, &SceneController::modelEdited, this, &FeelController::onModel);
  connect(&scene_, &SceneController::valueChanged, this, &FeelController::onValue);
  connect(this, &FeelController::handMoved, this, &FeelController::onHandMoved);
}

FeelController::~FeelController() {
  disconnect(&session_, nullptr, this, nullptr);
  if (isOwnRun()) session_.stop();
}

bool FeelController::isPosed() const {
  if (!scene_.model()) return false;
  const auto input = posedInput(scene_.procedure().get(), scene_.model()->model);
  if (!input) return false;
  const EndPoses poses = endPoses(scene_.model()->model.inputs[*input]);
  return scene_.value(*input) > (poses.first + poses.last) / 2;
}

// The user had chosen this speed and this pose for the plots.
void FeelController::keepPlace() {
  if (before_ || !scene_.model()) return;
  Before before;
  before.pose_set = pose_set_;
  const fuzzy::ForceModel& model = scene_.model()->model;
  for (const auto& input : {fuzzy::rateOf(model.inputs), posedInput(scene_.procedure().get(), model)}) {
    if (input) before.values[*input] = scene_.value(*input);
  }
  before_ = std::move(before);
}

void FeelController::putBack() {
  const Before before = *std::exchange(before_, std::nullopt);
  if (!scene_.model()) return;
  for (const auto& [input, value] : before.values) scene_.setValue(input, value);
  pose_set_ = before.pose_set;
}

void FeelController::start(const QString& id) {
  if (session_.state() == State::kStopped) keepPlace();
  restPoseAtFirst();
  if (!prepare()) return;
  recorded_ = {};
  session_.start(id, force_, this);
}

void FeelController::startReplay(std::unique_ptr<haptics::HapticDevice> device, RecordedForce recorded) {
  if (session_.state() == State::kStopped) keepPlace();
  if (!prepare()) return;
  recorded_ = std::move(recorded);
  session_.startReplay(std::move(device), force_, this);
}

/// The scene for a run that is about to begin.
bool FeelController::prepare() {
  if (!scene_.model()) {
    emit failed(tr("No model is open; open one to feel it."));
    return false;
  }
  if (session_.state() != State::kStopped && !isOwnRun()) {
    emit failed(tr("Another part of the program uses the device; stop it there first."));
    return false;
  }
  if (isRunning()) stop();
  if (state() != State::kStopped) return true;  // the session says why it does not start
  auto servo_scene = servoScene(kEditFadeS);
  if (!servo_scene) {
    emit failed(text(servo_scene.error().message()));
    return false;
  }
  depth_offset_mm_ = (*servo_scene)->renderer().depth_offset_mm;
  force_.scene = std::move(*servo_scene);
  force_.scale = deviceScaleOf(scene_.procedure());
  ++force_.placement;
  conditions_new_ = false;
  return true;
}

void FeelController::onBegan() {
  if (!isOwnRun()) return;
  history_.clear();
  history_.setRecorded(std::exchange(recorded_, {}));
  latency_ = {};
  placement_orders_ = 1;
  meter_.begin(placement_orders_);
}

void FeelController::stop() { session_.stop(); }

void FeelController::newPlacement() {
  if (!isRunning()) return;
  session_.beat();
  if (!isRunning()) return;  // a replay may have come to its end
  endPlacement();
  ++force_.placement;
  placement_orders_ = *session_.setForce(force_);
  meter_.begin(placement_orders_);
}

void FeelController::newPlacementAt(double depth_mm) {
  force_.start_depth_mm = depth_mm - depth_offset_mm_;
  newPlacement();
  force_.start_depth_mm = 0;  // of the next one
}

void FeelController::setPosed(bool posed) {
  if (!scene_.model()) return;
  const auto input = posedInput(scene_.procedure().get(), scene_.model()->model);
  if (!input) return;
  const EndPoses poses = endPoses(scene_.model()->model.inputs[*input]);
  pose_set_ = true;
  posing_ = true;
  scene_.setValue(*input, posed ? poses.last : poses.first);
  posing_ = false;
}

void FeelController::restPoseAtFirst() {
  if (pose_set_) return;
  resting_ = true;
  setPosed(false);
  resting_ = false;
}

void FeelController::setFollowsHand(bool follows) { follows_hand_ = follows; }

FeelController::Shown FeelController::shown() const {
  const haptics::Sample& sample = latest();
  const bool inwards = sample.phase == render::Phase::kSlidingIn;
  return {rounded(depthMm(), kDepthStepMm),
          inwards ? std::max(0.0, rounded(sample.slip_speed_mm_s, kSpeedStepMmS)) : 0};
}

void FeelController::onBeating() {
  if (!isOwnRun()) return;
  if (conditions_new_) postScene(kEditFadeS);
  shown_before_ = shown();
}

void FeelController::onSampled(std::span<const haptics::Sample> samples) {
  if (!isOwnRun()) return;
  for (const haptics::Sample& sample : samples) {
    history_.add(sample);
    meter_.add(sample, sample.depth_mm + depth_offset_mm_);
    latency_.onSample(sample);
  }
  emit sampled(samples);
}

void FeelController::onAdvanced() {
  if (!isOwnRun()) return;
  if (const Shown now = shown(); now != shown_before_) emit handMoved(now.depth_mm, now.speed_mm_s);
  followSpeed();
  emit advanced();
}

void FeelController::onModel() {
  if (isFelt()) postScene(kEditFadeS);
}

// The felt model is the shown model: the force of the previous model must stop.
void FeelController::onAnotherModel() {
  before_.reset();
  if (isFelt() && !postScene(kEditFadeS)) stop();
}

void FeelController::onValue(std::size_t input) {
  const fuzzy::ForceModel& model = scene_.model()->model;
  if (input == posedInput(scene_.procedure().get(), model)) {
    pose_set_ = true;
    if (before_ && !resting_) {  // by the user: it stays
      before_->values.erase(input);
      before_->pose_set = true;
    }
    emit poseChanged();
  }
  if (!isFelt() || isMovedByHand(model.inputs[input])) return;
  if (posing_) {
    postScene(kGestureFadeS);
  } else {
    conditions_new_ = true;
  }
}

void FeelController::onHandMoved(double depth_mm) {
  if (!follows_hand_) return;
  if (const auto depth = fuzzy::wayOf(scene_.model()->model.inputs)) scene_.setValue(*depth, depth_mm);
}

// The whole curve moves with the speed; unsmoothed it would flicker. The force on the hand knows nothing of this.
void FeelController::followSpeed() {
  const auto speed = fuzzy::rateOf(scene_.model()->model.inputs);
  const double elapsed_s = static_cast<double>(latest().time_ns - std::exchange(followed_ns_, latest().time_ns)) * 1e-9;
  if (!follows_hand_ || !speed || elapsed_s <= 0) return;
  const double hand = shown().speed_mm_s;
  followed_mm_s_ = hand + (followed_mm_s_ - hand) * render::decay(elapsed_s, kFollowS);
  scene_.setValue(*speed, rounded(followed_mm_s_, kSpeedStepMmS));
}

base::Result<std::shared_ptr<const haptics::ServoScene>> FeelController::servoScene(double fade_s) {
  return servoSceneOf(scene_, fade_s, cost_.of(*scene_.model()));
}

bool FeelController::postScene(double fade_s) {
  const std::uint64_t ticks_before = session_.ticks();
  conditions_new_ = false;
  auto servo_scene = servoScene(fade_s);
  if (!servo_scene) {
    emit failed(tr("The device does not render the edit: %1").arg(text(servo_scene.error().message())));
    return false;
  }
  depth_offset_mm_ = (*servo_scene)->renderer().depth_offset_mm;
  force_.scene = std::move(*servo_scene);
  force_.scale = deviceScaleOf(scene_.procedure());
  if (const auto orders = session_.setForce(force_)) latency_.posted(*orders, ticks_before);
  return true;
}

void FeelController::endPlacement() {
  if (!isOwnRun()) return;
  auto summary = meter_.summary();
  meter_.begin(0);
  if (!summary) return;
  summary->simulated = device()->simulated;
  summary->replay = isReplay();
  last_placement_ = summary;
  emit placementEnded();
}

}  // namespace tactus::workbench
