#include "app/workbench/labs/data/settings_price.h"

#include <QCoreApplication>

#include "app/workbench/base/display_text.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/model/method_study.h"

namespace tactus::workbench {
namespace {

struct PriceText {
  Q_DECLARE_TR_FUNCTIONS(PriceText)
};

QString priceOf(const elicitation::MethodVariant& moved, const fuzzy::ForceModel& model) {
  if (moved.largest_n == 0 && moved.only_one_share == 0) return PriceText::tr("the averaged force stays the same.");
  QString out = PriceText::tr("the averaged force moves by at most %1, felt at %2 of the input space; most at %3.")
                    .arg(quantityText(moved.largest_n, "N", 3), percentText(moved.noticeable_share),
                         text(elicitation::pointText(model, moved.at)));
  if (moved.only_one_share > 0)
    out += QLatin1Char(' ') +
           PriceText::tr("At %1 only one of the two gives a force.").arg(percentText(moved.only_one_share));
  return out;
}

}  // namespace

SettingsPrice::SettingsPrice(LabData& data, QObject* parent)
    : QObject(parent),
      data_(data),
      work_(
          [this]() -> std::optional<Inputs> {
            const auto inputs = data_.inputs();
            if (!inputs || !before_) return std::nullopt;
            return Inputs{*inputs, *before_};
          },
          [](const Inputs& from, const RunOf<QString>& run) -> Computed<Inputs, QString>::Answer {
            const LabStudy& study = *from.from.study;
            const auto go_on = [&run](double share) {
              run.progress(share);
              return !run.stop.stop_requested();
            };
            const auto build = [&](const elicitation::BuildSettings& settings, const auto* clustered) {
              return elicitation::buildModel(study.study, study.forms, stoppable(settings, run.stop), clustered, go_on);
            };
            const std::vector<elicitation::ParticipantSpeeds>* none = nullptr;
            const auto before = build(from.before, none);
            if (!before) return tl::unexpected(text(before.error().message()));
            const bool alike = elicitation::clusterAlike(from.before.speed, from.from.settings.speed);
            const auto after = build(from.from.settings, alike ? &before->speeds : none);
            if (!after) return tl::unexpected(text(after.error().message()));
            const auto moved = elicitation::methodDifference(before->model, after->model);
            if (!moved) return tl::unexpected(text(moved.error().message()));
            return std::make_shared<const QString>(priceOf(*moved, before->model));
          }) {
  followLabData(work_, data_);
  connect(&data_, &LabData::settingsEdited, this, &SettingsPrice::take);
  connect(&data_.connection(), &StudyConnection::opened, this, &SettingsPrice::forget);
  connect(&data_.connection(), &StudyConnection::closed, this, &SettingsPrice::forget);
  connect(&work_, &Computation::changed, this, &SettingsPrice::changed);
  connect(&work_, &Computation::valueChanged, this, &SettingsPrice::changed);
}

void SettingsPrice::setSeen(bool seen) {
  seen_ = seen;
  work_.hold(*this, seen_ && before_);
}

void SettingsPrice::take(const elicitation::BuildSettings& before) {
  const bool together = since_change_.isValid() && since_change_.elapsed() < kTogetherMs;
  since_change_.start();
  if (!together || !before_) before_ = before;
  work_.hold(*this, seen_);
  emit changed();
}

void SettingsPrice::forget() {
  before_.reset();
  since_change_.invalidate();
  work_.hold(*this, false);
  emit changed();
}

QString SettingsPrice::sentence() const {
  if (!before_) return {};
  const QString change = settingsChange(*before_, data_.settings());
  if (change.isEmpty()) return {};
  if (!work_.failure().isEmpty() && work_.isCurrent())
    return tr("%1: there is no model. %2").arg(change, work_.failure());
  const bool current = work_.value() != nullptr && !work_.isBusy();
  return tr("%1: %2").arg(change, current ? *work_.value() : tr("the averaged force is being compared…"));
}

}  // namespace tactus::workbench
