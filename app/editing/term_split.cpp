#include "app/editing/term_split.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editing/edit_text.h"
#include "app/editing/rules_of_term.h"
#include "app/editing/term_edits.h"
#include "core/base/text.h"

namespace tactus::editing {
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
  const auto overlap = overlapFor(list, term, options);
  if (!overlap) return tl::unexpected(overlap.error());
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
    const double next_from = last ? term.points[2] : options.cuts[k] - *overlap / 2;
    const double next_to = last ? term.points[3] : options.cuts[k] + *overlap / 2;
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
  const auto open = openList(out, place.list);
  if (!open) return tl::unexpected(open.error());
  const auto index = findTermIn(*open, place.term);
  if (!index) return tl::unexpected(index.error());
  auto& terms = *open->terms;
  const Term term = terms[*index];
  auto parts = partsOf(*open, term, options);
  if (!parts) return tl::unexpected(parts.error());

  const bool copy = options.copy_rules && open->variable != &out.output;
  const std::string middle = (*parts)[partInTheMiddle(term, options.cuts)].id;
  for (auto& expert : out.experts) {
    if (!reads(expert, place.list)) continue;
    std::vector<fuzzy::Rule> rules;
    for (const auto& rule : expert.rules) {
      if (!names(rule, out, *open->variable, term.id)) {
        rules.push_back(rule);
      } else if (!copy) {
        rules.push_back(withTerm(rule, out, *open->variable, term.id, middle));
      } else {
        for (const Term& part : *parts) rules.push_back(withTerm(rule, out, *open->variable, term.id, part.id));
      }
    }
    expert.rules = std::move(rules);
  }

  std::vector<std::string> cuts;
  for (const double cut : options.cuts) cuts.push_back(numberText(*open->variable, cut));
  std::string label = open->title() + " / " + labelOf(term) + ": split at " + base::joined(cuts, ", ");
  if (!open->variable->unit.empty() && open->variable->unit != "1") label += ' ' + open->variable->unit;
  terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(*index));
  terms.insert(terms.begin() + static_cast<std::ptrdiff_t>(*index), parts->begin(), parts->end());
  return finished(std::move(out), std::move(label));
}

}  // namespace tactus::editing
