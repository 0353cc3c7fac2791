// Splits each input at the ends of the supports into points and open intervals; within such a cell the set of live
// rules is constant. Cells with the same live rules are merged before the next input is looked at, which keeps the
// search small.
#include "core/analysis/coverage.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "core/analysis/rule_table.h"
#include "core/base/check.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;
using fuzzy::MembershipFunction;

struct LiveCondition {
  std::size_t input;
  MembershipFunction function;
};

using LiveRule = std::vector<LiveCondition>;

/// One point or one open interval of an input.
struct Cell {
  double low, high;
  bool point;

  double representative() const { return point ? low : low + (high - low) / 2; }
};

/// Rules with equal conditions count once: experts that share their terms ask mostly the same questions.
std::vector<LiveRule> liveRules(const ForceModel& model, std::span<const std::size_t> experts) {
  using Key = std::vector<std::tuple<std::size_t, bool, double, double, double, double, double, double>>;
  std::vector<LiveRule> rules;
  std::set<Key> seen;
  for (const std::size_t e : experts) {
    const auto& expert = model.experts[e];
    for (const auto& rule : resolveRules(model, expert)) {
      LiveRule live;
      Key key;
      for (std::size_t i = 0; i < model.inputs.size(); ++i) {
        if (rule.termOf(i) < 0) continue;
        const auto& term = termsFor(expert, model.inputs[i])[static_cast<std::size_t>(rule.termOf(i))];
        const auto f = MembershipFunction::of(term);
        live.push_back({i, f});
        key.emplace_back(i, f.gaussian, f.a, f.b, f.c, f.d, f.mean, f.sigma);
      }
      if (seen.insert(std::move(key)).second) rules.push_back(std::move(live));
    }
  }
  return rules;
}

std::vector<Cell> cellsOf(const fuzzy::Variable& variable, std::size_t input, const std::vector<LiveRule>& rules) {
  std::vector<double> ends = {variable.min, variable.max};
  std::set<std::pair<double, double>> gaussians;  // mean and sigma of those that are cut already
  for (const auto& rule : rules) {
    for (const auto& condition : rule) {
      const auto& f = condition.function;
      if (condition.input != input || (f.gaussian && !gaussians.emplace(f.mean, f.sigma).second)) continue;
      const auto [low, high] = fuzzy::supportOf(f);
      for (const double end : {low, high}) {
        if (end > variable.min && end < variable.max) ends.push_back(end);
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<Cell> cells;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (k > 0) {
      const Cell between{ends[k - 1], ends[k], false};
      // Between neighboring doubles there is no point.
      if (between.representative() > between.low && between.representative() < between.high) cells.push_back(between);
    }
    cells.push_back({ends[k], ends[k], true});
  }
  return cells;
}

class Search {
 public:
  Search(const ForceModel& model, std::vector<LiveRule> rules, std::size_t allowance)
      : rules_(std::move(rules)), allowance_(allowance) {
    // The input that most rules mention first: where it alone kills every rule, the whole slab is one hole.
    order_.resize(model.inputs.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::vector<std::size_t> mentions(order_.size());
    for (const auto& rule : rules_) {
      for (const auto& condition : rule) ++mentions[condition.input];
    }
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t x, std::size_t y) { return mentions[x] > mentions[y]; });
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      const auto& input = model.inputs[i];
      cells_.push_back(cellsOf(input, i, rules_));
      box_.ranges.push_back({input.id, input.min, input.max, true, true, true});
    }
  }

  Coverage run() {
    std::vector<std::size_t> all(rules_.size());
    std::iota(all.begin(), all.end(), 0);
    descend(0, all);
    return std::move(result_);
  }

 private:
  const LiveCondition* conditionOn(std::size_t rule, std::size_t input) const {
    for (const auto& condition : rules_[rule]) {
      if (condition.input == input) return &condition;
    }
    return nullptr;
  }

  /// A rule without a condition on the inputs from `depth` on fires whatever they are.
  bool coversTheRest(std::size_t rule, std::size_t depth) const {
    return std::none_of(order_.begin() + static_cast<std::ptrdiff_t>(depth), order_.end(),
                        [&](std::size_t input) { return conditionOn(rule, input) != nullptr; });
  }

  std::vector<std::size_t> survivors(const std::vector<std::size_t>& live, std::size_t input, double x) const {
    std::vector<std::size_t> out;
    for (const std::size_t rule : live) {
      const LiveCondition* const condition = conditionOn(rule, input);
      if (condition == nullptr || condition->function(x) > 0) out.push_back(rule);
    }
    return out;
  }

  void descend(std::size_t depth, const std::vector<std::size_t>& live) {
    if (!result_.complete) return;
    if (live.empty()) {
      result_.holes.push_back(box_);
      return;
    }
    if (std::any_of(live.begin(), live.end(), [&](std::size_t rule) { return coversTheRest(rule, depth); })) return;
    TACTUS_CHECK(depth < order_.size());

    const std::size_t input = order_[depth];
    const auto& cells = cells_[input];
    const std::size_t work = live.size() * cells.size();
    if (work > allowance_) {
      result_.complete = false;
      return;
    }
    allowance_ -= work;
    const InputRange whole = box_.ranges[input];
    for (std::size_t first = 0; first < cells.size();) {
      const auto alive = survivors(live, input, cells[first].representative());
      std::size_t last = first;
      while (last + 1 < cells.size() && survivors(live, input, cells[last + 1].representative()) == alive) ++last;
      box_.ranges[input] = {whole.input,        cells[first].low,  cells[last].high,
                            cells[first].point, cells[last].point, first == 0 && last + 1 == cells.size()};
      descend(depth + 1, alive);
      first = last + 1;
    }
    box_.ranges[input] = whole;
  }

  std::vector<LiveRule> rules_;
  std::size_t allowance_;
  std::vector<std::size_t> order_;
  std::vector<std::vector<Cell>> cells_;
  Hole box_;
  Coverage result_;
};

}  // namespace

Coverage coverage(const ForceModel& model, std::span<const std::size_t> experts, std::size_t allowance) {
  return Search(model, liveRules(model, experts), allowance).run();
}

namespace {

/// `id`, in quotes where it begins as the range of another input would, `depth 3 to` beside `depth`: only then could
/// two holes have one name. A quote inside is doubled.
std::string unmistakable(const std::string& id, const ForceModel& model) {
  const auto reads_like = [&id](const fuzzy::Variable& other) {
    const std::size_t start = other.id.size() + 1;
    return id.size() > start && id.starts_with(other.id + ' ') &&
           std::string_view("-0123456789").find(id[start]) != std::string_view::npos;
  };
  if (id.front() != '"' && std::none_of(model.inputs.begin(), model.inputs.end(), reads_like)) return id;
  std::string quoted = "\"";
  for (const char c : id) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// `value` with so many digits that count.
double rounded(double value, int digits) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, digits).ptr;
  return base::parseNumber(std::string_view(text.data(), end)).value_or(value);
}

/// Ends of an input's terms, of all experts. Those of Gaussians have seventeen digits, which a person cannot read.
struct TermEnds {
  std::set<double> all;
  std::set<double> of_gaussians;
};

TermEnds termEnds(const fuzzy::Variable& input, const ForceModel& model) {
  TermEnds ends;
  ends.all = {input.min, input.max};
  const auto add = [&ends](const std::vector<fuzzy::Term>& terms) {
    for (const auto& term : terms) {
      const auto f = MembershipFunction::of(term);
      const auto [low, high] = fuzzy::supportOf(f);
      for (const double end : {low, high}) {
        ends.all.insert(end);
        if (f.gaussian) ends.of_gaussians.insert(end);
      }
    }
  };
  add(input.terms);
  for (const auto& expert : model.experts) {
    for (const auto& own : expert.overrides) {
      if (own.variable == input.id) add(own.terms);
    }
  }
  return ends;
}

/// The end of a hole as text. That of a Gaussian has six digits, or as many as tell it from all other ends.
std::string endAsText(double value, const TermEnds& ends) {
  if (!ends.of_gaussians.contains(value)) return base::formatNumber(value);
  for (int digits = 6; digits < std::numeric_limits<double>::max_digits10; ++digits) {
    const double shown = rounded(value, digits);
    const bool unique = std::none_of(ends.all.begin(), ends.all.end(), [&](double other) {
      return other != value && (other == shown || rounded(other, digits) == shown);
    });
    if (unique) return base::formatNumber(shown);
  }
  return base::formatNumber(value);
}

}  // namespace

std::string describe(const Hole& hole, const ForceModel& model) {
  return describe(hole, model, [&model](const fuzzy::Variable& input) { return unmistakable(input.id, model); });
}

std::string describe(const Hole& hole, const ForceModel& model,
                     const std::function<std::string(const fuzzy::Variable&)>& name_of) {
  std::string text;
  for (std::size_t i = 0; i < hole.ranges.size(); ++i) {
    const auto& range = hole.ranges[i];
    if (range.whole_universe) continue;
    if (!text.empty()) text += ", ";
    const auto ends = termEnds(model.inputs[i], model);
    text += name_of(model.inputs[i]) + ' ' + endAsText(range.low, ends);
    if (range.high != range.low) text += " to " + endAsText(range.high, ends);
    if (model.inputs[i].unit != "1") text += ' ' + model.inputs[i].unit;
  }
  return text.empty() ? "everywhere" : text;
}

}  // namespace tactus::analysis
