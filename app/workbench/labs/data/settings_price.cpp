#include "app/workbench/labs/data/settings_price.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

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

SettingsPrice::Work::Answer SettingsPrice::compare(const Inputs& from, const RunOf<Price>& run, Kept& kept) {
  const LabStudy& study = *from.from.study;
  const auto go_on = [&run](double share) {
    run.progress(share);
    return !run.stop.stop_requested();
  };
  const auto build = [&](const elicitation::BuildSettings& settings, const auto* clustered) {
    return elicitation::buildModel(study.study, study.forms, stoppable(settings, run.stop), clustered, go_on);
  };
  if (kept.built == nullptr || kept.settings != from.before || kept.study.lock() != from.from.study) {
    const std::vector<elicitation::ParticipantSpeeds>* none = nullptr;
    auto made = build(*from.before, none);
    if (!made) return tl::unexpected(text(made.error().message()));
    kept = {from.from.study, from.before, std::make_shared<const elicitation::BuiltModel>(std::move(*made))};
  }
  const auto before = kept.built;
  run.show({before});
  const bool alike = elicitation::clusterAlike(from.before->speed, from.from.settings.speed);
  const auto after = build(from.from.settings, alike ? &before->speeds : nullptr);
  if (!after) return tl::unexpected(text(after.error().message()));
  const auto moved = elicitation::methodDifference(before->model, after->model);
  if (!moved) return tl::unexpected(text(moved.error().message()));
  return std::make_shared<const Price>(Price{before, priceOf(*moved, before->model)});
}

SettingsPrice::SettingsPrice(LabData& data, QObject* parent)
    : QObject(parent),
      data_(data),
      work_(
          [this]() -> std::optional<Inputs> {
            const auto inputs = data_.inputs();
            if (!inputs || !before_) return std::nullopt;
            return Inputs{*inputs, before_};
          },
          [kept = std::make_shared<Kept>()](const Inputs& from, const RunOf<Price>& run) {
            return compare(from, run, *kept);
          }) {
  followLabData(work_, data_);
  connect(&data_, &LabData::settingsEdited, this, &SettingsPrice::setBefore);
  connect(&data_, &LabData::depthsEdited, this, &SettingsPrice::setBefore);
  connect(&data_.connection(), &StudyConnection::opened, this, &SettingsPrice::forget);
  connect(&data_.connection(), &StudyConnection::closed, this, &SettingsPrice::forget);
  connect(&work_, &Computation::changed, this, &SettingsPrice::changed);
  connect(&work_, &Computation::valueChanged, this, &SettingsPrice::changed);
}

void SettingsPrice::setSeen(bool seen) {
  seen_ = seen;
  work_.hold(*this, seen_ && before_ != nullptr);
}

void SettingsPrice::setBefore(const elicitation::BuildSettings& before) {
  const bool together = since_change_.isValid() && since_change_.elapsed() < kTogetherMs;
  since_change_.start();
  if (!together || !before_) before_ = std::make_shared<const elicitation::BuildSettings>(before);
  work_.hold(*this, seen_);
  emit changed();
}

void SettingsPrice::forget() {
  before_.reset();
  since_change_.invalidate();
  work_.hold(*this, false);
  emit changed();
}

QString SettingsPrice::change() const { return before_ ? settingsChange(*before_, data_.settings()) : QString(); }

QString SettingsPrice::sentence() const {
  const QString changed = change();
  if (changed.isEmpty()) return {};
  if (!work_.failure().isEmpty() && work_.isCurrent())
    return tr("%1: there is no model. %2").arg(changed, work_.failure());
  const bool current = work_.value() != nullptr && !work_.value()->sentence.isEmpty() && !work_.isBusy();
  return tr("%1: %2").arg(changed, current ? work_.value()->sentence : tr("the averaged force is being compared…"));
}

std::vector<fuzzy::Term> SettingsPrice::formerTerms(const std::string& variable) const {
  if (work_.value() == nullptr || work_.of()->before != before_ || change().isEmpty()) return {};
  const fuzzy::ForceModel& model = work_.value()->former->model;
  if (model.output.id == variable) return model.output.terms;
  const auto input = std::find_if(model.inputs.begin(), model.inputs.end(),
                                  [&variable](const fuzzy::Variable& one) { return one.id == variable; });
  return input == model.inputs.end() ? std::vector<fuzzy::Term>() : input->terms;
}

}  // namespace tactus::workbench
