#include "app/editing/term_edits.h"

#include <algorithm>
#include <utility>

#include "app/editing/edit_text.h"
#include "app/editing/partition.h"
#include "app/editing/rules_of_term.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::editing {
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
  const auto open = openList(out, list);
  if (!open) return tl::unexpected(open.error());
  auto& terms = *open->terms;
  const double middle = middleOf(term);
  const auto next =
      std::find_if(terms.begin(), terms.end(), [middle](const Term& other) { return middleOf(other) > middle; });
  terms.insert(next, term);
  std::string label = open->title() + ": " + labelOf(term) + " added";
  return finished(std::move(out), std::move(label));
}

Result<Edit> renameTerm(const ForceModel& model, const TermPlace& place, const std::string& id,
                        const std::string& label) {
  ForceModel out = model;
  const auto open = openList(out, place.list);
  if (!open) return tl::unexpected(open.error());
  const auto index = findTermIn(*open, place.term);
  if (!index) return tl::unexpected(index.error());
  if (id != place.term && findTerm(*open->terms, id) != nullptr) {
    return fail(ErrorCode::kSchema, open->title(), base::quoted(id) + " twice", "an id that no other term has");
  }
  Term& term = (*open->terms)[*index];
  std::string what = open->title() + " / " + labelOf(term);
  term.id = id;
  term.label = label;
  what += ": renamed to " + labelOf(term);
  for (auto& expert : out.experts) {
    if (!reads(expert, place.list)) continue;
    for (auto& rule : expert.rules) rule = withTerm(std::move(rule), out, *open->variable, place.term, id);
  }
  return finished(std::move(out), std::move(what));
}

Result<Edit> removeTerm(const ForceModel& model, const TermPlace& place, const RemoveOptions& options) {
  ForceModel out = model;
  const auto open = openList(out, place.list);
  if (!open) return tl::unexpected(open.error());
  const auto index = findTermIn(*open, place.term);
  if (!index) return tl::unexpected(index.error());
  auto& terms = *open->terms;
  std::string label = open->title() + " / " + labelOf(terms[*index]) + ": removed";
  if (terms.size() == 1) {
    return fail(ErrorCode::kValue, open->title(), "the last term", "a list that keeps one or more");
  }
  for (auto& expert : out.experts) {
    if (!reads(expert, place.list)) continue;
    const std::size_t before = expert.rules.size();
    if (auto ok = letGo(expert, out, *open->variable, place.term, options.rules); !ok) {
      return tl::unexpected(ok.error());
    }
    if (const std::size_t gone = before - expert.rules.size(); gone > 0) {
      label += ", with " + std::to_string(gone) + (gone == 1 ? " rule of " : " rules of ") + labelOf(expert);
    }
  }
  if (options.sum_to_one) {
    const auto order = partitionOrder(*open->variable, terms);
    if (!order) {
      return fail(ErrorCode::kValue, open->title(), "terms that do not sum to one",
                  "terms that do, or to edit without that mode");
    }
    closeGap(terms, *order, static_cast<std::size_t>(std::find(order->begin(), order->end(), *index) - order->begin()));
  }
  terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(*index));
  return finished(std::move(out), std::move(label));
}

}  // namespace tactus::editing
