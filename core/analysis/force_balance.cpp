#include "core/analysis/force_balance.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace tactus::analysis {
namespace {

constexpr double kSame = 1e-12;  // heights (of the highest) that differ by less coincide: one flank, rounded twice

/// Area and first moment of what lies under a line.
struct Slices {
  double area = 0;
  double moment = 0;
};

/// The heights of a set just right of `from` and just left of `to`, between which it has no vertex. As shares of the
/// largest strength, which may be too small for products.
struct Heights {
  double left = 0;
  double right = 0;
};

Heights heightsBetween(const Polyline& set, double from, double to, double highest) {
  const auto after =
      std::upper_bound(set.begin(), set.end(), from, [](double x, const Vertex& vertex) { return x < vertex.x; });
  if (after == set.begin() || after == set.end()) return {};
  const Vertex& left = *std::prev(after);
  const Vertex& right = *after;
  const auto at = [&](double x) {
    return (left.height + (right.height - left.height) * ((x - left.x) / (right.x - left.x))) / highest;
  };
  return {at(from), at(to)};
}

void add(Slices& slices, double from, double to, const Heights& heights) {
  const double width = to - from;
  const double area = width * (heights.left + heights.right) / 2;
  slices.area += area;
  slices.moment += from * area + width * width * (heights.left / 6 + heights.right / 3);
}

/// The slices of each set where it is the largest; heights as shares of the largest strength.
std::vector<Slices> slicesOf(const std::vector<ExplainedOutputTerm>& terms) {
  std::vector<double> ends;
  double highest = 0;
  for (const auto& term : terms) {
    highest = std::max(highest, term.strength);
    for (const Vertex& vertex : term.set) ends.push_back(vertex.x);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());

  std::vector<Slices> out(terms.size());
  std::vector<Heights> heights(terms.size());
  for (std::size_t piece = 1; piece < ends.size(); ++piece) {
    const double from = ends[piece - 1];
    const double width = ends[piece] - from;
    for (std::size_t t = 0; t < terms.size(); ++t)
      heights[t] = heightsBetween(terms[t].set, from, ends[piece], highest);
    // The places, as shares of the piece, where two of the lines cross.
    std::vector<double> cuts = {0, 1};
    for (std::size_t one = 0; one < terms.size(); ++one) {
      for (std::size_t other = one + 1; other < terms.size(); ++other) {
        const double left = heights[one].left - heights[other].left;
        const double right = heights[one].right - heights[other].right;
        if (left * right < 0) cuts.push_back(left / (left - right));
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t cut = 1; cut < cuts.size(); ++cut) {
      const auto at = [&](std::size_t t, double share) {
        return heights[t].left + (heights[t].right - heights[t].left) * share;
      };
      const double middle = (cuts[cut - 1] + cuts[cut]) / 2;
      std::size_t largest = 0;
      for (std::size_t t = 1; t < terms.size(); ++t) {
        if (at(t, middle) > at(largest, middle) + kSame) largest = t;
      }
      add(out[largest], from + width * cuts[cut - 1], from + width * cuts[cut],
          {at(largest, cuts[cut - 1]), at(largest, cuts[cut])});
    }
  }
  return out;
}

/// What each of the `rules` gives to a strength that is their maximum (airport game): shares that sum to 1.
std::vector<double> maxGame(const std::vector<double>& strengths) {
  std::vector<std::size_t> order(strengths.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return strengths[a] < strengths[b]; });
  std::vector<double> out(strengths.size(), 0);
  double below = 0;
  double sum = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sum += (strengths[order[i]] - below) / static_cast<double>(order.size() - i);
    below = strengths[order[i]];
    out[order[i]] = sum / strengths[order.back()];
  }
  return out;
}

/// Adds an expert whose force counts for `weight` of `balance.force_n`.
void addExpert(const fuzzy::ForceModel& model, const ExplainedExpert& explained, std::size_t expert, double weight,
               ForceBalance& balance) {
  const std::vector<Slices> slices = slicesOf(explained.output_terms);
  double area = 0;
  for (const Slices& one : slices) area += one.area;
  TACTUS_CHECK(area > 0);
  for (std::size_t t = 0; t < slices.size(); ++t) {
    const ExplainedOutputTerm& term = explained.output_terms[t];
    if (!term.winning_rule) continue;
    const double pull_n = weight * (slices[t].moment - balance.force_n * slices[t].area) / area;
    auto word = std::find_if(balance.words.begin(), balance.words.end(),
                             [&](const WordPull& one) { return one.term == term.term; });
    if (word == balance.words.end()) {
      word = balance.words.insert(balance.words.end(), WordPull{});
      word->term = term.term;
    }
    word->strength += weight * term.strength;
    word->share += weight * slices[t].area / area;
    word->pull_n += pull_n;

    std::vector<std::size_t> rules;
    std::vector<double> strengths;
    for (const ExplainedRule& rule : explained.rules) {
      if (rule.strength <= 0 || model.experts[expert].rules[rule.rule].then != term.term) continue;
      rules.push_back(rule.rule);
      strengths.push_back(rule.strength);
    }
    const std::vector<double> shares = maxGame(strengths);
    for (std::size_t r = 0; r < rules.size(); ++r) balance.rules.push_back({expert, rules[r], pull_n * shares[r]});
  }
}

}  // namespace

ForceBalance forceBalance(const fuzzy::ForceModel& model, const Explanation& explanation,
                          std::optional<std::size_t> expert) {
  ForceBalance balance;
  const auto counts = [&](std::size_t e) {
    const ExplainedExpert& one = explanation.experts[e];
    return !one.abstains && (expert ? e == *expert : one.weight_share > 0);
  };
  balance.force_n = expert ? explanation.experts[*expert].force_n : explanation.force_n;
  for (const fuzzy::Term& term : model.output.terms) balance.words.push_back({term.id, 0, 0, 0, 0});
  for (std::size_t e = 0; e < explanation.experts.size(); ++e) {
    if (!counts(e)) continue;
    const ExplainedExpert& one = explanation.experts[e];
    const double weight = expert ? 1 : one.weight_share;
    addExpert(model, one, e, weight, balance);
    ExpertPull pull{e, one.force_n, weight * (one.force_n - balance.force_n), std::nullopt};
    if (weight < 1) pull.leave_one_out_n = pull.pull_n / (1 - weight);
    balance.experts.push_back(pull);
  }
  std::erase_if(balance.words, [](const WordPull& word) { return word.strength <= 0; });
  for (WordPull& word : balance.words) {
    word.centroid_n = balance.force_n + (word.share > 0 ? word.pull_n / word.share : 0);
  }
  std::stable_sort(balance.rules.begin(), balance.rules.end(),
                   [](const RulePull& a, const RulePull& b) { return std::abs(a.pull_n) > std::abs(b.pull_n); });
  return balance;
}

}  // namespace tactus::analysis
