#include "app/workbench/labs/experts/experts_lab.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/labs/data/lab_data.h"
#include "core/analysis/force_difference.h"
#include "core/base/check.h"
#include "elicitation/agreement/expert_influence.h"

namespace tactus::workbench {
namespace {

using elicitation::BandKind;
using elicitation::BandPoint;

constexpr std::size_t kBandPoints = 121;   // every 5 mm of the depth
constexpr std::size_t kFirstShown = 200;   // replicates: fewer would only jump
constexpr std::size_t kBatchPeople = 100;  // replicates times participants between two looks whether to stop

ShownBand bandOf(const elicitation::ForceBands& bands, BandKind kind, const std::vector<double>& x) {
  ShownBand out{kind, x, bands.band(kind), bands.done(), bands.planned(), {}};
  for (std::size_t who = 0; kind == BandKind::kWords && who < bands.ownWords().size(); ++who)
    out.own_words.push_back({bands.ownWords()[who].participant, bands.underOwnWords()[who]});
  return out;
}

}  // namespace

BandLab::BandLab(QObject* parent)
    : QObject(parent),
      band_([this] { return order(); }, [](const Order& order, const auto& run) { return compute(order, run); }) {
  connect(&band_, &Computation::valueChanged, this, &BandLab::changed);
}

std::optional<BandLab::Order> BandLab::order() const {
  return curve_ && chosen_ ? std::optional(Order{*curve_, *chosen_}) : std::nullopt;
}

BandLab::Answer BandLab::compute(const Order& order, const RunOf<ShownBand>& run) {
  const Curve& curve = order.curve;
  const fuzzy::ForceModel& model = curve.built.model->model;
  elicitation::BandSettings settings;
  settings.points = analysis::linePoints(model, curve.values, curve.x_input, kBandPoints);
  settings.again = order.kind == BandKind::kAgain;
  settings.others = order.kind == BandKind::kOthers;
  settings.words = order.kind == BandKind::kWords;
  std::vector<double> x;
  for (const auto& point : settings.points) x.push_back(point[curve.x_input]);
  TACTUS_CHECK(model.inputs.size() == curve.values.size());
  auto bands = elicitation::ForceBands::of(curve.built.study->study, *curve.built.model, curve.built.settings,
                                           std::move(settings));
  if (!bands) return tl::unexpected(text(bands.error().message()));
  const std::size_t batch =
      std::clamp<std::size_t>(kBatchPeople / std::max<std::size_t>(1, model.experts.size()), 1, 25);
  while (!run.stop.stop_requested()) {
    const bool more = bands->add(batch);
    run.progress(bands->planned() == 0 ? 1
                                       : static_cast<double>(bands->done()) / static_cast<double>(bands->planned()));
    if (!more) break;
    if (bands->done() < kFirstShown || bands->done() % kFirstShown >= batch) continue;
    run.hand(bandOf(*bands, order.kind, x));
  }
  auto whole = std::make_shared<const ShownBand>(bandOf(*bands, order.kind, x));
  if (whole->band.points.empty()) {
    return tl::unexpected(order.kind == BandKind::kWords
                              ? tr("No force was judged, so no participant has words of their own.")
                              : tr("One participant alone says nothing about others."));
  }
  return whole;
}

void BandLab::setCurve(std::optional<Curve> curve) {
  curve_ = std::move(curve);
  band_.forget();
}

void BandLab::choose(std::optional<BandKind> kind) {
  if (chosen_ == kind) return;
  chosen_ = kind;
  band_.forget();
}

QString bandName(BandKind kind) {
  switch (kind) {
    case BandKind::kAgain: return BandLab::tr("Again");
    case BandKind::kOthers: return BandLab::tr("Others");
    case BandKind::kNext: return BandLab::tr("Next");
    case BandKind::kWords: return BandLab::tr("Own words");
  }
  return {};
}

QString bandMeaning(BandKind kind) {
  switch (kind) {
    case BandKind::kAgain: return BandLab::tr("The same participants once more");
    case BandKind::kOthers: return BandLab::tr("As many other participants like these");
    case BandKind::kNext: return BandLab::tr("One more participant");
    case BandKind::kWords: return BandLab::tr("The same rules under the force words of one participant at a time");
  }
  return {};
}

QString bandText(const ShownBand& shown) {
  double widest = 0;
  double abstains = 0;
  for (const BandPoint& point : shown.band.points) {
    widest = std::max(widest, (point.high_n - point.low_n) / 2);
    abstains = std::max(abstains, point.abstains);
  }
  QStringList lines;
  if (shown.done < shown.planned)
    lines << BandLab::tr("Unfinished: %1 of %2 draws.").arg(shown.done).arg(shown.planned);
  if (shown.kind == BandKind::kWords) {
    lines << BandLab::tr("%1, from the lowest to the highest: at most %2 wide. Each line is one person.")
                 .arg(bandMeaning(shown.kind), quantityText(2 * widest, "N"));
  } else {
    lines << BandLab::tr("%1, 95 % at each depth by itself: at most ± %2.")
                 .arg(bandMeaning(shown.kind), quantityText(widest, "N"));
  }
  if (abstains > 0 && shown.kind != BandKind::kWords) {
    lines << BandLab::tr("Up to %1 % of the draws give no force somewhere.").arg(numberText(abstains * 100, 0));
  }
  for (const std::string& one : shown.band.assumed) lines << text(one);
  for (const std::string& one : shown.band.not_included) lines << text(one);
  return lines.join(QLatin1Char(' '));
}

namespace {

using elicitation::WeightPolicy;

const QString kUnknown = QStringLiteral("–");

QString pairNewtons(double force_n) { return forceText(force_n, "N"); }

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

std::shared_ptr<const std::vector<ComparedWeights>> compareWeights(const BuiltStudy& from,
                                                                   const std::stop_token& stop) {
  auto models = elicitation::compareWeights(*from.model, from.study->study, from.settings);
  if (!models || stop.stop_requested()) return nullptr;
  auto compared = std::make_shared<std::vector<ComparedWeights>>();
  for (const elicitation::WeightedModel& one : *models) {
    ComparedWeights row{one.policy, text(one.unavailable), {}, one.from_equal, {}};
    if (one.model) {
      for (const fuzzy::Expert& expert : one.model->experts) row.weights.push_back(expert.weight);
      if (!one.from_equal.at.empty())
        row.where = brokenAtCommas(text(elicitation::shortPointText(*one.model, one.from_equal.at)));
    }
    compared->push_back(std::move(row));
  }
  return compared;
}

}  // namespace

ExpertsLab::ExpertsLab(LabData& data, LabModel& model, QObject* parent)
    : QObject(parent),
      data_(data),
      model_(model),
      compared_([&model] { return model.inputs(); },
                [](const BuiltStudy& from, const auto& run) -> decltype(compared_)::Answer {
                  return compareWeights(from, run.stop);
                }),
      curves_([this] { return curve(); },
              [](const BandLab::Curve& at, const auto&) -> decltype(curves_)::Answer {
                const fuzzy::ForceModel& of = at.built.model->model;
                const auto compiled = fuzzy::compile(of);
                if (!compiled) return nullptr;
                return std::make_shared<const figures::ForceCurves>(
                    figures::computeCurves(of, *compiled, at.x_input, at.values));
              }),
      words_and_rules_([&model] { return model.inputs(); },
                       [](const BuiltStudy& from, const auto& run) -> decltype(words_and_rules_)::Answer {
                         auto found = elicitation::wordsAndRules(from.study->study, *from.model, from.settings,
                                                                 {{}, run.stop, run.progress});
                         if (run.stop.stop_requested()) return nullptr;
                         if (!found) return tl::unexpected(text(found.error().message()));
                         return std::make_shared<const elicitation::WordsAndRules>(std::move(*found));
                       }) {
  for (Computation* cell : {static_cast<Computation*>(&compared_), static_cast<Computation*>(&curves_), &bands_.work(),
                            static_cast<Computation*>(&words_and_rules_)}) {
    cell->needs(model_);
  }
  connect(&compared_, &Computation::valueChanged, this, &ExpertsLab::changed);
  connect(&curves_, &Computation::valueChanged, this, &ExpertsLab::curvesChanged);
  connect(&model_, &Computation::valueChanged, this, &ExpertsLab::takeModel);
  connect(&data_, &LabData::settingsChanged, this, &ExpertsLab::changed);
  takeModel();
}

const std::vector<ComparedWeights>& ExpertsLab::compared() const {
  static const std::vector<ComparedWeights> kNone;
  return compared_.value() == nullptr ? kNone : *compared_.value();
}

const figures::ForceCurves& ExpertsLab::curves() const {
  static const figures::ForceCurves kNone;
  return curves_.value() == nullptr ? kNone : *curves_.value();
}

std::optional<BandLab::Curve> ExpertsLab::curve() const {
  const auto built = model_.inputs();
  return built ? std::optional(BandLab::Curve{*built, x_input_, values_}) : std::nullopt;
}

void ExpertsLab::takeModel() {
  built_ = model_.built();
  if (built_ != nullptr && values_.size() != built_->model.inputs.size()) {
    const auto& inputs = built_->model.inputs;
    values_.clear();
    for (const fuzzy::Variable& input : inputs) values_.push_back(usualValue(built_->about(), input));
    x_input_ = depthInput(built_->model);
  }
  compared_.refresh();
  curves_.refresh();
  words_and_rules_.refresh();
  bands_.setCurve(curve());
  emit changed();
}

void ExpertsLab::setValue(std::size_t input, double value) {
  if (input >= values_.size() || values_[input] == value) return;
  values_[input] = value;
  curves_.refresh();
  bands_.setCurve(curve());
  emit valueChanged(input);
}

void ExpertsLab::setValueOf(const std::string& input, double value) {
  if (built_ == nullptr) return;
  const auto& inputs = built_->model.inputs;
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const auto& one) { return one.id == input; });
  if (found == inputs.end() || value < found->min || value > found->max) return;
  setValue(static_cast<std::size_t>(found - inputs.begin()), value);
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
  compared_.hold(*this, wanted);
  curves_.hold(*this, wanted);
  bands_.work().hold(*this, wanted);
}

QString wordsAndRulesText(const elicitation::WordsAndRules& found) {
  if (found.participants.size() < 2) {
    return ExpertsLab::tr(
        "Fewer than two experts have both rules and words of their own: there is nothing to compare.");
  }
  if (found.points == 0) return ExpertsLab::tr("Nowhere do two experts have a force under their own words.");
  return ExpertsLab::tr("The experts lie %1 apart: %2 if only their words differ, %3 if only their rules do.")
      .arg(pairNewtons(found.both.sd_n), pairNewtons(found.words.sd_n), pairNewtons(found.rules.sd_n));
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
