// Splits each input at the ends of the supports into points and open intervals; within such a cell the set of live
// rules is constant. Cells with the same live rules are merged before the next input is looked at, which keeps the
// search small.
#include "core/analysis/coverage.h"

#include <algorithm>
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

/// The last number on the way from the mean of a Gaussian, where it is 1, to `outside`, where it is 0, that has a
/// membership above 0.
double lastAbove0(const MembershipFunction& gaussian, double outside) {
  double inside = gaussian.mean;
  while (true) {
    const double middle = inside + (outside - inside) / 2;
    if (middle == inside || middle == outside) return inside;
    (gaussian(middle) > 0 ? inside : outside) = middle;
  }
}

/// Where the membership is above 0: of a trapezoid its feet, of a Gaussian where the exponential underflows, about
/// 38.6 sigma from the mean, to the last digit. There the Gaussian ends like a vertical edge.
std::pair<double, double> supportOf(const MembershipFunction& f) {
  if (!f.gaussian) return {f.a, f.d};
  constexpr double kFar = 80;  // sigma, with one digit more where sigma is below the distance of neighbouring numbers
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {lastAbove0(f, std::nextafter(f.mean - kFar * f.sigma, -kInfinity)),
          lastAbove0(f, std::nextafter(f.mean + kFar * f.sigma, kInfinity))};
}

std::vector<Cell> cellsOf(const fuzzy::Variable& variable, std::size_t input, const std::vector<LiveRule>& rules) {
  std::vector<double> ends = {variable.min, variable.max};
  std::set<std::pair<double, double>> gaussians;  // mean and sigma of those that are cut already
  for (const auto& rule : rules) {
    for (const auto& condition : rule) {
      const auto& f = condition.function;
      if (condition.input != input || (f.gaussian && !gaussians.emplace(f.mean, f.sigma).second)) continue;
      const auto [low, high] = supportOf(f);
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
      // Between neighbouring doubles there is no point.
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
    text += name_of(model.inputs[i]) + ' ' + base::formatNumber(range.low);
    if (range.high != range.low) text += " to " + base::formatNumber(range.high);
    if (model.inputs[i].unit != "1") text += ' ' + model.inputs[i].unit;
  }
  return text.empty() ? "everywhere" : text;
}

}  // namespace tactus::analysis
