#include "app/workbench/session/setup_check.h"

#include <QElapsedTimer>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/session/judged_forces.h"
#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/check_in.h"
#include "app/workbench/participant/consent_text.h"
#include "core/base/files/file.h"

namespace tactus::workbench {
namespace {

using session::SetupItem;

constexpr double kNewtonsPerGram = 9.80665e-3;
constexpr std::uint64_t kLatencyTicks = 4000;  // 4 s
constexpr double kMissedShare = 1e-3;
constexpr double kLateMs = 1;  // of 99 % of the ticks
constexpr double kMillisecond = 1e-6;
constexpr QSize kLeastScreen(1280, 720);
constexpr double kLeastRoomGb = 0.5;
constexpr int kSlowestStoreMs = 500;
constexpr std::size_t kStoredBytes = 64 * 1024;

QString ms(double value) { return numberText(std::round(value * 100) / 100); }

/// What a look at the study and its disk has found.
struct StudyLook {
  base::Result<ParticipantPlan> plan;
  double room_gb = 0;
  QString not_stored;  ///< why a file beside the study could not be written; empty: it could
  qint64 store_ms = 0;
};

StudyLook lookAt(const store::StudyFile& file) {
  StudyLook out{participantPlan(file), 0, {}, 0};
  const std::filesystem::path study = file.path();
  std::error_code error;
  const auto space = std::filesystem::space(study.parent_path().empty() ? "." : study.parent_path(), error);
  if (!error) out.room_gb = static_cast<double>(space.available) / 1e9;
  const std::string beside = study.string() + ".setup-check";
  QElapsedTimer clock;
  clock.start();
  const auto stored = base::writeFileAtomically(beside, std::string(kStoredBytes, '0'));
  out.store_ms = clock.elapsed();
  if (!stored) out.not_stored = text(stored.error().message());
  std::filesystem::remove(beside, error);
  return out;
}

}  // namespace

SetupCheck::SetupCheck(StudyConnection& study, DeviceSession& device, Screens screens,
                       std::function<std::int64_t()> utc_ms, QObject* parent)
    : QObject(parent), study_(study), device_(device), screens_(std::move(screens)), utc_ms_(std::move(utc_ms)) {
  connect(&device_, &DeviceSession::stateChanged, this, &SetupCheck::onDevice);
  connect(&device_, &DeviceSession::sampled, this, &SetupCheck::onSamples);
  connect(&device_, &DeviceSession::failed, this, [this](const QString& sentence) {
    if (device_.user() == this && row(SetupItem::kDevice).state == State::kRunning)
      set(SetupItem::kDevice, false, sentence);
    tell();
  });
}

SetupCheck::~SetupCheck() {
  device_.disconnect(this);
  if (device_.user() == this) device_.stop();
}

void SetupCheck::begin(const QString& id) {
  device_id_ = id;
  rows_ = {};
  told_ = false;
  test_.reset();
  lookAtScreens();
  readStudy();
  emit changed();
}

void SetupCheck::readStudy() {
  study_.read(*this, [this](const store::StudyFile& file) {
    return [this, look = lookAt(file)] {
      set(SetupItem::kDisk,
          look.not_stored.isEmpty() && look.room_gb >= kLeastRoomGb && look.store_ms <= kSlowestStoreMs,
          !look.not_stored.isEmpty()
              ? look.not_stored
              : tr("%1 GB free, stored in %2 ms").arg(numberText(std::round(look.room_gb))).arg(look.store_ms));
      if (!look.plan) {
        set(SetupItem::kConsent, false, text(look.plan.error().message()));
        set(SetupItem::kLanguage, false, tr("The protocol cannot be read."));
        return tell();
      }
      const ParticipantPlan& plan = *look.plan;
      const QString why_text = whyNoText(plan);
      const QString why = whyNoSession(plan);
      QStringList languages;
      for (const QString& language : plan.languages) languages << languageName(language);
      set(SetupItem::kLanguage, plan.protocol && why_text.isEmpty(),
          !plan.protocol       ? tr("There is no protocol that says the languages.")
          : why_text.isEmpty() ? tr("Screens and texts in %1").arg(languages.join(QStringLiteral(", ")))
                               : why_text);
      set(SetupItem::kConsent, why.isEmpty() || why == why_text,
          why.isEmpty() || why == why_text
              ? tr("Version %1; questions go to %2").arg(plan.consent_version, plan.contact)
              : why);
      const auto& blocks = plan.settings.blocks;
      needs_device_ = std::any_of(blocks.begin(), blocks.end(),
                                  [](session::Block block) { return block != session::Block::kForm; });
      if (needs_device_) {
        set(SetupItem::kDevice, State::kRunning);
        device_.start(device_id_, {}, this);
      } else {
        for (const SetupItem item : {SetupItem::kDevice, SetupItem::kForce, SetupItem::kLatency})
          set(item, true, tr("No part of the session is felt."));
      }
      tell();
    };
  });
}

void SetupCheck::lookAtScreens() {
  const std::vector<QSize> screens = screens_();
  const QSize participants = screens.front();
  const bool large = participants.width() >= kLeastScreen.width() && participants.height() >= kLeastScreen.height();
  const QString size = tr("the participant's has %1 × %2 px").arg(participants.width()).arg(participants.height());
  set(SetupItem::kScreens, large,
      !large               ? tr("%1, 1280 × 720 are needed").arg(size)
      : screens.size() > 1 ? tr("%n screen(s), %1", nullptr, static_cast<int>(screens.size())).arg(size)
                           : tr("One screen only: there is no monitor for you; %1").arg(size));
}

void SetupCheck::onDevice() {
  if (device_.user() != this || !needs_device_) return;
  using DeviceState = DeviceSession::State;
  if (device_.state() == DeviceState::kRunning && !test_ && row(SetupItem::kDevice).state == State::kRunning) {
    const auto info = device_.device();
    if (!session::givesForce(info->id) || info->simulated) {
      set(SetupItem::kDevice, false, tr("No device that gives a force is connected."));
      set(SetupItem::kForce, false, tr("Nothing can be felt."));
      set(SetupItem::kLatency, false, tr("Nothing was measured."));
      device_.stop();
    } else {
      repeatForce();
    }
  } else if (device_.state() == DeviceState::kTripped && device_.trip()) {
    test_.reset();
    set(SetupItem::kForce, false, device_.trip()->sentence);
  }
  tell();
}

void SetupCheck::repeatForce() {
  const auto info = device_.device();
  if (!info || device_.user() != this) return begin(device_id_);
  if (device_.state() == DeviceSession::State::kTripped) device_.rearm();
  test_.emplace(devices::settingsFor(*info));
  sendOrders();
  set(SetupItem::kForce, State::kRunning);
  emit changed();
}

// The session of the device adds what belongs to it: axis, limits, grip and arming.
void SetupCheck::sendOrders() {
  const auto wanted = test_->takeOrders();
  if (!wanted) return;
  ForceOrders orders;
  orders.source = wanted->source == haptics::ForceSource::kOff ? haptics::ForceSource::kFree : wanted->source;
  orders.stimulus = wanted->stimulus;
  orders.stimulus.number = device_.newNumber();
  if (const auto posted = device_.setForce(orders)) test_->posted(*posted);
}

void SetupCheck::onSamples(std::span<const haptics::Sample> samples) {
  if (device_.user() != this) return;
  if (row(SetupItem::kLatency).state != State::kGood && device_.ticks() >= kLatencyTicks) measureLatency();
  if (!test_ || test_->finished()) return;
  const auto phase = test_->phase();
  for (const haptics::Sample& sample : samples) {
    test_->feed(sample);
    sendOrders();
  }
  if (test_->phase() != phase) followTest();
}

void SetupCheck::followTest() {
  for (const devices::CheckResult& one : test_->results()) {
    const bool samples = one.check == devices::Check::kSamples;
    if (samples || (one.check == devices::Check::kCalibration && !one.passed)) {
      const QString name = text(device_.device()->name);
      set(SetupItem::kDevice, one.passed,
          one.passed ? tr("%1: %2").arg(name, text(one.found)) : text(one.found + ": " + one.advice));
    }
    if (!one.passed) set(SetupItem::kForce, false, text(one.found + ": " + one.advice));
  }
  if (test_->passed()) set(SetupItem::kForce, true, tr("Self-test: %1").arg(text(test_->results().back().found)));
  tell();
}

void SetupCheck::measureLatency() {
  const haptics::LoopStatistics statistics = device_.statistics();
  const double missed = static_cast<double>(statistics.missed) / static_cast<double>(statistics.ticks);
  const double late_ms = static_cast<double>(statistics.lateness.quantileNs(0.99)) * kMillisecond;
  const double age_ms = static_cast<double>(statistics.read_age.quantileNs(0.99)) * kMillisecond;
  set(SetupItem::kLatency, missed <= kMissedShare && late_ms <= kLateMs,
      tr("Of 1000 ticks a second 99 % are at most %1 ms late, positions %2 ms old; %n missed", nullptr,
         static_cast<int>(statistics.missed))
          .arg(ms(late_ms), ms(age_ms)));
  tell();
}

QString SetupCheck::instruction() const { return test_ ? text(test_->instruction()) : QString(); }

void SetupCheck::feltDirection(devices::Felt felt) {
  if (!asksDirection()) return;
  test_->answer(felt);
  sendOrders();
  followTest();
}

bool SetupCheck::mayPush() const {
  return device_.user() == this && device_.state() == DeviceSession::State::kRunning && (!test_ || test_->finished());
}

void SetupCheck::pushOnScale() {
  if (!mayPush()) return;
  ForceOrders orders;
  orders.source = haptics::ForceSource::kStimulus;
  orders.stimulus = {device_.newNumber(), kScaleN, 0.3, 5.0, std::nullopt};
  device_.setForce(orders);
}

void SetupCheck::scaleShowed(double grams) {
  const double shown_n = grams * kNewtonsPerGram;
  set(SetupItem::kForce, std::abs(shown_n - kScaleN) <= kScaleShare * kScaleN,
      tr("A scale showed %1 g, that is %2 N, for %3 N").arg(numberText(grams), ms(shown_n), numberText(kScaleN)));
  tell();
}

void SetupCheck::heard(bool tone) {
  set(SetupItem::kSound, tone, tone ? tr("The tone was heard.") : tr("The tone was not heard."));
  tell();
}

bool SetupCheck::isDone() const {
  return std::all_of(rows_.begin(), rows_.end(),
                     [](const Row& one) { return one.state == State::kGood || one.state == State::kBad; });
}

session::SetupCertificate SetupCheck::certificate() const {
  session::SetupCertificate out;
  out.utc_ms = utc_ms_();
  out.device = device_id_.toStdString();
  out.program = kGenerator;
  for (const SetupItem item : session::kSetupItems) {
    if (row(item).state == State::kOpen || row(item).state == State::kRunning) continue;
    out.findings.push_back({item, row(item).state == State::kGood, row(item).found.toStdString()});
  }
  return out;
}

void SetupCheck::set(SetupItem item, State state, const QString& found) {
  rows_[static_cast<std::size_t>(item)] = {state, found};
  told_ = false;
}

void SetupCheck::tell() {
  emit changed();
  if (isDone() && !std::exchange(told_, true)) emit done(certificate());
}

}  // namespace tactus::workbench
