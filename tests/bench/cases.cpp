#include "tests/bench/cases.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/base/random.h"

#include "tests/reference/exact_model.h"
#include "tests/support/ngt_model.h"

namespace tactus::bench {
namespace {

constexpr std::uint64_t kSeed = 20261121;
constexpr int kCells = 10;  ///< per input

/// `term` of a list moved by `steps`, staying in the list.
std::string shiftedTerm(const std::vector<fuzzy::Term>& terms, const std::string& id, int steps) {
  const auto at = static_cast<int>(fuzzy::findTerm(terms, id) - terms.data());
  return terms[static_cast<std::size_t>(std::clamp(at + steps, 0, static_cast<int>(terms.size()) - 1))].id;
}

/// Terms whose inner vertices lie up to 2 % of the universe beside those of `variable`, the order kept.
std::vector<fuzzy::Term> movedTerms(const fuzzy::Variable& variable, base::Random& random) {
  std::vector<fuzzy::Term> terms = variable.terms;
  for (fuzzy::Term& term : terms) {
    for (double& point : term.points) {
      if (point > variable.min && point < variable.max)
        point += random.uniform(-0.02, 0.02) * (variable.max - variable.min);
      point = std::clamp(point, variable.min, variable.max);
    }
    std::sort(term.points.begin(), term.points.end());
  }
  return terms;
}

fuzzy::Expert syntheticVariation(const fuzzy::ForceModel& model, int number, bool own_terms) {
  base::Random random(kSeed + static_cast<std::uint64_t>(number));
  fuzzy::Expert expert = model.experts.front();
  expert.id = "synthetic_" + std::to_string(number);
  expert.label = "Synthetic variation " + std::to_string(number) + " of S4";
  for (fuzzy::Rule& rule : expert.rules) {
    if (random.below(3) == 0) rule.then = shiftedTerm(model.output.terms, rule.then, random.below(5) - 2);
  }
  if (own_terms) {
    for (const fuzzy::Variable& input : model.inputs) expert.overrides.push_back({input.id, movedTerms(input, random)});
    expert.overrides.push_back({model.output.id, movedTerms(model.output, random)});
  }
  return expert;
}

}  // namespace

void Points::add(std::span<const double> point) {
  inputs = point.size();
  columns.resize(inputs);
  rows.insert(rows.end(), point.begin(), point.end());
  for (std::size_t i = 0; i < inputs; ++i) columns[i].push_back(point[i]);
}

std::vector<std::optional<double>> sceneOfNgt() {
  return {kFixedLubrication, kFixedNeckFlexionDeg, std::nullopt, std::nullopt};
}

Points shuffledPoints(const fuzzy::ForceModel& model, const std::vector<std::optional<double>>& fixed) {
  TACTUS_CHECK(model.inputs.size() == 4);
  std::vector<int> cells(kCells * kCells * kCells * kCells);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = static_cast<int>(i);
  base::Random random(kSeed);
  for (std::size_t i = cells.size(); i > 1; --i) {
    std::swap(cells[i - 1], cells[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  }
  Points points;
  for (int cell : cells) {
    std::vector<double> point;
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      const fuzzy::Variable& input = model.inputs[i];
      const double share = (cell % kCells + random.uniform()) / kCells;
      point.push_back(fixed.at(i).value_or(input.min + (input.max - input.min) * share));
      cell /= kCells;
    }
    points.add(point);
  }
  return points;
}

fuzzy::ForceModel oneExpert(fuzzy::Implication implication) {
  fuzzy::ForceModel model = support::s4FiveRegions();
  model.implication = implication;
  return model;
}

fuzzy::ForceModel syntheticExperts(int count, bool own_terms) {
  fuzzy::ForceModel model = oneExpert(fuzzy::Implication::kClip);
  for (int number = 1; number < count; ++number) {
    model.experts.push_back(syntheticVariation(model, number, own_terms));
  }
  return model;
}

Case makeCase(std::string name, fuzzy::ForceModel model, std::vector<std::optional<double>> fixed,
              std::size_t exact_points) {
  auto compiled = fuzzy::compile(model);
  TACTUS_CHECK(compiled.has_value());
  Case out{std::move(name), std::move(model), std::move(*compiled), std::move(fixed), {}, {}, {}};
  out.points = shuffledPoints(out.model, out.fixed);
  for (std::size_t p = 0; p < out.points.count(); ++p) {
    const auto row = out.points.row(p);
    const fuzzy::Evaluation force = out.compiled.evaluate(row);
    TACTUS_CHECK(force.fired);
    out.one_point_n.push_back(force.force_n);
    if (p < exact_points) out.exact_n.push_back(*reference::exactForce(out.model, {row.begin(), row.end()}));
  }
  return out;
}

}  // namespace tactus::bench
