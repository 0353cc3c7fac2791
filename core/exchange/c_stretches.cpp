// The strengths at one point in C. One input is taken for the pivot: between the ends of its terms few of them apply,
// so each stretch of it has code of its own, with the rules that can fire there.
#include <algorithm>
#include <set>

#include "core/base/text.h"
#include "core/exchange/c_writer.h"

namespace tactus::exchange {
namespace {

constexpr std::size_t kMostStretches = 24;     // of code: more would leave the processor's cache
constexpr std::size_t kFewestMemberships = 3;  // of an input, so that stretches differ

/// What is left of `rules` in a stretch.
TermRules within(const TermRules& rules, const Stretch& stretch, std::span<const std::size_t> pivots) {
  const auto contains = [](std::span<const std::size_t> all, std::size_t one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  };
  TermRules out;
  for (const auto& [weight, premises] : rules) {
    for (const Premise& premise : premises) {
      Premise rest;
      bool can_fire = true;
      for (const std::size_t index : premise) {
        if (!contains(pivots, index) || contains(stretch.in_part, index)) {
          rest.push_back(index);
        } else {
          can_fire = can_fire && contains(stretch.whole, index);
        }
      }
      if (can_fire) out[weight].push_back(std::move(rest));
    }
  }
  return out;
}

}  // namespace

std::vector<Stretch> stretchesOf(const fuzzy::Variable& input, std::size_t index, const MembershipCode& memberships) {
  std::set<double> ends{input.min, input.max};
  for (std::size_t i = 0; i < memberships.count(); ++i) {
    const auto& [of, term] = memberships[i];
    if (of != index || term.shape == fuzzy::Shape::kGaussian) continue;
    const Corners f = cornersOf(term);
    for (const double end : {f.a, f.d}) {
      if (end > input.min && end < input.max) ends.insert(end);
    }
  }
  if (ends.size() > kMostStretches + 1) return {};
  std::vector<Stretch> out;
  for (auto after = ends.begin(), until = std::next(after); until != ends.end(); ++after, ++until) {
    Stretch stretch{*after, *until, {}, {}};
    const bool is_first = after == ends.begin();
    for (std::size_t i = 0; i < memberships.count(); ++i) {
      const auto& [of, term] = memberships[i];
      if (of != index) continue;
      if (term.shape == fuzzy::Shape::kGaussian) {
        stretch.in_part.push_back(i);
        continue;
      }
      const Corners f = cornersOf(term);
      // The first stretch has its lower end too; a vertical edge belongs to its term.
      const bool ends_before = is_first ? f.d < *after : f.d <= *after;
      const bool begins_after = f.a == f.b ? f.a > *until : f.a >= *until;
      if (ends_before || begins_after) continue;
      (f.b <= *after && f.c >= *until ? stretch.whole : stretch.in_part).push_back(i);
    }
    out.push_back(std::move(stretch));
  }
  return out;
}

std::vector<std::size_t> SourceWriter::membershipsOf(std::size_t input) const {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < memberships_.count(); ++i) {
    if (memberships_[i].first == input) out.push_back(i);
  }
  return out;
}

std::size_t SourceWriter::inputOfMostMemberships() const {
  std::size_t most = 0;
  for (std::size_t input = 1; input < model_.inputs.size(); ++input) {
    if (membershipsOf(input).size() > membershipsOf(most).size()) most = input;
  }
  return most;
}

/// The input whose stretches `force_model` has code for.
std::optional<std::size_t> SourceWriter::pivotFor(const std::vector<std::size_t>& experts) const {
  if (experts.empty() || !areOneGroup(experts) || isLarge() || memberships_.isOdd()) return std::nullopt;
  const std::size_t input = inputOfMostMemberships();
  if (membershipsOf(input).size() < kFewestMemberships) return std::nullopt;
  if (stretchesOf(model_.inputs[input], input, memberships_).size() < 2) return std::nullopt;
  return input;
}

/// The function `strengths_here(x, m, s)`: the strength of the term live[k] of expert e is `s[k * experts + e]`. It
/// sets the memberships of the pivot that it needs.
std::string SourceWriter::stretchesText(const std::vector<std::size_t>& experts, std::size_t pivot) const {
  const CentroidGroup& group = groups_[ordered_[experts.front()]->group];
  const std::vector<std::size_t> pivots = membershipsOf(pivot);
  const auto stretches = stretchesOf(model_.inputs[pivot], pivot, memberships_);
  const std::string x = "x" + std::to_string(pivot);
  std::string place;
  for (std::size_t i = 0; i + 1 < stretches.size(); ++i)
    place += (place.empty() ? "(" : " + (") + x + " > " + number(stretches[i].until) + ")";
  std::string out = "/* Below 0 stands for 0. */\nPART void strengths_here(double " + x +
                    ", double *m, double *s) {\n  switch (" + place + ") {\n";
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& stretch = stretches[i];
    const bool is_last = i + 1 == stretches.size();
    out += (is_last ? "    default" : "    case " + std::to_string(i)) + ": {  /* " + comment(model_.inputs[pivot].id) +
           " to " + base::formatNumber(stretch.until) + " */\n";
    for (const std::size_t index : stretch.in_part)
      out += "      m[" + std::to_string(index) + "] = " + memberships_.expressionBelowZero(index) + ";\n";
    std::vector<TermRules> rules;
    for (const std::size_t term : group.live) {
      for (const std::size_t e : experts) {
        const auto& strengths = ordered_[e]->strengths;
        const auto own = std::find_if(strengths.begin(), strengths.end(),
                                      [term](const Strength& strength) { return strength.term == term; });
        rules.push_back(own != strengths.end() ? within(own->rules, stretch, pivots) : TermRules());
      }
    }
    const SharedStrengths shared = sharedStrengths(rules, pivots);
    for (std::size_t from = 0; from < shared.statements.size();) {
      const std::size_t end = shared.statements.find('\n', from) + 1;
      out += "      " + shared.statements.substr(from, end - from);
      from = end;
    }
    for (std::size_t k = 0; k < shared.values.size(); ++k)
      out += "      s[" + std::to_string(k) + "] = " + shared.values[k] + ";\n";
    out += "      break;\n    }\n";
  }
  return out + "  }\n  (void)m;\n}\n\n";
}

}  // namespace tactus::exchange
