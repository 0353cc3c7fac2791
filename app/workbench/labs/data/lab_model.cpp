#include "app/workbench/labs/data/lab_model.h"

#include <chrono>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "core/base/clock.h"

namespace tactus::workbench {

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
