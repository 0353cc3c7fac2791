#include "app/workbench/labs/method/method_lab.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/lab_data.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/model/method_study.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::workbench {

VariantTable::VariantTable(QObject* parent)
    : LabTableModel({{tr("Instead")},
                     {tr("rms"), Qt::AlignRight},
                     {tr("JND"), Qt::AlignRight},
                     {tr("Felt at"), Qt::AlignRight},
                     {tr("At most"), Qt::AlignRight},
                     {tr("Where")}},
                    parent) {}

void VariantTable::setFactor(const elicitation::MethodStudy& study, const std::string& factor,
                             const fuzzy::ForceModel& model) {
  beginResetModel();
  rows_.clear();
  for (std::size_t i = 0; i < study.variants.size(); ++i) {
    const auto& one = study.variants[i];
    if (one.factor != factor) continue;
    rows_.push_back({i, one, one.at.empty() ? QString() : text(elicitation::pointText(model, one.at))});
  }
  endResetModel();
}

void VariantTable::clear() {
  beginResetModel();
  rows_.clear();
  endResetModel();
}

int VariantTable::rowOf(std::size_t variant) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].index == variant) return static_cast<int>(i);
  }
  return -1;
}

int VariantTable::rows() const { return static_cast<int>(rows_.size()); }

QVariant VariantTable::cell(int row, int column, int role) const {
  const Row& at = rows_[static_cast<std::size_t>(row)];
  const auto& one = at.variant;
  if (role == Qt::ToolTipRole && !one.unavailable.empty()) return text(one.unavailable);
  if (role == Qt::ToolTipRole && column == kWhere) return at.where;
  if (role != Qt::DisplayRole) return {};
  if (column == kValue) return text(one.value);
  if (!one.unavailable.empty()) return column == kWhere ? text(one.unavailable) : QStringLiteral("–");
  switch (column) {
    case kRms: return quantityText(one.rms_n, "N", 3);
    case kNoticeable: return numberText(one.rms_noticeable, 2);
    case kFelt: return feltText(one.noticeable_share);
    case kLargest: return quantityText(one.largest_n, "N", 3);
    case kWhere: return at.where;
    default: return {};
  }
}

namespace {

const QString kNotCompared = QStringLiteral("–");

}  // namespace

QString feltText(double share) {
  if (share > 0 && share < 0.0005) return QStringLiteral("< 0.1 %");
  return QStringLiteral("%1 %").arg(numberText(100 * share, 1));
}

FactorTable::FactorTable(QObject* parent)
    : LabTableModel({{tr("Choice")},
                     {tr("Now")},
                     {tr("Does it matter here?")},
                     {tr("At most"), Qt::AlignRight},
                     {tr("JND"), Qt::AlignRight,
                      tr("Root mean square of the difference over the input space, in just-noticeable differences, for "
                         "the value that moves the force most.")}},
                    parent) {}

void FactorTable::setStudy(const elicitation::MethodStudy* study) {
  beginResetModel();
  study_ = study == nullptr ? elicitation::MethodStudy() : *study;
  order_ = elicitation::factorsByEffect(study_);
  endResetModel();
}

int FactorTable::rows() const { return static_cast<int>(order_.size()); }

QVariant FactorTable::cell(int row, int column, int role) const {
  const auto& factor = study_.factors[factorAt(row)];
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  const auto* const worst = factor.worst ? &study_.variants[*factor.worst] : nullptr;
  switch (column) {
    case kFactor: return text(elicitation::factorTitle(factor.factor));
    case kNow: return text(factor.unchanged);
    case kSentence:
      if (role == Qt::ToolTipRole) return text(elicitation::factorSentence(study_, factor));
      // A narrow column shall not break between a number and its sign.
      return text(elicitation::factorVerdict(study_, factor)).replace(QStringLiteral(" %"), QStringLiteral("\u00A0%"));
    case kLargest: return worst == nullptr ? kNotCompared : quantityText(worst->largest_n, "N", 3);
    case kNoticeable: return worst == nullptr ? kNotCompared : numberText(worst->rms_noticeable, 2);
    default: return {};
  }
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
