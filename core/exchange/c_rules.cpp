// Memberships and strengths in C.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/exchange/c_parts.h"
#include "core/fuzzy/membership.h"

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

namespace {

// Inside these sizes no membership above 0 can round to 0 (fired would differ), once inputs keep off 0 by kTouch.
constexpr double kSmall = 1e-6;
constexpr double kLarge = 1e6;
constexpr double kLeastWeight = 1e-10;
// Times the least weight, far above the strengths whose squares vanish.
constexpr double kLeastFixed = 1e-50;

bool isPlain(double value) { return value == 0 || (std::abs(value) >= kSmall && std::abs(value) <= kLarge); }

bool isPlain(const fuzzy::Term& term) {
  const auto& p = term.points;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!isPlain(p[i]) || (i > 0 && term.shape != fuzzy::Shape::kGaussian && !isPlain(p[i] - p[i - 1]))) return false;
  }
  return true;
}

bool isPlain(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  return isPlain(variable.min) && isPlain(variable.max) &&
         std::all_of(terms.begin(), terms.end(), [](const fuzzy::Term& term) { return isPlain(term); });
}

bool isOddModel(const fuzzy::ForceModel& model) {
  for (const fuzzy::Expert& expert : model.experts) {
    for (const fuzzy::Variable& input : model.inputs) {
      if (!isPlain(input, fuzzy::termsFor(expert, input))) return true;
    }
    for (const fuzzy::Rule& rule : expert.rules) {
      if (rule.weight > 0 && rule.weight < kLeastWeight) return true;
    }
  }
  return false;
}

std::string subtree(const std::vector<std::string>& parts, const std::string& function, std::size_t first,
                    std::size_t count) {
  if (count == 1) return parts[first];
  const std::size_t half = count / 2;
  return function + "(" + subtree(parts, function, first, half) + ", " +
         subtree(parts, function, first + half, count - half) + ")";
}

std::string membership(std::size_t index) { return "m[" + std::to_string(index) + "]"; }

/// The strongest of `premises`; "" stands for 1. min(a, max(b, c)) = max(min(a, b), min(a, c)) holds for every bit, so
/// the membership that most premises share is taken out, again and again.
std::string strongest(std::vector<Premise> premises) {
  std::vector<std::string> alternatives;
  while (!premises.empty()) {
    std::map<std::size_t, std::size_t> uses;
    for (const Premise& premise : premises) {
      if (premise.empty()) return {};
      for (const std::size_t index : premise) ++uses[index];
    }
    const std::size_t shared = std::max_element(uses.begin(), uses.end(), [](const auto& a, const auto& b) {
                                 return a.second < b.second;
                               })->first;
    std::vector<Premise> with;
    std::vector<Premise> without;
    for (Premise& premise : premises) {
      const auto at = std::find(premise.begin(), premise.end(), shared);
      if (at == premise.end()) {
        without.push_back(std::move(premise));
        continue;
      }
      premise.erase(at);
      with.push_back(std::move(premise));
    }
    const std::string rest = strongest(std::move(with));
    alternatives.push_back(rest.empty() ? membership(shared) : "lower(" + membership(shared) + ", " + rest + ")");
    premises = std::move(without);
  }
  return tree(alternatives, "larger");
}

}  // namespace

std::string tree(const std::vector<std::string>& parts, const std::string& function) {
  return subtree(parts, function, 0, parts.size());
}

std::string comment(std::string_view text) {
  std::string out = base::oneLine(text);
  for (std::size_t at = out.find("*/"); at != std::string::npos; at = out.find("*/")) out.replace(at, 2, "* /");
  for (std::size_t at = out.find("/*"); at != std::string::npos; at = out.find("/*")) out.replace(at, 2, "/ *");
  return out;
}

std::string number(double value) {
  std::string text = base::formatNumber(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return value < 0 ? "(" + text + ")" : text;
}

MembershipCode::MembershipCode(const fuzzy::ForceModel& model, FixedInputs fixed)
    : model_(model), fixed_(std::move(fixed)), odd_(isOddModel(model)) {}

std::optional<double> MembershipCode::fixedAt(std::size_t input, const fuzzy::Term& term) const {
  if (!fixed_[input]) return std::nullopt;
  const fuzzy::Variable& variable = model_.inputs[input];
  const double x = std::clamp(*fixed_[input], variable.min, variable.max);
  const auto function = fuzzy::MembershipFunction::of(term);
  const auto ramps = odd_ ? std::nullopt : fuzzy::rampsOf(function, variable.min, variable.max);
  if (!ramps) return function(x);
  double out = 1;
  if (ramps->has_rise) out = std::min(out, (x - ramps->a) * ramps->rise);
  if (ramps->has_fall) out = std::min(out, (ramps->d - x) * ramps->fall);
  return std::max(0.0, out);
}

std::size_t MembershipCode::index(std::size_t input, const fuzzy::Term& term) {
  const auto same = [&](const auto& known) {
    return known.first == input && known.second.shape == term.shape && known.second.points == term.points;
  };
  const auto found = std::find_if(terms_.begin(), terms_.end(), same);
  if (found != terms_.end()) return static_cast<std::size_t>(found - terms_.begin());
  terms_.emplace_back(input, term);
  return terms_.size() - 1;
}

bool MembershipCode::hasRampToZero(std::size_t input) const {
  return !fixed_[input] && std::any_of(terms_.begin(), terms_.end(), [input](const auto& one) {
    if (one.first != input || one.second.shape == fuzzy::Shape::kGaussian) return false;
    const Corners f = cornersOf(one.second);
    return (f.a == 0 && f.b > 0) || (f.d == 0 && f.c < 0);
  });
}

bool MembershipCode::canBeTiny() const {
  if (odd_) return true;
  for (std::size_t i = 0; i < fixed_.size(); ++i) {
    if (hasRampToZero(i)) return true;
  }
  return std::any_of(terms_.begin(), terms_.end(), [this](const auto& one) {
    const auto fixed = fixedAt(one.first, one.second);
    return fixed ? *fixed > 0 && *fixed < kLeastFixed : one.second.shape == fuzzy::Shape::kGaussian;
  });
}

bool MembershipCode::usesExp() const {
  return std::any_of(terms_.begin(), terms_.end(), [this](const auto& one) {
    return one.second.shape == fuzzy::Shape::kGaussian && !fixed_[one.first];
  });
}

std::string MembershipCode::expression(std::size_t input, const fuzzy::Term& term, bool below_zero) const {
  if (const auto fixed = fixedAt(input, term)) return number(*fixed);
  const std::string x = "x" + std::to_string(input);
  if (term.shape == fuzzy::Shape::kGaussian) {
    const std::string u = "((" + x + " - " + number(term.points[0]) + ") / " + number(term.points[1]) + ")";
    return "exp(-0.5 * " + u + " * " + u + ")";
  }
  const fuzzy::Variable& variable = model_.inputs[input];
  const Corners f = cornersOf(term);
  // Never: the clamped input cannot be there.
  const bool no_left = f.b <= variable.min;
  const bool no_right = f.c >= variable.max;
  const auto ramps = fuzzy::rampsOf(fuzzy::MembershipFunction::of(term), variable.min, variable.max);
  const auto ramp = [&](const std::string& way, double width, double slope) {
    return odd_ ? "kept(" + way + ", " + number(width) + ")" : "(" + way + ") * " + number(ramps ? slope : 1 / width);
  };
  std::vector<std::string> sides;
  if (!no_left) {
    sides.push_back(f.a == f.b ? "(" + x + " >= " + number(f.b) + " ? 1.0 : 0.0)"
                               : ramp(x + " - " + number(f.a), f.b - f.a, ramps ? ramps->rise : 0));
  }
  if (!no_right) {
    sides.push_back(f.c == f.d ? "(" + x + " <= " + number(f.c) + " ? 1.0 : 0.0)"
                               : ramp(number(f.d) + " - " + x, f.d - f.c, ramps ? ramps->fall : 0));
  }
  if (sides.empty()) return "1.0";
  sides.emplace_back("1.0");
  return below_zero ? tree(sides, "lower") : "larger(0.0, " + tree(sides, "lower") + ")";
}

std::string MembershipCode::expressionBelowZero(std::size_t index) const {
  return expression(terms_[index].first, terms_[index].second, true);
}

/// The values x0, x1, … of the inputs that are not fixed, within their universes, and `nothing`.
std::string MembershipCode::valuesText() const {
  std::string out = "  int nothing = 0;\n";
  std::vector<std::string> place(model_.inputs.size());  // of each free input in `inputs`
  std::size_t free = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (!fixed_[i]) place[i] = "inputs[" + std::to_string(free++) + "]";
  }
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (fixed_[i]) continue;
    const fuzzy::Variable& input = model_.inputs[i];
    out += "  double x" + std::to_string(i) + " = lower(larger(" + place[i] + ", " + number(input.min) + "), " +
           number(input.max) + ");  /* " + comment(input.id) + " */\n";
  }
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (!fixed_[i]) out += "  nothing |= (int)is_not_finite(" + place[i] + ");\n";
  }
  for (std::size_t i = 0; i < place.size() && !odd_; ++i) {
    if (!hasRampToZero(i)) continue;
    const std::string x = "x" + std::to_string(i);
    out += "  " + x + " = off_zero(" + x + ");\n";
  }
  // What no rule asks for.
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (!fixed_[i]) out += "  (void)x" + std::to_string(i) + ";\n";
  }
  return out;
}

std::string MembershipCode::function() const {
  std::string out = "PART int memberships(const double *inputs, double *m) {\n" + valuesText();
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    out += "  " + membership(t) + " = " + expression(terms_[t].first, terms_[t].second) + ";\n";
  }
  if (terms_.empty()) out += "  (void)m;\n";
  return out + "  return nothing;\n}\n";
}

std::string MembershipCode::functionBut(std::size_t input) const {
  std::string out =
      "PART int other_memberships(const double *inputs, double *m, double *at) {\n" + valuesText() + "  (void)m;\n";
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    if (terms_[t].first != input) out += "  " + membership(t) + " = " + expressionBelowZero(t) + ";\n";
  }
  return out + "  *at = x" + std::to_string(input) + ";\n  return nothing;\n}\n";
}

std::vector<Strength> strengthsOf(const ExpertView& view, MembershipCode& memberships) {
  // By output term, then by weight: w min(a, b) = min(w a, w b) and w max(a, b) = max(w a, w b) hold for every bit.
  std::map<std::size_t, TermRules> rules;
  for (const IndexedRule& rule : view.rules) {
    if (rule.weight == 0) continue;
    Premise premise;
    bool can_fire = true;
    for (const auto& [input, term] : rule.conditions) {
      const fuzzy::Term& condition = *view.inputs[input].terms[term].term;
      const auto fixed = memberships.fixedAt(input, condition);
      can_fire = can_fire && fixed != 0.0;
      if (fixed != 1.0 && fixed != 0.0) premise.push_back(memberships.index(input, condition));
    }
    std::sort(premise.begin(), premise.end());
    if (can_fire) rules[rule.then][rule.weight].push_back(std::move(premise));
  }
  std::vector<Strength> out;
  for (auto& [term, by_weight] : rules) {
    std::vector<std::string> alternatives;
    for (const auto& [weight, premises] : by_weight) {
      const std::string inner = strongest(premises);
      const std::string held = inner.empty() ? "1.0" : inner;
      const std::string scaled =
          memberships.isOdd() ? "kept_product(" + number(weight) + ", " + held + ")" : number(weight) + " * " + held;
      alternatives.push_back(weight == 1 ? held : scaled);
    }
    out.push_back({term, std::move(by_weight), tree(alternatives, "larger")});
  }
  return out;
}

}  // namespace tactus::exchange
