#include "app/workbench/labs/data/lab_model.h"

#include <chrono>
#include <utility>

#include "app/version.h"
#include "app/workbench/base/display_text.h"
#include "core/base/clock.h"

namespace tactus::workbench {
namespace {

/// The last model, whose clusters serve the next one. It keeps no study alive.
struct Kept {
  std::weak_ptr<const LabStudy> study;
  elicitation::SpeedTermSettings with;
  std::shared_ptr<const elicitation::BuiltModel> built;
};

LabModel::Answer build(const LabInputs& from, const RunOf<BuiltStudy>& run, Kept& kept) {
  elicitation::BuildSettings settings = stoppable(from.settings, run.stop);
  settings.created_utc = base::formatUtc(std::chrono::system_clock::now());
  settings.generator = kGenerator;
  const bool clustered =
      kept.built != nullptr && kept.study.lock() == from.study && elicitation::clusterAlike(kept.with, settings.speed);
  const auto go_on = [&run](double share) {
    run.progress(share);
    return !run.stop.stop_requested();
  };
  auto made = elicitation::buildModel(from.study->study, from.study->forms, settings,
                                      clustered ? &kept.built->speeds : nullptr, go_on);
  if (!made) return tl::unexpected(text(made.error().message()));
  settings.speed.fcm.keep_going = {};
  const auto built = std::make_shared<const elicitation::BuiltModel>(std::move(*made));
  kept = {from.study, settings.speed, built};
  return std::make_shared<const BuiltStudy>(BuiltStudy{built, from.study, settings});
}

}  // namespace

elicitation::BuildSettings stoppable(elicitation::BuildSettings settings, const std::stop_token& stop) {
  settings.speed.fcm.keep_going = [stop](const elicitation::FcmProgress&) { return !stop.stop_requested(); };
  return settings;
}

void followLabData(Computation& cell, LabData& data) {
  cell.needs(data);
  QObject::connect(&data, &LabData::studyReplaced, &cell, &Computation::renew);
  QObject::connect(&data, &LabData::settingsChanged, &cell, &Computation::refresh);
}

LabModel::LabModel(LabData& data, QObject* parent)
    : Computed([&data] { return data.inputs(); },
               [kept = std::make_shared<Kept>()](const LabInputs& from, const RunOf<BuiltStudy>& run) {
                 return build(from, run, *kept);
               },
               parent) {
  followLabData(*this, data);
}

}  // namespace tactus::workbench
