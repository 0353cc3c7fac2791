#include "app/workbench/labs/experts/band_lab.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "core/analysis/force_difference.h"
#include "core/base/check.h"

namespace tactus::workbench {
namespace {

using elicitation::BandKind;
using elicitation::BandPoint;

constexpr std::size_t kBandPoints = 121;   // every 5 mm of the depth
constexpr std::size_t kFirstShown = 200;   // replicates: fewer would only jump
constexpr std::size_t kBatchPeople = 100;  // replicates times participants between two looks whether to stop

ShownBand bandOf(const elicitation::ForceBands& bands, BandKind kind, const std::vector<double>& x) {
  return {kind, x, bands.band(kind), bands.done(), bands.planned()};
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
  if (whole->band.points.empty()) return tl::unexpected(tr("One participant alone says nothing about others."));
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
  }
  return {};
}

QString bandMeaning(BandKind kind) {
  switch (kind) {
    case BandKind::kAgain: return BandLab::tr("The same participants once more");
    case BandKind::kOthers: return BandLab::tr("As many other participants like these");
    case BandKind::kNext: return BandLab::tr("One more participant");
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
  lines << BandLab::tr("%1, 95 % at each depth by itself: at most ± %2.")
               .arg(bandMeaning(shown.kind), quantityText(widest, "N"));
  if (abstains > 0) {
    lines << BandLab::tr("Up to %1 % of the draws give no force somewhere.").arg(numberText(abstains * 100, 0));
  }
  for (const std::string& one : shown.band.assumed) lines << text(one);
  for (const std::string& one : shown.band.not_included) lines << text(one);
  return lines.join(QLatin1Char(' '));
}

}  // namespace tactus::workbench
