#include "app/workbench/labs/experts/experts_lab.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/lab_data.h"
#include "elicitation/agreement/expert_influence.h"
#include "elicitation/variables/ngt_variables.h"

namespace tactus::workbench {
namespace {

using elicitation::WeightPolicy;

const QString kUnknown = QStringLiteral("–");

QString pairNewtons(double force_n) { return quantityText(force_n, "N", 3); }

}  // namespace

QString policyName(WeightPolicy policy) {
  switch (policy) {
    case WeightPolicy::kEqual: return ExpertsLab::tr("Equal");
    case WeightPolicy::kYears: return ExpertsLab::tr("By years of experience");
    case WeightPolicy::kCategory: return ExpertsLab::tr("By category");
    case WeightPolicy::kColumn: return ExpertsLab::tr("From the profiles");
    case WeightPolicy::kTable: return ExpertsLab::tr("Own weights");
  }
  return {};
}

std::vector<Column<PolicyRow>> policyColumns() {
  using Row = PolicyRow;
  const auto tip = [](QString Row::*cell) -> std::map<int, CellOf<Row>> {
    return {
        {Qt::ToolTipRole, [cell](const Row& row) { return row.unavailable.isEmpty() ? row.*cell : row.unavailable; }}};
  };
  return {{ExpertsLab::tr("Weights"), &Row::policy, Qt::AlignLeft, {}, {{Qt::ToolTipRole, &Row::unavailable}}},
          {ExpertsLab::tr("Of the experts"), &Row::weights, Qt::AlignLeft, {}, tip(&Row::weights)},
          {ExpertsLab::tr("From equal, at most"), &Row::largest, Qt::AlignRight, {}, tip(&Row::largest)},
          {ExpertsLab::tr("rms"), &Row::rms, Qt::AlignRight, {}, tip(&Row::rms)},
          {ExpertsLab::tr("Where"), &Row::where, Qt::AlignLeft, {}, tip(&Row::where)}};
}

std::vector<PolicyRow> policyRows(const std::vector<ComparedWeights>& compared) {
  std::vector<PolicyRow> rows;
  for (const ComparedWeights& one : compared) {
    rows.push_back(
        {policyName(one.policy), ExpertsLab::tr("not in the data"), kUnknown, kUnknown, kUnknown, one.unavailable});
    PolicyRow& row = rows.back();
    if (!one.unavailable.isEmpty()) continue;
    QStringList weights;
    for (const double weight : one.weights) weights << numberText(weight, 2);
    row.weights = weights.join(QStringLiteral(" · "));
    row.largest = pairNewtons(one.from_equal.largest_n);
    row.rms = pairNewtons(one.from_equal.rms_n);
    row.where = one.where;
  }
  return rows;
}

void showDistances(Columns<DistanceRow>& table, const elicitation::BuiltModel* built) {
  std::vector<Column<DistanceRow>> columns;
  std::vector<DistanceRow> rows;
  const std::size_t count = built == nullptr ? 0 : built->model.experts.size();
  for (std::size_t i = 0; i < count; ++i) {
    const QString expert = harmless(labelOf(built->model.experts[i]));
    columns.push_back({expert,
                       [i](const DistanceRow& row) { return row.distances[i]; },
                       Qt::AlignHCenter,
                       {},
                       {{Qt::ToolTipRole, [i](const DistanceRow& row) { return row.tips[i]; }}}});
    rows.push_back({expert, std::vector<QString>(count), std::vector<QString>(count)});
  }
  std::size_t pair = 0;  // they stand in this order
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j, ++pair) {
      const elicitation::ExpertDistance& one = built->influences.pairs[pair];
      rows[i].distances[j] = rows[j].distances[i] = pairNewtons(one.rms_n);
      if (!one.largest) continue;
      rows[i].tips[j] = rows[j].tips[i] =
          ExpertsLab::tr("At most %1: %2")
              .arg(pairNewtons(one.largest->newtons), text(elicitation::pointText(built->model, one.largest->at)));
    }
  }
  table.setRowHeads(&DistanceRow::expert);
  table.setTable(std::move(columns), std::move(rows));
}

namespace {

using elicitation::WeightPolicy;

}  // namespace

ExpertsLab::ExpertsLab(LabData& data, LabModel& model, QObject* parent)
    : QObject(parent), data_(data), model_(model), bands_(data), compare_(data, [this](const LabWork::Run& run) {
        return compare(run);
      }) {
  compare_.ignoreSettings();
  connect(&model_, &LabModel::builtChanged, this, &ExpertsLab::takeModel);
  connect(&data_, &LabData::settingsChanged, this, &ExpertsLab::changed);
  takeModel();
}

ExpertsLab::~ExpertsLab() = default;

LabWork::Deliver ExpertsLab::compare(const LabWork::Run& run) {
  const auto input = input_.load();
  if (input == nullptr) return {};
  auto models = elicitation::compareWeights(*input->built, input->study->study, input->settings);
  if (!models || run.stop.stop_requested()) return {};
  auto compared = std::make_shared<std::vector<ComparedWeights>>();
  for (const elicitation::WeightedModel& one : *models) {
    ComparedWeights row{one.policy, text(one.unavailable), {}, one.from_equal, {}};
    if (one.model) {
      for (const fuzzy::Expert& expert : one.model->experts) row.weights.push_back(expert.weight);
      if (!one.from_equal.at.empty()) row.where = text(elicitation::pointText(*one.model, one.from_equal.at));
    }
    compared->push_back(std::move(row));
  }
  return [this, compared] {
    compared_ = std::move(*compared);
    emit changed();
  };
}

void ExpertsLab::takeModel() {
  built_ = model_.built();
  if (built_ == nullptr) {
    input_.store(nullptr);
    compared_.clear();
    curves_ = {};
    draws_.drop();
    bands_.setCurve(std::nullopt);
    emit changed();
    emit curvesChanged();
    return;
  }
  const auto& inputs = built_->model.inputs;
  if (values_.size() != inputs.size()) {
    values_.clear();
    for (const fuzzy::Variable& input : inputs) values_.push_back(usualValue(input));
    const auto depth = std::find_if(inputs.begin(), inputs.end(),
                                    [](const auto& input) { return input.id == elicitation::ngtRegionInput(); });
    x_input_ = depth == inputs.end() ? 0 : static_cast<std::size_t>(depth - inputs.begin());
  }
  input_.store(std::make_shared<const Input>(Input{built_, model_.builtFrom(), model_.builtWith()}));
  compare_.restart();
  drawCurves();
  emit changed();
}

void ExpertsLab::drawCurves() {
  if (built_ == nullptr) return;
  bands_.setCurve(BandLab::Curve{built_, model_.builtFrom(), model_.builtWith(), x_input_, values_});
  draws_.run([this, built = built_, values = values_, x = x_input_](const std::stop_token&) -> Background::Deliver {
    const auto compiled = fuzzy::compile(built->model);
    if (!compiled) return {};
    auto curves = std::make_shared<figures::ForceCurves>(figures::computeCurves(built->model, *compiled, x, values));
    return [this, curves] {
      curves_ = std::move(*curves);
      emit curvesChanged();
    };
  });
}

void ExpertsLab::setValue(std::size_t input, double value) {
  if (input >= values_.size() || values_[input] == value) return;
  values_[input] = value;
  drawCurves();
}

void ExpertsLab::setPolicy(WeightPolicy policy) {
  elicitation::BuildSettings settings = data_.settings();
  if (settings.weights.policy == policy) return;
  if (policy == WeightPolicy::kTable && built_ != nullptr) {
    for (const fuzzy::Expert& expert : built_->model.experts) settings.weights.table[expert.id] = expert.weight;
  }
  settings.weights.policy = policy;
  data_.setSettings(std::move(settings));
}

void ExpertsLab::setWeight(const std::string& expert, double weight) {
  if (built_ == nullptr || !(weight >= 0)) return;
  elicitation::BuildSettings settings = data_.settings();
  auto& table = settings.weights.table;
  if (settings.weights.policy != WeightPolicy::kTable) table.clear();
  for (const fuzzy::Expert& one : built_->model.experts) table.try_emplace(one.id, one.weight);
  table[expert] = weight;
  const bool some = std::any_of(table.begin(), table.end(), [](const auto& one) { return one.second > 0; });
  if (!some) return;
  settings.weights.policy = WeightPolicy::kTable;
  data_.setSettings(std::move(settings));
}

void ExpertsLab::setWanted(bool wanted) {
  data_.setWanted(*this, wanted);
  model_.setWanted(*this, wanted);
  compare_.setWanted(wanted);
  bands_.setWanted(wanted);
}

std::vector<std::vector<double>> pullsOf(const figures::ForceCurves& curves) {
  std::vector<std::vector<double>> out;
  for (const auto& expert : curves.experts) {
    std::vector<double>& pull = out.emplace_back();
    for (std::size_t i = 0; i < expert.size(); ++i) {
      const bool fired = expert[i].fired && curves.mean[i].fired;
      pull.push_back(fired ? expert[i].force_n - curves.mean[i].force_n : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return out;
}

}  // namespace tactus::workbench
