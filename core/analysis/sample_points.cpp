#include "core/analysis/sample_points.h"

#include <algorithm>
#include <array>

namespace tactus::analysis {
namespace {

// More than four experts with own terms have; bounds the memory for a thousand of them.
constexpr std::size_t kMostVertices = 200;

// Values per input that even points are drawn from: the middles of as many equal cells.
constexpr int kCells = 256;

void addVertices(const std::vector<fuzzy::Term>& terms, const fuzzy::Variable& input, std::vector<double>& values) {
  for (const auto& term : terms) {
    const std::size_t count = term.shape == fuzzy::Shape::kGaussian ? 1 : term.points.size();
    for (std::size_t k = 0; k < count; ++k) {
      if (term.points[k] > input.min && term.points[k] < input.max) values.push_back(term.points[k]);
    }
  }
}

}  // namespace

std::size_t affordablePoints(std::size_t rules) {
  return std::clamp<std::size_t>(100'000'000 / std::max<std::size_t>(1, rules), 100, 20'000);
}

double halton(std::size_t index, std::size_t dimension) {
  constexpr std::array<std::size_t, fuzzy::kMostInputs> kPrimes = {2, 3, 5, 7, 11, 13, 17, 19};
  const std::size_t base = kPrimes[dimension];
  double share = 1;
  double value = 0;
  for (; index > 0; index /= base) {
    share /= static_cast<double>(base);
    value += share * static_cast<double>(index % base);
  }
  return value;
}

std::vector<std::vector<double>> sortedVertices(const fuzzy::ForceModel& model) {
  std::vector<std::vector<double>> all;
  for (const auto& input : model.inputs) {
    auto& values = all.emplace_back();
    addVertices(input.terms, input, values);
    for (const auto& expert : model.experts) {
      for (const auto& own : expert.overrides) {
        if (own.variable == input.id) addVertices(own.terms, input, values);
      }
    }
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }
  return all;
}

std::vector<double> valuesWorthALook(std::span<const double> vertices, double low, double high) {
  std::vector<double> values = {low};
  const auto first = std::upper_bound(vertices.begin(), vertices.end(), low);
  const auto last = std::lower_bound(first, vertices.end(), high);
  const auto count = static_cast<std::size_t>(last - first);
  const std::size_t taken = std::min(count, kMostVertices);
  for (std::size_t k = 0; k < taken; ++k) values.push_back(first[static_cast<std::ptrdiff_t>(k * count / taken)]);
  if (high > low) values.push_back(high);
  for (std::size_t i = values.size() - 1; i > 0; --i) values.push_back(values[i - 1] + (values[i] - values[i - 1]) / 2);
  return values;
}

SamplePoints::SamplePoints(std::vector<std::vector<double>> values, std::size_t most) : values_(std::move(values)) {
  for (const auto& list : values_) size_ = std::min(size_ * list.size(), most + 1);
  all_ = size_ <= most;
  size_ = std::min(size_, most);
}

SamplePoints::Choice SamplePoints::choice(std::size_t index) const {
  Choice choice;
  std::size_t rest = index;
  for (const auto& list : values_) {
    const double share = halton(index + 1, choice.size());
    const auto drawn = static_cast<std::size_t>(share * static_cast<double>(list.size()));
    choice.push_back(all_ ? rest % list.size() : std::min(drawn, list.size() - 1));
    rest /= list.size();
  }
  return choice;
}

std::vector<double> SamplePoints::at(const Choice& choice) const {
  std::vector<double> point;
  for (std::size_t i = 0; i < values_.size(); ++i) point.push_back(values_[i][choice[i]]);
  return point;
}

void SamplePoints::climb(Choice start, double value,
                         const std::function<std::optional<double>(const Choice&)>& look) const {
  if (all_) return;
  std::size_t left = size_;
  for (bool better = true; better;) {
    better = false;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const std::size_t before = start[i];
      std::size_t best = before;
      for (std::size_t k = 0; k < values_[i].size(); ++k) {
        if (k == before) continue;
        if (left-- == 0) return;
        start[i] = k;
        const auto other = look(start);
        if (!other || *other <= value) continue;
        value = *other;
        best = k;
        better = true;
      }
      start[i] = best;
    }
  }
}

SamplePoints kinkPoints(const fuzzy::ForceModel& model, std::size_t most) {
  const auto vertices = sortedVertices(model);
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    values.push_back(valuesWorthALook(vertices[i], model.inputs[i].min, model.inputs[i].max));
  }
  return {std::move(values), most};
}

SamplePoints evenPoints(const fuzzy::ForceModel& model, std::size_t most) {
  std::vector<std::vector<double>> values;
  for (const auto& input : model.inputs) {
    auto& middles = values.emplace_back();
    for (int k = 0; k < kCells; ++k) middles.push_back(input.min + (k + 0.5) / kCells * (input.max - input.min));
  }
  return {std::move(values), most};
}

}  // namespace tactus::analysis
