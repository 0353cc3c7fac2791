#include "app/workbench/plot/label_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tactus::workbench {
namespace {

// The step of QCPAxisTicker with its readable steps: 1, 2, 2.5, 5 times a power of ten.
double roundStep(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double best = power;
  for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0}) {
    if (std::abs(factor * power - rough) < std::abs(best - rough)) best = factor * power;
  }
  return best;
}

}  // namespace

std::vector<double> universeTicks(double min, double max, int count) {
  std::vector<double> ticks = {min};
  if (count > 1) {
    const double step = roundStep((max - min) / count);
    for (auto i = static_cast<long long>(std::ceil(min / step)); static_cast<double>(i) * step <= max; ++i) {
      const double tick = static_cast<double>(i) * step;
      if (tick - min > 0.6 * step && max - tick > 0.6 * step) ticks.push_back(tick);
    }
  }
  ticks.push_back(max);
  return ticks;
}

namespace {

constexpr double kShiftScale = 10;     // px; a few small shifts are better than a long one, so they count squared
constexpr double kRowCost = 6;         // of standing a row further up
constexpr double kCrossingCost = 200;  // of a line to its place that runs through another name
constexpr double kSwapCost = 200;      // of a name that stands left of the name before it
constexpr double kHiddenCost = 10000;  // of a name that is left out
constexpr int kMostSteps = 4000;       // of the search; the first try is good already, this bounds the time

using Places = std::vector<std::optional<LabelPlace>>;

// Depth-first over the rows of each label, cheapest first, cut off where the cost is above the best so far.
class Search {
 public:
  Search(std::span<const Label> labels, int rows, double left, double right, double gap)
      : labels_(labels), rows_(rows), left_(left), right_(right), gap_(gap), places_(labels.size()) {}

  Places run() {
    place(0, 0);
    return best_;
  }

 private:
  struct Choice {
    std::optional<LabelPlace> place;
    double cost = kHiddenCost;
  };

  void place(std::size_t index, double cost) {
    if (cost >= best_cost_ || (++steps_ > kMostSteps && !best_.empty())) return;
    if (index == labels_.size()) {
      best_cost_ = cost;
      best_ = places_;
      return;
    }
    std::vector<Choice> choices(1);
    for (int row = 0; row < rows_; ++row) {
      if (const auto choice = inRow(index, row)) choices.push_back(*choice);
    }
    std::sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) { return a.cost < b.cost; });
    for (const Choice& choice : choices) {
      places_[index] = choice.place;
      place(index + 1, cost + choice.cost);
    }
    places_[index].reset();
  }

  std::optional<Choice> inRow(std::size_t index, int row) const {
    const Label& label = labels_[index];
    double first = left_;
    for (std::size_t i = 0; i < index; ++i) {
      if (places_[i] && places_[i]->row == row) first = std::max(first, places_[i]->left + labels_[i].width + gap_);
    }
    const double last = right_ - label.width;
    if (first > last) return std::nullopt;
    const LabelPlace place{std::clamp(label.center - label.width / 2, first, last), row};
    const double shift = place.left + label.width / 2 - label.center;
    double cost = shift * shift / kShiftScale + kRowCost * row;
    for (std::size_t i = 0; i < index; ++i) {
      if (!places_[i] || places_[i]->row == row) continue;
      if (place.left < places_[i]->left) cost += kSwapCost;
      const bool above = row > places_[i]->row;
      const bool crosses =
          above ? lineMeets(label, place, labels_[i], *places_[i]) : lineMeets(labels_[i], *places_[i], label, place);
      if (crosses) cost += kCrossingCost;
    }
    return Choice{place, cost};
  }

  // Whether the line from the upper label down to its place touches the lower label.
  static bool lineMeets(const Label& upper, const LabelPlace& upper_at, const Label& lower,
                        const LabelPlace& lower_at) {
    const double start = lineStart(upper, upper_at);
    return std::min(start, upper.center) < lower_at.left + lower.width + 2 &&
           std::max(start, upper.center) > lower_at.left - 2;
  }

  std::span<const Label> labels_;
  int rows_;
  double left_;
  double right_;
  double gap_;
  Places places_;
  Places best_;
  double best_cost_ = std::numeric_limits<double>::infinity();
  int steps_ = 0;
};

}  // namespace

std::vector<std::optional<LabelPlace>> placeLabels(std::span<const Label> labels, int rows, double left, double right,
                                                   double gap) {
  return Search(labels, rows, left, right, gap).run();
}

double lineStart(const Label& label, const LabelPlace& place) {
  constexpr double kInset = 3;  // px, so that the line does not start at the very end of the name
  return std::clamp(label.center, place.left + kInset, place.left + std::max(kInset, label.width - kInset));
}

}  // namespace tactus::workbench
