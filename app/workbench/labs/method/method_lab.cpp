#include "app/workbench/labs/method/method_lab.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/lab_data.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/model/method_study.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::workbench {

namespace {

const QString kNotCompared = QStringLiteral("–");

QString methodNewtons(double force_n) { return quantityText(force_n, "N", 3); }

}  // namespace

std::vector<Column<VariantRow>> variantColumns() {
  using Row = VariantRow;
  return withRole<Row>({{MethodLab::tr("Instead"), &Row::value},
                        {MethodLab::tr("rms"), &Row::rms, Qt::AlignRight},
                        {MethodLab::tr("JND"), &Row::noticeable, Qt::AlignRight},
                        {MethodLab::tr("Felt at"), &Row::felt, Qt::AlignRight},
                        {MethodLab::tr("At most"), &Row::largest, Qt::AlignRight},
                        {MethodLab::tr("Where"), &Row::where, Qt::AlignLeft, {}, {{Qt::ToolTipRole, &Row::where}}}},
                       Qt::ToolTipRole, &Row::unavailable);
}

std::vector<VariantRow> variantRows(const elicitation::MethodStudy& study, const std::string& factor,
                                    const fuzzy::ForceModel& model) {
  std::vector<VariantRow> rows;
  for (std::size_t i = 0; i < study.variants.size(); ++i) {
    const auto& one = study.variants[i];
    if (one.factor != factor) continue;
    const QString why = text(one.unavailable);
    VariantRow row{i, text(one.value), kNotCompared, kNotCompared, kNotCompared, kNotCompared, why, why};
    if (why.isEmpty()) {
      row.rms = methodNewtons(one.rms_n);
      row.noticeable = numberText(one.rms_noticeable, 2);
      row.felt = feltText(one.noticeable_share);
      row.largest = methodNewtons(one.largest_n);
      row.where = one.at.empty() ? QString() : text(elicitation::pointText(model, one.at));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

QString feltText(double share) {
  if (share > 0 && share < 0.0005) return QStringLiteral("< 0.1 %");
  return QStringLiteral("%1 %").arg(numberText(100 * share, 1));
}

std::vector<Column<FactorRow>> factorColumns() {
  using Row = FactorRow;
  return withRole<Row>(
      {{MethodLab::tr("Choice"), &Row::factor},
       {MethodLab::tr("Now"), &Row::now},
       {MethodLab::tr("Does it matter here?"), &Row::verdict, Qt::AlignLeft, {}, {{Qt::ToolTipRole, &Row::sentence}}},
       {MethodLab::tr("At most"), &Row::largest, Qt::AlignRight},
       {MethodLab::tr("JND"), &Row::noticeable, Qt::AlignRight,
        MethodLab::tr("Root mean square of the difference over the input space, in just-noticeable "
                      "differences, for the value that moves the force most.")}},
      Qt::ToolTipRole);
}

std::vector<FactorRow> factorRows(const elicitation::MethodStudy& study) {
  std::vector<FactorRow> rows;
  for (const std::size_t i : elicitation::factorsByEffect(study)) {
    const auto& factor = study.factors[i];
    const auto* const worst = factor.worst ? &study.variants[*factor.worst] : nullptr;
    rows.push_back(
        {i, text(elicitation::factorTitle(factor.factor)), text(factor.unchanged),
         // A narrow column shall not break between a number and its sign.
         text(elicitation::factorVerdict(study, factor)).replace(QStringLiteral(" %"), QStringLiteral("\u00A0%")),
         text(elicitation::factorSentence(study, factor)),
         worst == nullptr ? kNotCompared : methodNewtons(worst->largest_n),
         worst == nullptr ? kNotCompared : numberText(worst->rms_noticeable, 2)});
  }
  return rows;
}

namespace {

std::size_t depthInput(const fuzzy::ForceModel& model) {
  const auto depth = std::find_if(model.inputs.begin(), model.inputs.end(),
                                  [](const auto& input) { return input.id == elicitation::ngtRegionInput(); });
  return depth == model.inputs.end() ? 0 : static_cast<std::size_t>(depth - model.inputs.begin());
}

}  // namespace

MethodLab::MethodLab(LabData& data, QObject* parent)
    : QObject(parent), data_(data), work_(data, [this](const LabWork::Run& run) { return perform(run); }) {
  work_.ignoreSettings();
  connect(&work_, &LabWork::changed, this, [this] {
    if (work_.isCanceled()) {
      asked_.store(false);
      work_.setWanted(false);
      work_.restart();  // nothing runs: only the button begins again
    } else if (!work_.isBusy() && !asked_.load()) {
      work_.setWanted(false);
    }
    emit changed();
  });
  connect(&data_, &LabData::settingsChanged, this, &MethodLab::markOld);
  connect(&data_, &LabData::studyChanged, this, [this] {
    if (data_.study() == nullptr) {
      found_ = nullptr;
      ++number_;
      failure_.clear();
      choose(std::nullopt);
    } else if (found_ != nullptr && found_->of != data_.study()) {
      markOld();
    }
    emit changed();
  });
}

MethodLab::~MethodLab() = default;

void MethodLab::setWanted(bool wanted) { data_.setWanted(*this, wanted); }

void MethodLab::compare() {
  if (!isPossible() || isBusy()) return;
  asked_.store(true);
  work_.restart();
  work_.setWanted(true);
  emit changed();
}

void MethodLab::cancel() { work_.cancel(); }

// Runs in the thread of the work.
LabWork::Deliver MethodLab::perform(const LabWork::Run& run) {
  if (!asked_.load()) return {};
  auto built = elicitation::buildModel(run.study->study, run.study->forms, run.settings);
  if (!built) return [this, why = text(built.error().message())] { take(nullptr, why); };
  auto found = std::make_shared<Found>(Found{run.study, run.settings, std::move(*built), {}});
  auto study = elicitation::methodStudy(run.study->study, run.study->forms, run.settings, found->built,
                                        {run.stop, run.progress});
  if (!study) return [this, why = text(study.error().message())] { take(nullptr, why); };
  found->settings.speed.fcm.keep_going = {};
  found->study = std::move(*study);
  return [this, found] { take(found, {}); };
}

void MethodLab::take(std::shared_ptr<const Found> found, const QString& failure) {
  found_ = std::move(found);
  ++number_;
  failure_ = failure;
  old_ = false;
  asked_.store(false);
  choose(std::nullopt);
  emit changed();
}

void MethodLab::markOld() {
  if (found_ == nullptr || std::exchange(old_, true)) return;
  emit changed();
}

void MethodLab::choose(std::optional<std::size_t> variant) {
  chosen_ = variant;
  curves_ = nullptr;
  draws_.drop();
  emit curvesChanged();
  if (!variant || found_ == nullptr) return;
  draws_.run([this, found = found_, index = *variant](const std::stop_token&) -> Background::Deliver {
    const auto& one = found->study.variants[index];
    const auto model = elicitation::methodModel(found->of->study, found->of->forms, found->settings, found->built, one);
    if (!model) return [] {};
    const auto now = fuzzy::compile(found->built.model);
    const auto other = fuzzy::compile(*model);
    if (!now || !other) return [] {};
    auto curves = std::make_shared<MethodCurves>();
    curves->variant = index;
    curves->x_input = depthInput(*model);
    curves->at = one.at;  // empty if nothing moves
    if (curves->at.empty()) {
      for (const fuzzy::Variable& input : model->inputs) curves->at.push_back(usualValue(input));
    }
    curves->now = figures::computeCurves(found->built.model, *now, curves->x_input, curves->at);
    curves->other = figures::computeCurves(*model, *other, curves->x_input, curves->at);
    return [this, curves] {
      curves_ = curves;
      emit curvesChanged();
    };
  });
}

QString placeOfCurves(const fuzzy::ForceModel& model, const MethodCurves& curves) {
  QStringList parts;
  for (std::size_t i = 0; i < curves.at.size(); ++i) {
    if (i == curves.x_input) continue;
    parts << labelOf(model.inputs[i]) + QLatin1Char(' ') + quantityText(curves.at[i], model.inputs[i].unit);
  }
  return parts.join(QStringLiteral(" · "));
}

}  // namespace tactus::workbench
