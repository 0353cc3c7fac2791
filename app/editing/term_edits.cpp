#include "app/editing/term_edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editing/edit.h"
#include "core/analysis/term_conversion.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::editing {
namespace {

using base::ErrorCode;
using base::fail;
using fuzzy::MembershipFunction;
using fuzzy::Shape;
using fuzzy::Term;

bool anyGaussian(const std::vector<Term>& terms) {
  return std::any_of(terms.begin(), terms.end(), [](const Term& term) { return term.shape == Shape::kGaussian; });
}

/// A ramp shared by two neighbors.
struct Ramp {
  double from;
  double to;
};

/// Ramps one after the other, none narrower than `narrowest`.
void putInOrder(std::vector<Ramp>& ramps, double narrowest) {
  std::vector<double> knots;
  for (const Ramp& ramp : ramps) knots.insert(knots.end(), {ramp.from, ramp.to});
  std::sort(knots.begin(), knots.end());
  for (std::size_t r = 0; r < ramps.size(); ++r) {
    const double from = r == 0 ? knots[0] : std::max(knots[2 * r], ramps[r - 1].to);
    ramps[r] = {from, std::max(knots[2 * r + 1], from + narrowest)};
  }
}

}  // namespace

base::Result<Edit> makeSumToOne(const fuzzy::ForceModel& model, const TermListId& list) {
  fuzzy::ForceModel out = model;
  TACTUS_TRY(const auto open, openList(out, list));
  auto& terms = *open.terms;
  const fuzzy::Variable& variable = *open.variable;
  if (anyGaussian(terms)) {
    return fail(ErrorCode::kValue, open.title(), "a Gaussian", "trapezoids and triangles, which can sum to one");
  }
  const TermOrder order = analysis::byMiddleOfCore(terms);
  std::vector<Ramp> ramps;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const auto left = MembershipFunction::of(terms[order[k]]);
    const auto right = MembershipFunction::of(terms[order[k + 1]]);
    const auto inside = [&](double x) { return std::clamp(x, variable.min, variable.max); };
    ramps.push_back({inside(left.c / 2 + right.a / 2), inside(left.d / 2 + right.b / 2)});
  }
  putInOrder(ramps, kNarrowestShare * (variable.max - variable.min));
  for (std::size_t k = 0; k < order.size(); ++k) {
    Term& term = terms[order[k]];
    const Ramp left = k == 0 ? Ramp{variable.min, variable.min} : ramps[k - 1];
    const double end = k == 0 ? variable.max : std::max(variable.max, left.to);
    const Ramp right = k + 1 == order.size() ? Ramp{end, end} : ramps[k];
    const bool stays_triangle = term.shape == Shape::kTriangle && left.to == right.from;
    term.shape = stays_triangle ? Shape::kTriangle : Shape::kTrapezoid;
    term.points = stays_triangle ? std::vector{left.from, left.to, right.to}
                                 : std::vector{left.from, left.to, right.from, right.to};
  }
  return finished(std::move(out), open.title() + ": terms sum to one");
}

bool names(const fuzzy::Rule& rule, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
           const std::string& term) {
  if (variable.id == model.output.id) return rule.then == term;
  return std::find(rule.conditions.begin(), rule.conditions.end(), fuzzy::Condition{variable.id, term}) !=
         rule.conditions.end();
}

fuzzy::Rule withTerm(fuzzy::Rule rule, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
                     const std::string& from, const std::string& to) {
  if (variable.id == model.output.id) {
    if (rule.then == from) rule.then = to;
    return rule;
  }
  for (auto& condition : rule.conditions) {
    if (condition.input == variable.id && condition.term == from) condition.term = to;
  }
  return rule;
}

void moveEvents(fuzzy::ForceModel& model, const TermListId& list, const std::string& from, const std::string& to) {
  const auto way = fuzzy::wayOf(model.inputs);
  if (!way || !list.expert.empty() || list.variable != model.inputs[*way].id) return;
  for (fuzzy::TubeEvent& event : model.events) {
    if (event.term == from) event.term = to;
  }
}

base::Result<void> letGo(fuzzy::Expert& expert, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
                         const std::string& term, RulesOfTerm rules) {
  const auto concerned = [&](const fuzzy::Rule& rule) { return names(rule, model, variable, term); };
  const auto count = std::count_if(expert.rules.begin(), expert.rules.end(), concerned);
  if (count == 0) return {};
  if (rules == RulesOfTerm::kRefuse) {
    return base::fail(
        base::ErrorCode::kReference, labelOf(variable) + " / " + term,
        std::to_string(count) + (count == 1 ? " rule of " : " rules of ") + labelOf(expert) + " with this term",
        "none, or that they are removed too");
  }
  expert.rules.erase(std::remove_if(expert.rules.begin(), expert.rules.end(), concerned), expert.rules.end());
  return {};
}

base::Result<Edit> convertShape(const fuzzy::ForceModel& model, const TermPlace& place, fuzzy::Shape shape) {
  fuzzy::ForceModel out = model;
  TACTUS_TRY(const auto list, openList(out, place.list));
  TACTUS_TRY(const auto index, findTermIn(list, place.term));
  fuzzy::Term& term = (*list.terms)[index];
  TACTUS_TRY(auto other, analysis::convertedTerm(term, shape, list.variable->min, list.variable->max));
  std::string label =
      list.title() + " / " + labelOf(term) + ": " + std::string(name(term.shape)) + " to " + std::string(name(shape));
  term = std::move(other);
  return finished(std::move(out), std::move(label));
}

namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using fuzzy::ForceModel;
using fuzzy::Term;

/// Widest ramp for which the ramps at the cuts neither leave the core nor meet; 0 where the cuts are not inside.
double widestOverlap(const Term& term, const std::vector<double>& cuts) {
  const double b = term.points[1];
  const double c = term.points[2];
  double widest = 2 * std::min(cuts.front() - b, c - cuts.back());
  for (std::size_t k = 1; k < cuts.size(); ++k) widest = std::min(widest, cuts[k] - cuts[k - 1]);
  return std::max(widest, 0.0);
}

double usualOverlap(const Term& term, const fuzzy::Variable& variable, const std::vector<double>& cuts) {
  constexpr double kShareOfUniverse = 0.01;
  const auto& p = term.points;
  const double ramps = ((p[1] - p[0]) + (p[3] - p[2])) / 2;
  double shortest = std::min(cuts.front() - p[1], p[2] - cuts.back());
  for (std::size_t k = 1; k < cuts.size(); ++k) shortest = std::min(shortest, cuts[k] - cuts[k - 1]);
  return std::min(ramps > 0 ? ramps : kShareOfUniverse * (variable.max - variable.min), shortest / 2);
}

Result<double> overlapFor(const OpenList& list, const Term& term, const SplitOptions& options) {
  const std::string place = list.title() + " / " + labelOf(term);
  if (term.shape != fuzzy::Shape::kTrapezoid) {
    return fail(ErrorCode::kValue, place, "a " + std::string(name(term.shape)),
                "a trapezoid, whose core can be split; convert it first");
  }
  const auto& cuts = options.cuts;
  const bool finite = std::all_of(cuts.begin(), cuts.end(), [](double cut) { return std::isfinite(cut); });
  const double widest = cuts.empty() || !finite ? 0 : widestOverlap(term, cuts);
  if (!(widest > 0)) {
    std::vector<std::string> texts;
    texts.reserve(cuts.size());
    for (const double cut : cuts) texts.push_back(base::formatNumber(cut));
    return fail(ErrorCode::kValue, place, cuts.empty() ? "no cut" : "cuts at " + base::joined(texts, ", "),
                "ascending cuts inside the core, " + numberText(*list.variable, term.points[1]) + " to " +
                    quantityText(*list.variable, term.points[2]));
  }
  const double overlap = options.overlap.value_or(usualOverlap(term, *list.variable, cuts));
  if (overlap > 0 && overlap <= widest) return overlap;
  return fail(ErrorCode::kValue, place, "an overlap of " + base::formatNumber(overlap),
              "more than 0, at most " + quantityText(*list.variable, widest));
}

Result<std::vector<Term>> partsOf(const OpenList& list, const Term& term, const SplitOptions& options) {
  TACTUS_TRY(const auto overlap, overlapFor(list, term, options));
  const std::size_t count = options.cuts.size() + 1;
  if (!options.names.empty() && options.names.size() != count) {
    return fail(ErrorCode::kValue, list.title() + " / " + labelOf(term),
                std::to_string(options.names.size()) + " names", std::to_string(count) + ", one for each part");
  }
  std::vector<Term> taken = *list.terms;
  std::vector<Term> parts;
  double from = term.points[0];
  double to = term.points[1];
  for (std::size_t k = 0; k < count; ++k) {
    Term part = term;
    const std::string number = std::to_string(k + 1);
    part.id = options.names.empty() ? freeTermId(taken, term.id + '_' + number) : options.names[k].id;
    part.label = options.names.empty() ? labelOf(term) + ' ' + number : options.names[k].label;
    const bool last = k + 1 == count;
    const double next_from = last ? term.points[2] : options.cuts[k] - overlap / 2;
    const double next_to = last ? term.points[3] : options.cuts[k] + overlap / 2;
    // Rounding must not put a shoulder before the one in front of it.
    part.points = {from, to, std::max(to, next_from), std::max(to, next_to)};
    from = part.points[2];
    to = part.points[3];
    taken.push_back(part);
    parts.push_back(std::move(part));
  }
  return parts;
}

std::size_t partInTheMiddle(const Term& term, const std::vector<double>& cuts) {
  const double middle = term.points[1] / 2 + term.points[2] / 2;
  return static_cast<std::size_t>(std::upper_bound(cuts.begin(), cuts.end(), middle) - cuts.begin());
}

}  // namespace

Result<Edit> splitTerm(const ForceModel& model, const TermPlace& place, const SplitOptions& options) {
  ForceModel out = model;
  TACTUS_TRY(const auto open, openList(out, place.list));
  TACTUS_TRY(const auto index, findTermIn(open, place.term));
  auto& terms = *open.terms;
  const Term term = terms[index];
  TACTUS_TRY(auto parts, partsOf(open, term, options));

  const bool copy = options.copy_rules && open.variable != &out.output;
  const std::string middle = parts[partInTheMiddle(term, options.cuts)].id;
  for (auto& expert : out.experts) {
    if (!reads(expert, place.list)) continue;
    std::vector<fuzzy::Rule> rules;
    for (const auto& rule : expert.rules) {
      if (!names(rule, out, *open.variable, term.id)) {
        rules.push_back(rule);
      } else if (!copy) {
        rules.push_back(withTerm(rule, out, *open.variable, term.id, middle));
      } else {
        for (const Term& part : parts) rules.push_back(withTerm(rule, out, *open.variable, term.id, part.id));
      }
    }
    expert.rules = std::move(rules);
  }

  moveEvents(out, place.list, term.id, parts.back().id);
  std::vector<std::string> cuts;
  for (const double cut : options.cuts) cuts.push_back(numberText(*open.variable, cut));
  std::string label = open.title() + " / " + labelOf(term) + ": split at " + base::joined(cuts, ", ");
  if (!open.variable->unit.empty() && open.variable->unit != "1") label += ' ' + open.variable->unit;
  terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(index));
  terms.insert(terms.begin() + static_cast<std::ptrdiff_t>(index), parts.begin(), parts.end());
  return finished(std::move(out), std::move(label));
}

namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using fuzzy::ForceModel;
using fuzzy::MembershipFunction;
using fuzzy::Term;

/// The core of a trapezoid or triangle: peaks count as cores of no width.
double& leftShoulder(Term& term) { return term.points[1]; }
double& rightShoulder(Term& term) { return term.points[term.points.size() - 2]; }

double middleOf(const Term& term) {
  const auto f = MembershipFunction::of(term);
  return f.gaussian ? f.mean : f.b / 2 + f.c / 2;
}

/// A triangle whose core gets a width becomes a trapezoid.
void openCore(Term& term) {
  if (term.shape != fuzzy::Shape::kTriangle) return;
  term.shape = fuzzy::Shape::kTrapezoid;
  term.points.insert(term.points.begin() + 1, term.points[1]);
}

/// The neighbors of term number `place` in `order` close the gap that it leaves.
void closeGap(std::vector<Term>& terms, const TermOrder& order, std::size_t place) {
  const auto removed = MembershipFunction::of(terms[order[place]]);
  const bool first = place == 0;
  const bool last = place + 1 == order.size();
  const double middle = removed.b / 2 + removed.c / 2;
  const double half_ramp = ((removed.b - removed.a) + (removed.d - removed.c)) / 4;
  double from = std::max(middle - half_ramp, removed.a);
  double to = std::min(middle + half_ramp, removed.d);
  if (first) from = removed.a, to = removed.b;
  if (last) from = removed.c, to = removed.d;
  if (!first) {
    Term& left = terms[order[place - 1]];
    openCore(left);
    rightShoulder(left) = from;
    left.points.back() = to;
  }
  if (!last) {
    Term& right = terms[order[place + 1]];
    openCore(right);
    right.points.front() = from;
    leftShoulder(right) = to;
  }
}

}  // namespace

std::string freeTermId(const std::vector<Term>& terms, const std::string& wanted) {
  std::string id = wanted;
  for (int n = 2; findTerm(terms, id) != nullptr; ++n) id = wanted + '_' + std::to_string(n);
  return id;
}

Term suggestedTerm(const fuzzy::Variable& variable, const std::vector<Term>& terms, double at) {
  constexpr double kShare = 0.05;
  const double width = kShare * (variable.max - variable.min);
  Term term;
  term.id = freeTermId(terms, "new_term");
  term.label = "New term";
  term.points = {at - 1.5 * width, at - 0.5 * width, at + 0.5 * width, at + 1.5 * width};
  return term;
}

Result<Edit> addTerm(const ForceModel& model, const TermListId& list, const Term& term) {
  if (term.points.size() != pointCount(term.shape)) {
    return fail(ErrorCode::kSchema, labelOf(term), std::to_string(term.points.size()) + " points",
                std::to_string(pointCount(term.shape)) + " for a " + std::string(name(term.shape)));
  }
  ForceModel out = model;
  TACTUS_TRY(const auto open, openList(out, list));
  auto& terms = *open.terms;
  const double middle = middleOf(term);
  const auto next =
      std::find_if(terms.begin(), terms.end(), [middle](const Term& other) { return middleOf(other) > middle; });
  terms.insert(next, term);
  std::string label = open.title() + ": " + labelOf(term) + " added";
  return finished(std::move(out), std::move(label));
}

Result<Edit> renameTerm(const ForceModel& model, const TermPlace& place, const std::string& id,
                        const std::string& label) {
  ForceModel out = model;
  TACTUS_TRY(const auto open, openList(out, place.list));
  TACTUS_TRY(const auto index, findTermIn(open, place.term));
  if (id != place.term && findTerm(*open.terms, id) != nullptr) {
    return fail(ErrorCode::kSchema, open.title(), base::quoted(id) + " twice", "an id that no other term has");
  }
  Term& term = (*open.terms)[index];
  std::string what = open.title() + " / " + labelOf(term);
  term.id = id;
  term.label = label;
  what += ": renamed to " + labelOf(term);
  for (auto& expert : out.experts) {
    if (!reads(expert, place.list)) continue;
    for (auto& rule : expert.rules) rule = withTerm(std::move(rule), out, *open.variable, place.term, id);
  }
  moveEvents(out, place.list, place.term, id);
  return finished(std::move(out), std::move(what));
}

Result<Edit> removeTerm(const ForceModel& model, const TermPlace& place, const RemoveOptions& options) {
  ForceModel out = model;
  TACTUS_TRY(const auto open, openList(out, place.list));
  TACTUS_TRY(const auto index, findTermIn(open, place.term));
  auto& terms = *open.terms;
  std::string label = open.title() + " / " + labelOf(terms[index]) + ": removed";
  if (terms.size() == 1) {
    return fail(ErrorCode::kValue, open.title(), "the last term", "a list that keeps one or more");
  }
  for (auto& expert : out.experts) {
    if (!reads(expert, place.list)) continue;
    const std::size_t before = expert.rules.size();
    if (auto ok = letGo(expert, out, *open.variable, place.term, options.rules); !ok) {
      return tl::unexpected(ok.error());
    }
    if (const std::size_t gone = before - expert.rules.size(); gone > 0) {
      label += ", with " + std::to_string(gone) + (gone == 1 ? " rule of " : " rules of ") + labelOf(expert);
    }
  }
  if (options.sum_to_one) {
    const auto order = partitionOrder(*open.variable, terms);
    if (!order) {
      return fail(ErrorCode::kValue, open.title(), "terms that do not sum to one",
                  "terms that do, or to edit without that mode");
    }
    closeGap(terms, *order, static_cast<std::size_t>(std::find(order->begin(), order->end(), index) - order->begin()));
  }
  terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(index));
  const std::size_t events = out.events.size();
  fuzzy::eraseLostEvents(out);
  if (out.events.size() < events) label += ", with its puncture";
  return finished(std::move(out), std::move(label));
}

}  // namespace tactus::editing
