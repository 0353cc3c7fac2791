#include "core/contracts/contract_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/contracts/force_cells.h"
#include "core/contracts/prover.h"
#include "core/contracts/worst_case.h"

namespace tactus::contracts {
namespace {

using fuzzy::Contract;
using Kind = fuzzy::Contract::Kind;

/// `name` as an index among the inputs.
std::optional<std::size_t> inputOf(const fuzzy::ForceModel& model, const std::string& id) {
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (model.inputs[i].id == id) return i;
  }
  return std::nullopt;
}

/// One contract under check.
class Check {
 public:
  Check(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, const Contract& contract,
        const Effort& effort, const std::stop_token& stop)
      : model_(model),
        compiled_(compiled),
        contract_(contract),
        effort_(effort),
        stop_(stop),
        range_n_(model.output.max - model.output.min),
        proof_n_(kProofShare * range_n_) {}

  ContractResult run() {
    if (!findRanges()) return result_;
    switch (contract_.kind) {
      case Kind::kNeverRaises: slope(1); break;
      case Kind::kNeverLowers: slope(-1); break;
      case Kind::kNeverHarder: harder(); break;
      case Kind::kNoStep: step(); break;
      case Kind::kNeverAbove: limit(1); break;
      case Kind::kNeverBelow: limit(-1); break;
      case Kind::kNeverSilent: silent(); break;
    }
    return result_;
  }

 private:
  bool open(std::string reason) {
    result_.verdict = Verdict::kOpen;
    result_.reason = std::move(reason);
    return false;
  }

  std::optional<Interval> wordRange(std::size_t input, const std::string& word) {
    const auto range = rangeOfWord(model_.inputs[input], word);
    if (range) return Interval(range->low, range->high);
    open("The model has no word " + base::quoted(word) + " of " + base::quoted(model_.inputs[input].id) +
         " within its universe.");
    return std::nullopt;
  }

  bool findRanges() {
    for (const auto& input : model_.inputs) ranges_.emplace_back(input.min, input.max);
    for (const fuzzy::Condition& one : contract_.where) {
      const auto input = inputOf(model_, one.input);
      if (!input) return open("The model has no input " + base::quoted(one.input) + ".");
      const auto range = wordRange(*input, one.term);
      if (!range) return false;
      ranges_[*input] = *range;
    }
    if (!fuzzy::membersOf(contract_.kind).input) return true;
    const auto input = inputOf(model_, contract_.input);
    if (!input) return open("The model has no input " + base::quoted(contract_.input) + ".");
    input_ = *input;
    return true;
  }

  /// The allowed error of two evaluated forces: what is reported is certain.
  double certain(double a, double b) const {
    return 4e-12 * range_n_ + 8 * std::numeric_limits<double>::epsilon() * (std::abs(a) + std::abs(b));
  }

  double force(std::span<const double> inputs) const { return compiled_.evaluate(inputs).force_n; }

  /// The two points of a case: the inputs, and then the other value of the one that differs.
  std::pair<std::vector<double>, std::vector<double>> pointsOf(std::span<const double> place) const {
    std::vector<double> first(place.begin(), place.begin() + static_cast<std::ptrdiff_t>(model_.inputs.size()));
    std::vector<double> second = first;
    if (place.size() > first.size()) second[input_] = place.back();
    return {std::move(first), std::move(second)};
  }

  /// Takes a case as the counterexample if it certainly is one. `value`: the excess of a place.
  bool take(const std::vector<double>& place, double excess) {
    const auto [first, second] = pointsOf(place);
    const auto a = compiled_.evaluate(first);
    const auto b = compiled_.evaluate(second);
    if (!(excess > certain(a.force_n, b.force_n))) return false;
    result_.verdict = Verdict::kViolated;
    result_.excess_n = excess;
    result_.counterexample = {{first, a}};
    if (place.size() > first.size()) result_.counterexample.push_back({second, b});
    return true;
  }

  /// Searches a violation, then proves that there is none.
  void decide(ProofTask task, const WorstCase::Value& value, const std::vector<Interval>& place_ranges, bool ordered,
              double rate_to_n) {
    std::vector<WorstCase::Side> sides;
    for (std::size_t v = 0; v < place_ranges.size(); ++v) {
      const std::size_t input = v < model_.inputs.size() ? v : input_;
      sides.push_back({place_ranges[v].low, place_ranges[v].high, worthALook(input, place_ranges[v])});
    }
    WorstCase worst(std::move(sides), value);
    worst.search(ordered ? std::optional(input_) : std::nullopt);
    if (take(worst.place(), worst.value())) return;
    task.look = [&](const Box& box) {
      std::vector<double> place;
      for (std::size_t v = 0; v < task.ranges.size(); ++v) place.push_back(box[v].middle());
      if (place.size() < place_ranges.size()) {
        // The two ends of the part, of which the middle is the place.
        place[input_] = box[input_].low;
        place.push_back(box[input_].high);
      }
      worst.climb(place);
      return take(worst.place(), worst.value());
    };
    const Proof proof = prove(task, effort_.parts, stop_);
    result_.parts = proof.parts;
    if (proof.found) return;
    if (proof.proved) {
      result_.verdict = Verdict::kProved;
      result_.bound_n = proof_n_;
      return;
    }
    if (proof.too_many) {
      open("The experts' terms differ so much that the boxes between their vertices cannot be bounded.");
    } else if (proof.jumps) {
      open("The force may jump along this input, and the jumps were searched but not bounded.");
    } else if (stop_.stop_requested()) {
      open("The check was stopped.");
    } else if (!proof.bounded) {
      open("In some part of the input space the force cannot be bounded.");
    } else {
      open("The bound did not reach the limit within the effort allowed.");
      if (proof.complete) result_.bound_n = std::min(range_n_, proof.largest * rate_to_n + proof_n_);
    }
  }

  std::vector<double> worthALook(std::size_t input, const Interval& range) const {
    std::vector<double> out;
    for (const auto& expert : model_.experts) {
      for (const fuzzy::Term& term : termsFor(expert, model_.inputs[input])) {
        const std::size_t count = term.shape == fuzzy::Shape::kGaussian ? 1 : term.points.size();
        for (std::size_t p = 0; p < count; ++p) {
          if (term.points[p] > range.low && term.points[p] < range.high) out.push_back(term.points[p]);
        }
      }
    }
    out.push_back(range.low);
    out.push_back(range.high);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  std::vector<Copy> oneCopy() const { return {{&model_, 1, plainVariables(model_.inputs.size())}}; }

  void slope(double sign) {
    ProofTask task;
    task.copies = oneCopy();
    task.ranges = ranges_;
    task.split = Split::kOrders;
    task.along = input_;
    const double length = ranges_[input_].width();
    const double most = proof_n_ / std::max(length, std::numeric_limits<double>::min());
    task.excess = [this, sign, most](const PartBounds& bounds) {
      const Interval& s = bounds.slope[input_];
      const double rise = sign > 0 ? s.high : -s.low;
      return rise - most;
    };
    std::vector<Interval> place = ranges_;
    place.push_back(ranges_[input_]);
    const auto value = [this, sign](std::span<const double> z) {
      const auto [first, second] = pointsOf(z);
      if (!(second[input_] >= first[input_])) return -std::numeric_limits<double>::infinity();
      return sign * (force(second) - force(first));
    };
    decide(std::move(task), value, place, true, length);
  }

  void harder() {
    const auto soft = wordRange(input_, contract_.word);
    if (!soft) return;
    const auto hard = wordRange(input_, contract_.than);
    if (!hard) return;
    ProofTask task;
    const std::size_t count = model_.inputs.size();
    auto other = plainVariables(count);
    other[input_] = count;
    task.copies = {{&model_, 1, plainVariables(count)}, {&model_, -1, std::move(other)}};
    task.ranges = ranges_;
    task.ranges[input_] = *soft;
    task.ranges.push_back(*hard);
    task.excess = [this](const PartBounds& bounds) { return bounds.value.high - proof_n_; };
    const auto value = [this](std::span<const double> z) {
      const auto [first, second] = pointsOf(z);
      return force(first) - force(second);
    };
    const auto ranges = task.ranges;
    decide(std::move(task), value, ranges, false, 1);
  }

  void limit(double sign) {
    ProofTask task;
    task.copies = oneCopy();
    task.ranges = ranges_;
    task.excess = [this, sign](const PartBounds& bounds) {
      return (sign > 0 ? bounds.value.high - contract_.limit : contract_.limit - bounds.value.low) - proof_n_;
    };
    const auto value = [this, sign](std::span<const double> z) { return sign * (force(z) - contract_.limit); };
    decide(std::move(task), value, ranges_, false, 1);
  }

  double allowed(double force_n) const {
    return contract_.limit_in_jnd ? contract_.limit * justNoticeableDifference(force_n) : contract_.limit;
  }

  void step() {
    ProofTask task;
    task.copies = oneCopy();
    task.ranges = ranges_;
    task.along = input_;
    task.excess = [this](const PartBounds& bounds) {
      const Interval& s = bounds.slope[input_];
      const double steepest = std::max(std::abs(s.low), std::abs(s.high));
      // Before a change exceeds what is allowed around its smaller force, the force is within that of it.
      const double least = bounds.value.low > 0 ? bounds.value.low : bounds.value.high < 0 ? -bounds.value.high : 0;
      const double smaller = std::max(0.0, least - allowed(least));
      return up(steepest * contract_.within) - down(allowed(smaller)) * (1 - 1e-12) - proof_n_;
    };
    std::vector<Interval> place = ranges_;
    place.push_back(ranges_[input_]);
    const auto value = [this](std::span<const double> z) {
      const auto [first, second] = pointsOf(z);
      if (!(std::abs(second[input_] - first[input_]) <= contract_.within))
        return -std::numeric_limits<double>::infinity();
      const double a = force(first);
      const double b = force(second);
      return std::abs(a - b) - allowed(std::min(std::abs(a), std::abs(b)));
    };
    decide(std::move(task), value, place, true, 1);
  }

  void silent() {
    const ForceSum sum(oneCopy(), ranges_);
    const auto cell = sum.silentCell();
    if (!cell) {
      result_.verdict = Verdict::kProved;
      result_.bound_n = 0;
      return;
    }
    std::vector<double> place;
    for (const Stretch& one : *cell) place.push_back(Interval(one.low, one.high).middle());
    result_.verdict = Verdict::kViolated;
    result_.counterexample = {{place, compiled_.evaluate(place)}};
  }

  const fuzzy::ForceModel& model_;
  const fuzzy::CompiledModel& compiled_;
  const Contract& contract_;
  const Effort& effort_;
  const std::stop_token& stop_;
  double range_n_;
  double proof_n_;
  std::vector<Interval> ranges_;
  std::size_t input_ = 0;
  ContractResult result_;
};

}  // namespace

double justNoticeableDifference(double force_n) { return std::hypot(0.04, 0.12 * force_n); }

std::string_view name(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::kProved: return "proved";
    case Verdict::kViolated: return "violated";
    case Verdict::kOpen: return "open";
  }
  return "";
}

std::optional<WordRange> rangeOfWord(const fuzzy::Variable& input, std::string_view word) {
  const fuzzy::Term* const term = fuzzy::findTerm(input.terms, word);
  if (term == nullptr) return std::nullopt;
  const auto f = fuzzy::MembershipFunction::of(*term);
  const double reach = f.sigma * std::sqrt(2 * std::numbers::ln2);
  const double low = f.gaussian ? f.mean - reach : f.a + (f.b - f.a) / 2;
  const double high = f.gaussian ? f.mean + reach : f.d - (f.d - f.c) / 2;
  WordRange range{std::max(low, input.min), std::min(high, input.max)};
  return range.low <= range.high ? std::optional(range) : std::nullopt;
}

ContractResult checkContract(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                             const Contract& contract, const Effort& effort, const std::stop_token& stop) {
  return Check(model, compiled, contract, effort, stop).run();
}

}  // namespace tactus::contracts
