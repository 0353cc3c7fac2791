#include "elicitation/agreement/conflict_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/analysis/force_difference.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::elicitation {
namespace {

CellRule cellRule(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, std::size_t rule) {
  CellRule out{rule, {}};
  for (const auto& condition : expert.rules[rule].conditions) {
    for (std::size_t k = 0; k < model.inputs.size(); ++k) {
      if (model.inputs[k].id != condition.input) continue;
      const auto* term = fuzzy::findTerm(fuzzy::termsFor(expert, model.inputs[k]), condition.term);
      out.memberships.emplace_back(k, fuzzy::MembershipFunction::of(*term));
    }
  }
  return out;
}

}  // namespace

bool CellRule::fires(const fuzzy::ForceModel& model, const std::vector<double>& point) const {
  return std::all_of(memberships.begin(), memberships.end(), [&](const auto& one) {
    const auto& input = model.inputs[one.first];
    return one.second(std::clamp(point[one.first], input.min, input.max)) > 0;
  });
}

std::vector<std::pair<std::string, std::string>> cellKey(const fuzzy::Rule& rule) {
  std::vector<std::pair<std::string, std::string>> key;
  for (const auto& condition : rule.conditions) key.emplace_back(condition.input, condition.term);
  std::sort(key.begin(), key.end());
  return key;
}

std::vector<ExpertCell> expertCells(const fuzzy::ForceModel& model) {
  std::vector<ExpertCell> cells;
  std::map<std::vector<std::pair<std::string, std::string>>, std::size_t> places;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const auto& expert = model.experts[e];
    for (std::size_t r = 0; r < expert.rules.size(); ++r) {
      if (!expert.rules[r].enabled || !(expert.rules[r].weight > 0)) continue;
      const auto [place, fresh] = places.try_emplace(cellKey(expert.rules[r]), cells.size());
      if (fresh)
        cells.push_back({expert.rules[r].conditions, std::vector<std::optional<CellRule>>(model.experts.size())});
      auto& kept = cells[place->second].rules[e];
      if (!kept) kept = cellRule(model, expert, r);
    }
  }
  return cells;
}

namespace {

using fuzzy::ForceModel;

/// The forces of all experts and their mean at every point.
struct BaseForces {
  std::vector<std::vector<fuzzy::Evaluation>> experts;  ///< per point
  std::vector<double> mean_n;                           ///< of the experts of weight > 0 that fire
};

/// Squares and their number.
struct SquareSum {
  double squares = 0;
  std::size_t count = 0;

  void add(double value, std::size_t times = 1) {
    squares += value * value * static_cast<double>(times);
    count += times;
  }
  double rms() const { return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0; }
};

class Comparer {
 public:
  Comparer(const ForceModel& model, const std::vector<std::vector<double>>& points)
      : model_(model), points_(points), weights_(normalizedWeights(model)) {}

  void evaluateAll(const fuzzy::CompiledModel& compiled) {
    base_.experts.assign(points_.size(), std::vector<fuzzy::Evaluation>(model_.experts.size()));
    for (std::size_t p = 0; p < points_.size(); ++p) {
      fuzzy::evaluateEveryExpert(compiled, points_[p], base_.experts[p]);
      base_.mean_n.push_back(meanOf(base_.experts[p]).value_or(0));
    }
  }

  ConflictMap between() const {
    ConflictMap map;
    map.points = points_.size();
    SquareSum sum;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const auto variance = varianceOf(base_.experts[p]);
      if (!variance) continue;
      sum.add(std::sqrt(*variance));
      double low = INFINITY;
      double high = -INFINITY;
      for (std::size_t e = 0; e < weights_.size(); ++e) {
        if (!takesPart(base_.experts[p], e)) continue;
        low = std::min(low, base_.experts[p][e].force_n);
        high = std::max(high, base_.experts[p][e].force_n);
      }
      if (!map.spread_at.empty() && high - low <= map.largest_spread_n) continue;
      map.largest_spread_n = high - low;
      map.spread_at = points_[p];
    }
    map.between_n = sum.rms();
    return map;
  }

  base::Result<CellConflict> compare(const ExpertCell& cell) const {
    CellConflict out;
    out.conditions = cell.conditions;
    std::vector<std::string> taking;  // words of those who take part
    for (std::size_t e = 0; e < cell.rules.size(); ++e) {
      out.words.push_back(cell.rules[e] ? model_.experts[e].rules[cell.rules[e]->rule].then : "");
      if (cell.rules[e] && weights_[e] > 0) taking.push_back(out.words.back());
    }
    out.middle_word = middleWord(taking);
    std::sort(taking.begin(), taking.end());
    std::map<std::string, std::size_t> votes;
    for (const auto& word : taking) ++votes[word];

    std::vector<std::size_t> fires;  // points where the cell fires for some expert
    std::vector<std::vector<std::size_t>> of_expert(cell.rules.size());
    firingPoints(cell, fires, of_expert);
    out.points = fires.size();
    out.felt_n = meanForces(of_expert);
    if (votes.size() < 2) return out;
    if (auto ok = exchangeWords(cell, votes, fires, of_expert, out); !ok) return tl::unexpected(ok.error());
    return out;
  }

 private:
  /// The forces of one expert with one other word at the points where the cell fires for the expert.
  struct Variant {
    std::size_t expert;
    std::string word;
  };

  static constexpr std::size_t kTogether = fuzzy::kMostExperts;

  bool takesPart(const std::vector<fuzzy::Evaluation>& at, std::size_t expert) const {
    return weights_[expert] > 0 && at[expert].fired;
  }

  std::optional<double> meanOf(const std::vector<fuzzy::Evaluation>& at) const {
    double sum = 0;
    double weights = 0;
    for (std::size_t e = 0; e < weights_.size(); ++e) {
      if (!takesPart(at, e)) continue;
      sum += weights_[e] * at[e].force_n;
      weights += weights_[e];
    }
    if (!(weights > 0)) return std::nullopt;
    return sum / weights;
  }

  /// Variance (n - 1) between the experts; nothing with fewer than two of them.
  std::optional<double> varianceOf(const std::vector<fuzzy::Evaluation>& at) const {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t e = 0; e < weights_.size(); ++e) {
      if (!takesPart(at, e)) continue;
      sum += at[e].force_n;
      ++count;
    }
    if (count < 2) return std::nullopt;
    const double mean = sum / static_cast<double>(count);
    double squares = 0;
    for (std::size_t e = 0; e < weights_.size(); ++e) {
      if (takesPart(at, e)) squares += (at[e].force_n - mean) * (at[e].force_n - mean);
    }
    return squares / static_cast<double>(count - 1);
  }

  std::string middleWord(std::vector<std::string> words) const {
    if (words.empty()) return {};
    const auto level = [this](const std::string& word) {
      const auto& terms = model_.output.terms;
      return std::find_if(terms.begin(), terms.end(), [&](const auto& term) { return term.id == word; }) -
             terms.begin();
    };
    std::stable_sort(words.begin(), words.end(),
                     [&](const auto& one, const auto& other) { return level(one) < level(other); });
    return words[words.size() / 2];
  }

  void firingPoints(const ExpertCell& cell, std::vector<std::size_t>& fires,
                    std::vector<std::vector<std::size_t>>& of_expert) const {
    for (std::size_t p = 0; p < points_.size(); ++p) {
      bool some = false;
      for (std::size_t e = 0; e < cell.rules.size(); ++e) {
        if (!cell.rules[e] || !cell.rules[e]->fires(model_, points_[p])) continue;
        of_expert[e].push_back(p);
        some = true;
      }
      if (some) fires.push_back(p);
    }
  }

  std::vector<double> meanForces(const std::vector<std::vector<std::size_t>>& of_expert) const {
    std::vector<double> out;
    for (std::size_t e = 0; e < of_expert.size(); ++e) {
      double sum = 0;
      for (const auto p : of_expert[e]) sum += base_.experts[p][e].force_n;
      out.push_back(of_expert[e].empty() ? 0 : sum / static_cast<double>(of_expert[e].size()));
    }
    return out;
  }

  base::Result<void> exchangeWords(const ExpertCell& cell, const std::map<std::string, std::size_t>& votes,
                                   const std::vector<std::size_t>& fires,
                                   const std::vector<std::vector<std::size_t>>& of_expert, CellConflict& out) const {
    auto after = base_.experts;  // with the middle word for all
    SquareSum newtons;
    SquareSum noticeable;
    std::vector<Variant> variants;
    const auto take = [&]() -> base::Result<void> {
      TACTUS_TRY(const auto compiled, compileVariants(cell, variants));
      std::vector<fuzzy::Evaluation> forces(variants.size());
      for (const auto p : fires) {
        fuzzy::evaluateEveryExpert(compiled, points_[p], forces);
        for (std::size_t v = 0; v < variants.size(); ++v) {
          const auto& [expert, word] = variants[v];
          if (!cell.rules[expert]->fires(model_, points_[p])) continue;
          const double moved_n = std::abs(forces[v].force_n - base_.experts[p][expert].force_n);
          newtons.add(moved_n, votes.at(word));
          noticeable.add(moved_n / justNoticeableDifference(std::abs(base_.mean_n[p])), votes.at(word));
          out.largest_n = std::max(out.largest_n, moved_n);
          if (word == out.middle_word) after[p][expert] = forces[v];
        }
      }
      variants.clear();
      return {};
    };
    for (std::size_t e = 0; e < cell.rules.size(); ++e) {
      if (!cell.rules[e] || !(weights_[e] > 0)) continue;
      for (const auto& [word, times] : votes) {
        if (word == out.words[e]) {
          // The word of another expert who says the same moves nothing, and counts.
          newtons.count += (times - 1) * of_expert[e].size();
          noticeable.count += (times - 1) * of_expert[e].size();
          continue;
        }
        if (fuzzy::findTerm(fuzzy::termsFor(model_.experts[e], model_.output), word) == nullptr) continue;
        variants.push_back({e, word});
        if (variants.size() < kTogether) continue;
        if (auto ok = take(); !ok) return ok;
      }
    }
    if (!variants.empty()) {
      if (auto ok = take(); !ok) return ok;
    }
    out.rms_n = newtons.rms();
    out.rms_noticeable = noticeable.rms();
    consensus(after, fires, out);
    return {};
  }

  /// What changes if all take the middle word.
  void consensus(const std::vector<std::vector<fuzzy::Evaluation>>& after, const std::vector<std::size_t>& fires,
                 CellConflict& out) const {
    SquareSum stake;
    for (const auto p : fires) stake.add(meanOf(after[p]).value_or(0) - base_.mean_n[p]);
    out.stake_n = stake.rms();
    double before_sum = 0;
    double after_sum = 0;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      before_sum += varianceOf(base_.experts[p]).value_or(0);
      after_sum += varianceOf(after[p]).value_or(0);
    }
    if (before_sum > 0) out.share = 1 - after_sum / before_sum;
  }

  base::Result<fuzzy::CompiledModel> compileVariants(const ExpertCell& cell,
                                                     const std::vector<Variant>& variants) const {
    ForceModel changed;
    changed.name = model_.name;
    changed.inputs = model_.inputs;
    changed.output = model_.output;
    changed.implication = model_.implication;
    for (std::size_t v = 0; v < variants.size(); ++v) {
      auto& expert = changed.experts.emplace_back(model_.experts[variants[v].expert]);
      expert.id = std::to_string(v);
      expert.weight = 1;
      auto& rules = expert.rules;
      rules[cell.rules[variants[v].expert]->rule].then = variants[v].word;
      // Another rule with the same conditions may already say this word.
      const auto& moved = rules[cell.rules[variants[v].expert]->rule];
      for (std::size_t r = rules.size(); r-- > 0;) {
        if (&rules[r] == &moved || rules[r].then != moved.then || cellKey(rules[r]) != cellKey(moved)) continue;
        rules.erase(rules.begin() + static_cast<std::ptrdiff_t>(r));
        break;
      }
    }
    return fuzzy::compile(changed);
  }

  const ForceModel& model_;
  const std::vector<std::vector<double>>& points_;
  std::vector<double> weights_;  ///< normalizedWeights
  BaseForces base_;
};

}  // namespace

base::Result<ConflictMap> conflictMap(const ForceModel& model, const ConflictSettings& settings) {
  TACTUS_TRY(const auto compiled, fuzzy::compile(model));
  const auto points = settings.points.empty() ? analysis::boxPoints(model) : settings.points;
  for (const auto& point : points) TACTUS_CHECK(point.size() == model.inputs.size());
  Comparer comparer(model, points);
  comparer.evaluateAll(compiled);
  ConflictMap map = comparer.between();
  const auto cells = expertCells(model);
  for (const auto& cell : cells) {
    if (settings.stop.stop_requested()) {
      return base::fail(base::ErrorCode::kCancelled, "conflict map", "a request to stop", "time to end");
    }
    TACTUS_TRY(auto compared, comparer.compare(cell));
    map.cells.push_back(std::move(compared));
    if (settings.progress) settings.progress(static_cast<double>(map.cells.size()) / static_cast<double>(cells.size()));
  }
  return map;
}

}  // namespace tactus::elicitation
