#include "app/workbench/labs/data/lab_model.h"

#include <chrono>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "core/base/clock.h"

namespace tactus::workbench {

LabWork::LabWork(LabData& data, Work work, QObject* parent) : QObject(parent), data_(data), work_(std::move(work)) {
  connect(&data_, &LabData::studyChanged, this, [this] {
    if (data_.study() != of_) restart();
  });
  connect(&data_, &LabData::settingsChanged, this, &LabWork::restart);
}

void LabWork::ignoreSettings() { disconnect(&data_, &LabData::settingsChanged, this, nullptr); }

void LabWork::setWanted(bool wanted) {
  if (std::exchange(wanted_, wanted) == wanted) return;
  data_.setWanted(*this, wanted);
  if (wanted) {
    if (stale_ && !canceled_) begin();
  } else if (isBusy()) {
    background_.drop();
    oldest_ = ++newest_;
    stale_ = true;
    emit changed();
  }
}

void LabWork::restart() {
  canceled_ = false;
  stale_ = true;
  if (wanted_) begin();
}

void LabWork::cancel() {
  if (!isBusy()) return;
  background_.drop();
  oldest_ = ++newest_;
  canceled_ = true;
  stale_ = true;
  emit changed();
}

void LabWork::begin() {
  ++newest_;
  if (std::exchange(of_, data_.study()) != data_.study()) oldest_ = newest_;
  progress_ = 0;
  doing_.clear();
  if (of_ == nullptr) {
    background_.drop();
    emit changed();
    return;
  }
  stale_ = false;
  auto run = std::make_shared<Run>();
  run->study = of_;
  run->settings = data_.settings();
  background_.run([this, run, number = newest_](const std::stop_token& stop) { return perform(*run, number, stop); });
  emit changed();
}

// Runs in the other thread, which ends before this does.
Background::Deliver LabWork::perform(Run& run, std::uint64_t number, const std::stop_token& stop) {
  run.stop = stop;
  run.settings.speed.fcm.keep_going = [stop](const elicitation::FcmProgress&) { return !stop.stop_requested(); };
  run.hand = [this, number](Deliver deliver) {
    answers_.post([this, number, deliver = std::move(deliver)] {
      if (number == newest_ && deliver) deliver();
    });
  };
  run.show = [this, number](std::function<void(bool)> deliver) {
    answers_.post([this, number, deliver = std::move(deliver)] {
      if (number >= oldest_) deliver(number == newest_);
    });
  };
  run.given_up = [this, number] { return number < oldest_; };
  run.progress = [this, number](double share) {
    answers_.post([this, number, share] {
      if (number != newest_) return;
      progress_ = share;
      emit changed();
    });
  };
  run.say = [this, number](const QString& doing) {
    answers_.post([this, number, doing] {
      if (number != newest_) return;
      doing_ = doing;
      emit changed();
    });
  };
  Deliver deliver = work_(run);
  return [this, deliver = std::move(deliver)] {
    progress_ = 1;
    if (deliver) deliver();
    emit changed();
  };
}

LabModel::LabModel(LabData& data, QObject* parent)
    : QObject(parent), work_(data, [this](const LabWork::Run& run) { return build(run); }) {
  connect(&data, &LabData::studyChanged, this, [this, &data] {
    if (data.study() != nullptr || built_ == nullptr) return;
    built_ = nullptr;
    from_ = nullptr;
    emit builtChanged();
  });
}

void LabModel::setWanted(QObject& asker, bool wanted) {
  if (!wanted) {
    askers_.remove(&asker);
  } else if (!askers_.contains(&asker)) {
    askers_.insert(&asker);
    connect(&asker, &QObject::destroyed, this, [this](QObject* ended) {
      askers_.remove(ended);
      work_.setWanted(!askers_.isEmpty());
    });
  }
  work_.setWanted(!askers_.isEmpty());
}

// Runs in the thread of the work.
LabWork::Deliver LabModel::build(const LabWork::Run& run) {
  elicitation::BuildSettings settings = run.settings;
  settings.created_utc = base::formatUtc(std::chrono::system_clock::now());
  settings.generator = kGenerator;
  const bool clustered = kept_.built != nullptr && kept_.study.lock() == run.study &&
                         elicitation::clusterAlike(kept_.with, settings.speed);
  const auto go_on = [&run](double share) {
    run.progress(share);
    return !run.stop.stop_requested();
  };
  auto made = elicitation::buildModel(run.study->study, run.study->forms, settings,
                                      clustered ? &kept_.built->speeds : nullptr, go_on);
  settings.speed.fcm.keep_going = {};
  const QString sentence = made ? QString() : text(made.error().message());
  const auto built = made ? std::make_shared<const elicitation::BuiltModel>(std::move(*made)) : nullptr;
  if (built != nullptr) kept_ = {run.study, settings.speed, built};
  return [this, built, sentence, settings, study = run.study] {
    built_ = built;
    from_ = study;
    with_ = settings;
    failure_ = sentence;
    emit builtChanged();
  };
}

}  // namespace tactus::workbench
