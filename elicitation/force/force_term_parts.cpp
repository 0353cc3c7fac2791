#include "elicitation/force/force_term_parts.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

constexpr double kPerMicronewton = 1e6;

}  // namespace

double toMicronewton(double force_n) { return std::round(force_n * kPerMicronewton) / kPerMicronewton; }

std::vector<TermRamp> rampsAround(std::span<const double> threshold_n, double half_n, double last_half_n) {
  std::vector<TermRamp> ramps;
  for (std::size_t first = 0; first < threshold_n.size();) {
    std::size_t last = first;
    while (last + 1 < threshold_n.size() && threshold_n[last + 1] == threshold_n[first]) ++last;
    const bool highest = last + 1 == threshold_n.size();
    double side_n = std::min(highest ? last_half_n : half_n, threshold_n[first]);
    if (first > 0) side_n = std::min(side_n, (threshold_n[first] - threshold_n[first - 1]) / 2);
    if (!highest) side_n = std::min(side_n, (threshold_n[last + 1] - threshold_n[first]) / 2);
    const auto parts = static_cast<double>(last - first + 1);
    const auto end = [&](std::size_t part) {
      return toMicronewton(threshold_n[first] + side_n * (2 * static_cast<double>(part) / parts - 1));
    };
    for (std::size_t part = 0; part <= last - first; ++part) {
      // Ramps that touch may round to either side of half a micronewton.
      const double begin_n = ramps.empty() ? end(part) : std::max(end(part), ramps.back().end_n);
      ramps.push_back({begin_n, std::max(begin_n, end(part + 1))});
    }
    first = last + 1;
  }
  return ramps;
}

ForceTerms emptyForceTerms(const fuzzy::Variable& output, const ForceEnd& end) {
  ForceTerms out;
  out.output = output;
  out.output.min = 0;
  out.output.max = end.given_n.value_or(end.last_n);
  out.output.terms.clear();
  out.notes = end.notes;
  out.end_reason = end.given_n ? "as asked for" : end.reason;
  return out;
}

void endAbove(ForceTerms& out, const ForceEnd& end, std::size_t steps, double end_n) {
  if (end.given_n) return;
  out.output.max = end_n;
  out.end_reason = (steps == 1 ? "one step" : std::to_string(steps) + " steps") + " above the last force with a term";
}

void addAbsent(ForceTerms& out, const fuzzy::Term& term) {
  out.absent.push_back(term.id);
  out.notes.push_back("There is no room for " + base::quoted(term.id) + " between 0 N and the end of the universe at " +
                      base::roundedNumber(out.output.max) + " N: the term does not exist.");
}

void addInterpolated(ForceTerms& out, const fuzzy::Term& term, const ForceEnd& end, double at_n) {
  out.interpolated.push_back(term.id);
  const bool above = at_n > end.last_n;
  out.notes.push_back((above ? "No force up to " + base::roundedNumber(end.last_n) + " N was given "
                             : std::string("No force was given ")) +
                      base::quoted(term.id) + ": its term is placed " +
                      (above ? "one step above, at " : "between its neighbors, around ") + base::roundedNumber(at_n) +
                      " N.");
}

void placeBetween(const fuzzy::Variable& output, std::span<const TermRamp> ramps, ForceTerms& out) {
  const std::size_t terms = output.terms.size();
  TACTUS_CHECK(ramps.size() + 1 == terms);
  const double end_n = out.output.max;
  for (std::size_t k = 0; k < terms; ++k) {
    fuzzy::Term term = output.terms[k];
    const TermRamp rise = k == 0 ? TermRamp{out.output.min, out.output.min} : ramps[k - 1];
    const bool highest = k + 1 == terms || !(ramps[k].begin_n < end_n);
    const double shoulder_n = std::max(end_n, rise.end_n);
    const TermRamp fall = highest ? TermRamp{shoulder_n, shoulder_n} : ramps[k];
    if (!(rise.begin_n < std::min(fall.end_n, end_n))) {
      addAbsent(out, term);
      continue;
    }
    term.shape = fuzzy::Shape::kTrapezoid;
    term.points = {rise.begin_n, rise.end_n, fall.begin_n, fall.end_n};
    out.output.terms.push_back(std::move(term));
  }
}

}  // namespace tactus::elicitation
