#include "elicitation/rules/question_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/clustering/positive_solve.h"

namespace tactus::elicitation {
namespace {

using base::Result;
using study::ItemCondition;

constexpr std::size_t kDraws = 120;
constexpr std::size_t kPoints = 120;
constexpr std::uint64_t kSeed = 20'260'629;

// The prior on a scale of five words, in words. Directions are those that the procedure declares.
constexpr double kConditionEffect = 0.8;
constexpr double kRateEffect = 0.6;
constexpr double kNurseSd = 0.5;
constexpr double kRegionSd = 0.9;
constexpr double kConditionSd = 0.5;
constexpr double kSlopeSd = 0.4;
constexpr double kRegionInputSd = 0.3;
constexpr double kOwnSd = 0.45;
constexpr double kAnswerSd = 0.15;
constexpr double kRounding = 1.0 / 12;  // variance of a word for a level

double square(double x) { return x * x; }

/// A part of the levels that several items share.
struct Effect {
  double sd = 0;
  std::vector<double> of_item;  ///< its coefficient in each
};

}  // namespace

struct AnswerBelief::Parts {
  fuzzy::ForceModel model;           ///< one expert, a rule for each item; its words are placeholders
  std::vector<std::size_t> rule_of;  ///< of each item, npos without one
  std::size_t words = 0;
  double scale = 1;  ///< of the prior: words per word of a scale of five
  std::vector<double> mean;
  std::vector<Effect> effects;
  std::vector<std::vector<double>> points;

  std::vector<double> covariances;  ///< of the levels, item by item

  std::size_t items() const { return mean.size(); }
  double covariance(std::size_t i, std::size_t k) const { return covariances[i * items() + k]; }
  void fillCovariances() {
    for (std::size_t i = 0; i < items(); ++i) {
      for (std::size_t k = 0; k < items(); ++k) {
        double sum = i == k ? square(kOwnSd * scale) : 0;
        for (const Effect& effect : effects) sum += square(effect.sd) * effect.of_item[i] * effect.of_item[k];
        covariances.push_back(sum);
      }
    }
  }
  std::size_t wordAt(double level) const {
    return static_cast<std::size_t>(std::clamp(std::round(level), 0.0, static_cast<double>(words - 1)));
  }
  std::vector<double> drawn(base::Random& random) const {
    std::vector<double> out = mean;
    for (const Effect& effect : effects) {
      const double value = effect.sd * random.normal();
      for (std::size_t i = 0; i < out.size(); ++i) out[i] += value * effect.of_item[i];
    }
    for (double& level : out) level += kOwnSd * scale * random.normal();
    return out;
  }
  /// `levels` moved to what the answers say: K (K + N)^-1 (answers - levels), so that a draw of the prior becomes one
  /// of the posterior, and its mean the mean.
  std::vector<double> conditioned(std::vector<double> levels, const std::vector<std::size_t>& answered,
                                  std::vector<double> differences) const {
    const std::size_t count = answered.size();
    std::vector<double> matrix(count * count);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < count; ++k) {
        matrix[i * count + k] = covariance(answered[i], answered[k]);
        if (i == k) matrix[i * count + k] += square(kAnswerSd * scale) + kRounding;
      }
    }
    if (count == 0 || !solvePositive(matrix, differences)) return levels;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      for (std::size_t k = 0; k < count; ++k) levels[i] += covariance(i, answered[k]) * differences[k];
    }
    return levels;
  }
};

namespace {

/// -1 for the first word of an input, 1 for its last.
double placeIn(const std::vector<fuzzy::Term>& terms, const std::string& term) {
  const auto at = std::find_if(terms.begin(), terms.end(), [&](const auto& one) { return one.id == term; });
  if (at == terms.end() || terms.size() < 2) return 0;
  return 2.0 * static_cast<double>(at - terms.begin()) / static_cast<double>(terms.size() - 1) - 1;
}

double declared(procedure::Direction direction) {
  switch (direction) {
    case procedure::Direction::kRises: return 1;
    case procedure::Direction::kFalls: return -1;
    case procedure::Direction::kNone: break;
  }
  return 0;
}

/// Even over the universes, the rate up to the middle of its fastest word.
std::vector<std::vector<double>> pointsOfUse(const procedure::Procedure& about) {
  base::Random random(kSeed);
  std::vector<std::vector<double>> out(kPoints);
  for (auto& point : out) {
    for (std::size_t i = 0; i < about.inputs.size(); ++i) {
      const fuzzy::Variable& input = about.inputs[i];
      double end = input.max;
      if (i == about.rate()) {
        const auto& corners = input.terms.back().points;
        end = (corners[corners.size() - 2] + corners.back()) / 2;
      }
      point.push_back(random.uniform(input.min, end));
    }
  }
  return out;
}

}  // namespace

Result<AnswerBelief> AnswerBelief::make(const procedure::Procedure& about, const study::Form& form) {
  Parts out;
  out.words = about.output.terms.size();
  out.scale = out.words > 1 ? static_cast<double>(out.words - 1) / 4 : 1;
  out.model.name = form.id;
  out.model.inputs = about.inputs;
  if (const auto* set = about.wayTerms(form.depth_terms)) out.model.inputs[about.way()].terms = set->terms;
  out.model.output = about.output;
  fuzzy::Expert& expert = out.model.experts.emplace_back();
  expert.id = expert.label = "belief";
  const std::string& way = about.wayInput().id;
  std::map<std::string, std::vector<std::pair<std::size_t, double>>> shared;  // items and coefficients by effect
  std::map<std::string, double> sds;
  for (std::size_t item = 0; item < form.items.size(); ++item) {
    const auto& conditions = form.items[item].conditions;
    double mean = static_cast<double>(out.words - 1) / 2;
    const auto shares = [&](const std::string& effect, double sd, double coefficient) {
      shared[effect].emplace_back(item, coefficient);
      sds[effect] = sd * out.scale;
    };
    std::string region;
    for (const ItemCondition& condition : conditions) {
      if (condition.input == way) region = condition.term;
    }
    shares("nurse", kNurseSd, 1);
    if (!region.empty()) shares("region " + region, kRegionSd, 1);
    for (const ItemCondition& condition : conditions) {
      if (condition.input == way) continue;
      shares("condition " + condition.input + ' ' + condition.term, kConditionSd, 1);
      shares("region and input " + region + ' ' + condition.input, kRegionInputSd, 1);
      for (std::size_t i = 0; i < about.inputs.size(); ++i) {
        if (about.inputs[i].id != condition.input) continue;
        const double place = placeIn(about.inputs[i].terms, condition.term);
        shares("slope " + condition.input, kSlopeSd, place);
        const double effect = i == about.rate() ? kRateEffect : kConditionEffect;
        mean += out.scale * effect * declared(about.input_notes[i].direction) * place;
      }
    }
    out.mean.push_back(mean);
    const bool is_rule = !study::isWayOut(form.items[item]);
    out.rule_of.push_back(is_rule ? expert.rules.size() : std::string::npos);
    if (!is_rule) continue;
    fuzzy::Rule& rule = expert.rules.emplace_back();
    for (const ItemCondition& condition : conditions) rule.conditions.push_back({condition.input, condition.term});
    rule.then = about.output.terms.front().id;
  }
  for (const auto& [name, items] : shared) {
    Effect effect{sds.at(name), std::vector<double>(form.items.size(), 0)};
    for (const auto& [item, coefficient] : items) effect.of_item[item] = coefficient;
    out.effects.push_back(std::move(effect));
  }
  out.fillCovariances();
  out.points = pointsOfUse(about);
  if (const auto ok = fuzzy::compile(out.model); !ok) return tl::unexpected(ok.error());
  AnswerBelief belief;
  belief.parts_ = std::make_shared<const Parts>(std::move(out));
  return belief;
}

ForceKnown AnswerBelief::known(std::span<const std::optional<std::size_t>> words) const {
  const Parts& parts = *parts_;
  std::vector<std::size_t> answered;
  for (std::size_t i = 0; i < parts.items(); ++i) {
    if (words[i]) answered.push_back(i);
  }
  const auto differences = [&](const std::vector<double>& levels) {
    std::vector<double> out;
    for (const std::size_t i : answered) out.push_back(static_cast<double>(*words[i]) - levels[i]);
    return out;
  };

  ForceKnown out;
  const std::vector<double> expected = parts.conditioned(parts.mean, answered, differences(parts.mean));
  for (std::size_t i = 0; i < parts.items(); ++i)
    out.expected.push_back(words[i] ? *words[i] : parts.wordAt(expected[i]));

  out.shares.assign(parts.items(), 0);
  bool open = false;
  for (std::size_t i = 0; i < parts.items(); ++i) open = open || (!words[i] && parts.rule_of[i] != std::string::npos);
  if (!open) return out;

  // One draw for each row: the words of all items, and the forces at all points.
  base::Random random(kSeed + answered.size());
  std::vector<std::vector<std::size_t>> drawn(kDraws);
  std::vector<std::vector<double>> forces(kDraws);
  fuzzy::ForceModel model = parts.model;
  for (std::size_t draw = 0; draw < kDraws; ++draw) {
    const std::vector<double> prior = parts.drawn(random);
    std::vector<double> noisy = prior;
    for (double& level : noisy) level += std::sqrt(square(kAnswerSd * parts.scale) + kRounding) * random.normal();
    const std::vector<double> levels = parts.conditioned(prior, answered, differences(noisy));
    for (std::size_t i = 0; i < parts.items(); ++i) {
      drawn[draw].push_back(words[i] ? *words[i] : parts.wordAt(levels[i]));
      if (parts.rule_of[i] == std::string::npos) continue;
      model.experts.front().rules[parts.rule_of[i]].then = model.output.terms[drawn[draw].back()].id;
    }
    const auto compiled = fuzzy::compile(model);  // as valid as the one of `make`
    for (const auto& point : parts.points) forces[draw].push_back(compiled->evaluate(point).force_n);
  }

  // Sums of squares within the words of an item and over all draws; the share is corrected for the number of words, as
  // few draws of many words would explain something by chance.
  std::vector<double> total(kPoints, 0);
  for (const auto& row : forces) {
    for (std::size_t p = 0; p < kPoints; ++p) total[p] += row[p] / kDraws;
  }
  double all = 0;
  for (const auto& row : forces) {
    for (std::size_t p = 0; p < kPoints; ++p) all += square(row[p] - total[p]);
  }
  out.sd_n = std::sqrt(all / kPoints / (kDraws - 1));
  for (std::size_t i = 0; i < parts.items() && all > 0; ++i) {
    if (words[i] || parts.rule_of[i] == std::string::npos) continue;
    std::vector<std::size_t> count(parts.words, 0);
    std::vector<std::vector<double>> sum(parts.words, std::vector<double>(kPoints, 0));
    for (std::size_t draw = 0; draw < kDraws; ++draw) {
      ++count[drawn[draw][i]];
      for (std::size_t p = 0; p < kPoints; ++p) sum[drawn[draw][i]][p] += forces[draw][p];
    }
    double between = 0;
    std::size_t groups = 0;
    for (std::size_t w = 0; w < parts.words; ++w) {
      if (count[w] == 0) continue;
      ++groups;
      const auto n = static_cast<double>(count[w]);
      for (std::size_t p = 0; p < kPoints; ++p) between += n * square(sum[w][p] / n - total[p]);
    }
    const double within = (all - between) / static_cast<double>(kDraws - groups);
    out.shares[i] = std::clamp(1 - within / (all / (kDraws - 1)), 0.0, 1.0);
  }
  return out;
}

}  // namespace tactus::elicitation
