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

QString policyNewtons(double force_n) { return quantityText(force_n, "N", 3); }

}  // namespace

QString policyName(WeightPolicy policy) {
  switch (policy) {
    case WeightPolicy::kEqual: return PolicyTable::tr("Equal");
    case WeightPolicy::kYears: return PolicyTable::tr("By years of experience");
    case WeightPolicy::kCategory: return PolicyTable::tr("By category");
    case WeightPolicy::kColumn: return PolicyTable::tr("From the profiles");
    case WeightPolicy::kTable: return PolicyTable::tr("Own weights");
  }
  return {};
}

PolicyTable::PolicyTable(const ExpertsLab& lab, QObject* parent)
    : LabTableModel({{tr("Weights")},
                     {tr("Of the experts")},
                     {tr("From equal, at most"), Qt::AlignRight},
                     {tr("rms"), Qt::AlignRight},
                     {tr("Where")}},
                    parent),
      lab_(lab) {}

void PolicyTable::follow() {
  beginResetModel();
  rows_ = lab_.compared();
  endResetModel();
}

int PolicyTable::rows() const { return static_cast<int>(rows_.size()); }

QVariant PolicyTable::cell(int row, int column, int role) const {
  const ComparedWeights& at = rows_[static_cast<std::size_t>(row)];
  if (role == Qt::ToolTipRole && !at.unavailable.isEmpty()) return at.unavailable;
  if (role == Qt::ToolTipRole && column >= kWeights) return cell(row, column, Qt::DisplayRole);
  if (role != Qt::DisplayRole) return {};
  if (column == kPolicy) return policyName(at.policy);
  if (!at.unavailable.isEmpty()) return column == kWeights ? tr("not in the data") : kUnknown;
  switch (column) {
    case kWeights: {
      QStringList weights;
      for (const double weight : at.weights) weights << numberText(weight, 2);
      return weights.join(QStringLiteral(" · "));
    }
    case kLargest: return policyNewtons(at.from_equal.largest_n);
    case kRms: return policyNewtons(at.from_equal.rms_n);
    case kWhere: return at.where;
    default: return {};
  }
}

namespace {

QString pairNewtons(double force_n) { return quantityText(force_n, "N", 3); }

}  // namespace

PairTable::PairTable(const ExpertsLab& lab, QObject* parent) : QAbstractTableModel(parent), lab_(lab) {}

void PairTable::follow() {
  if (built_ == lab_.built()) return;
  beginResetModel();
  built_ = lab_.built();
  endResetModel();
}

int PairTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || built_ == nullptr ? 0 : static_cast<int>(built_->model.experts.size());
}

const elicitation::ExpertDistance& PairTable::between(int first, int second) const {
  const auto row = static_cast<std::size_t>(std::min(first, second));
  const auto column = static_cast<std::size_t>(std::max(first, second));
  const std::size_t before = row * built_->model.experts.size() - row * (row + 1) / 2;  // the pairs of earlier rows
  return built_->influences.pairs[before + column - row - 1];
}

QVariant PairTable::data(const QModelIndex& index, int role) const {
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignCenter);
  if (index.row() == index.column() || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) return {};
  const elicitation::ExpertDistance& pair = between(index.row(), index.column());
  if (role == Qt::DisplayRole) return pairNewtons(pair.rms_n);
  if (!pair.largest) return {};
  return tr("At most %1: %2")
      .arg(pairNewtons(pair.largest->newtons), text(elicitation::pointText(built_->model, pair.largest->at)));
}

QVariant PairTable::headerData(int section, Qt::Orientation, int role) const {
  if (role != Qt::DisplayRole || section >= rowCount()) return {};
  return harmless(labelOf(built_->model.experts[static_cast<std::size_t>(section)]));
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
