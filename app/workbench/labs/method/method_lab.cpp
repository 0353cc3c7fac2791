#include "app/workbench/labs/method/method_lab.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/lab_data.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/model/method_study.h"

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
    VariantRow row{i, spelled(one.value), kNotCompared, kNotCompared, kNotCompared, kNotCompared, why, why};
    if (why.isEmpty()) {
      row.rms = methodNewtons(one.rms_n);
      row.noticeable = numberText(one.rms_noticeable, 2);
      row.felt = percentText(one.noticeable_share);
      row.largest = methodNewtons(one.largest_n);
      row.where = one.at.empty() ? QString() : brokenAtCommas(text(elicitation::shortPointText(model, one.at)));
    }
    rows.push_back(std::move(row));
  }
  return rows;
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
    // Not always that of the variant that is felt most.
    double largest_n = 0;
    for (const auto& one : study.variants) {
      if (one.factor == factor.factor) largest_n = std::max(largest_n, one.largest_n);
    }
    rows.push_back(
        {i, text(elicitation::factorTitle(factor.factor)), spelled(factor.unchanged),
         // A narrow column shall not break between a number and its sign.
         spelled(elicitation::factorVerdict(study, factor)).replace(QStringLiteral(" %"), QStringLiteral("\u00A0%")),
         spelled(elicitation::factorSentence(study, factor)),
         worst == nullptr ? kNotCompared : methodNewtons(largest_n),
         worst == nullptr ? kNotCompared : numberText(worst->rms_noticeable, 2)});
  }
  return rows;
}

MethodLab::MethodLab(LabData& data, Studied studied, QObject* parent)
    : QObject(parent),
      data_(data),
      studied_(std::move(studied)),
      found_([this] { return order_; }, &MethodLab::compareChoices),
      curves_([this] { return drawn(); }, &MethodLab::draw) {
  connect(&found_, &Computation::valueChanged, this, [this] {
    ++number_;
    old_ = false;
    choose(std::nullopt);
  });
  connect(&found_, &Computation::changed, this, [this] {
    if (!found_.isBusy()) found_.hold(*this, false);
    emit changed();
  });
  connect(&curves_, &Computation::valueChanged, this, &MethodLab::curvesChanged);
  connect(&data_, &LabData::settingsChanged, this, &MethodLab::markOld);
  connect(&data_, &LabData::studyReplaced, this, [this] {
    markOld();
    if (data_.study() != nullptr && !found_.isBusy()) return;
    order_ = orderNow();
    found_.renew();
  });
  connect(&data_, &LabData::studyChanged, this, &MethodLab::changed);
}

void MethodLab::setWanted(bool wanted) {
  data_.hold(*this, wanted);
  curves_.hold(*this, wanted);
}

void MethodLab::compare() {
  if (!isPossible() || isBusy()) return;
  order_ = orderNow();
  found_.refresh();
  found_.hold(*this);
}

std::optional<MethodLab::Order> MethodLab::orderNow() const {
  const auto inputs = data_.inputs();
  if (!inputs) return std::nullopt;
  const auto known = studied_ ? studied_() : std::nullopt;
  const bool same =
      known && known->built.study == inputs->study && settingsChange(known->built.settings, inputs->settings).isEmpty();
  return Order{*inputs, same ? std::optional(Found{known->built.model, known->choices}) : std::nullopt};
}

MethodLab::FoundCell::Answer MethodLab::compareChoices(const Order& order, const RunOf<Found>& run) {
  const LabInputs& from = order.from;
  const elicitation::BuildSettings settings = stoppable(from.settings, run.stop);
  Found found = order.known.value_or(Found());
  if (!order.known) {
    auto built = elicitation::buildModel(from.study->study, from.study->forms, settings);
    if (!built) return tl::unexpected(text(built.error().message()));
    found.built = std::make_shared<const elicitation::BuiltModel>(std::move(*built));
  }
  auto study = elicitation::methodStudy(from.study->study, from.study->forms, settings, *found.built,
                                        {run.stop, run.progress, {}, found.study.get()});
  if (!study) return tl::unexpected(text(study.error().message()));
  found.study = std::make_shared<const elicitation::MethodStudy>(std::move(*study));
  return std::make_shared<const Found>(std::move(found));
}

void MethodLab::markOld() {
  if (found_.value() == nullptr || std::exchange(old_, true)) return;
  emit changed();
}

void MethodLab::choose(std::optional<std::size_t> variant) {
  chosen_ = variant;
  curves_.forget();
}

std::optional<MethodLab::Drawn> MethodLab::drawn() const {
  if (!chosen_ || found_.value() == nullptr) return std::nullopt;
  return Drawn{found_.of(), found_.value(), *chosen_};
}

MethodLab::CurvesCell::Answer MethodLab::draw(const Drawn& drawn, const RunOf<MethodCurves>&) {
  const auto& [of, found, index] = drawn;
  const auto& one = found->study->variants[index];
  const auto& [study, settings] = of->from;
  const auto model = elicitation::methodModel(study->study, study->forms, settings, *found->built, one);
  if (!model) return nullptr;
  const auto now = fuzzy::compile(found->built->model);
  const auto other = fuzzy::compile(*model);
  if (!now || !other) return nullptr;
  auto curves = std::make_shared<MethodCurves>();
  curves->variant = index;
  curves->x_input = depthInput(*model);
  curves->at = one.at;  // empty if nothing moves
  if (curves->at.empty()) {
    for (const fuzzy::Variable& input : model->inputs) curves->at.push_back(usualValue(found->built->about(), input));
  }
  curves->now = figures::computeCurves(found->built->model, *now, curves->x_input, curves->at);
  curves->other = figures::computeCurves(*model, *other, curves->x_input, curves->at);
  return curves;
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
