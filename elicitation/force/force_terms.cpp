#include "elicitation/force/force_terms.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "elicitation/force/force_end.h"
#include "elicitation/force/force_term_parts.h"

namespace tactus::elicitation {
namespace {

/// Where a term has membership 1; `peak` marks a term that no step won.
struct Core {
  double begin = 0;
  double end = 0;
  bool peak = false;
};

using Cores = std::vector<std::optional<Core>>;

Cores wonCores(std::span<const VoteStep> steps, std::size_t terms) {
  Cores cores(terms);
  for (const auto& step : steps) {
    if (!step.term) continue;
    TACTUS_CHECK(*step.term < terms);
    auto& core = cores[*step.term];
    if (!core) core = Core{step.force_n, step.force_n, false};
    core->end = step.force_n;
  }
  return cores;
}

/// Puts peaks for the terms `first` to `last` - 1 into the gap [low, high]; a gap without width takes none.
void fillGap(Cores& cores, std::size_t first, std::size_t last, double low, double high) {
  if (!(high > low)) return;
  const auto parts = static_cast<double>(last - first + 1);
  for (std::size_t k = first; k < last; ++k) {
    const double at = low + static_cast<double>(k - first + 1) * (high - low) / parts;
    cores[k] = Core{at, at, true};
  }
}

/// Peaks for missing terms below the highest that was won.
void fillGaps(Cores& cores, double min) {
  double low = min;
  for (std::size_t k = 0; k < cores.size();) {
    if (cores[k]) {
      low = cores[k]->end;
      ++k;
      continue;
    }
    std::size_t next = k;
    while (next < cores.size() && !cores[next]) ++next;
    if (next < cores.size()) fillGap(cores, k, next, low, cores[next]->begin);
    k = next;
  }
}

/// Each term above the highest that was won lies one step above the one before it.
void addAbove(Cores& cores, const ForceEnd& end, ForceTerms& out) {
  std::size_t highest = cores.size();
  while (!cores[highest - 1]) --highest;
  for (std::size_t k = highest; k < cores.size(); ++k) {
    const double at_n = end.stepsAbove(k - highest + 1);
    cores[k] = Core{at_n, at_n, true};
    endAbove(out, end, k - highest + 1, at_n);
  }
}

}  // namespace

std::string_view name(ForceTermsFrom from) noexcept {
  switch (from) {
    case ForceTermsFrom::kVote: return "vote";
    case ForceTermsFrom::kFrequency: return "frequency";
    case ForceTermsFrom::kThresholds: return "thresholds";
    case ForceTermsFrom::kProbit: return "probit";
  }
  return "";
}

base::Result<ForceTerms> forceTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                    std::optional<double> end_n) {
  TACTUS_TRY(const auto end, forceEnd(steps, end_n));
  ForceTerms out = emptyForceTerms(output, end);
  Cores cores = wonCores(steps.first(end.steps), output.terms.size());
  fillGaps(cores, out.output.min);
  addAbove(cores, end, out);

  const Core* below = nullptr;
  for (std::size_t k = 0; k < cores.size(); ++k) {
    fuzzy::Term term = output.terms[k];
    if (!cores[k] || (below != nullptr && !(below->end < out.output.max))) {
      addAbsent(out, term);
      continue;
    }
    const Core& core = *cores[k];
    const Core* above = nullptr;
    for (std::size_t next = k + 1; next < cores.size() && above == nullptr && core.end < out.output.max; ++next) {
      if (cores[next]) above = &*cores[next];
    }
    const double max = std::max(out.output.max, core.end);
    term.shape = fuzzy::Shape::kTrapezoid;
    term.points = {below == nullptr ? out.output.min : below->end, below == nullptr ? out.output.min : core.begin,
                   above == nullptr ? max : core.end, above == nullptr ? max : above->begin};
    if (core.peak) {
      addInterpolated(out, term, end, core.begin);
      if (below != nullptr && above != nullptr) {
        term.shape = fuzzy::Shape::kTriangle;
        term.points = {below->end, core.begin, above->begin};
      }
    }
    out.output.terms.push_back(std::move(term));
    below = &core;
  }
  return out;
}

std::vector<std::string> unsaidNotes(const fuzzy::Variable& output, std::span<const VoteStep> steps,
                                     std::optional<double> end_n) {
  std::vector<std::string> notes;
  std::vector<VoteStep> said(steps.begin(), steps.end());
  std::size_t decided = 0;
  std::size_t others = 0;
  std::size_t level = 0;
  for (VoteStep& step : said) {
    if (!step.term) continue;
    ++decided;
    if (isUnsaid(step)) {
      notes.push_back("Nobody said " + output.terms[*step.term].label + " at " + base::roundedNumber(step.force_n) +
                      " N: the rule of the vote gives the word.");
    }
    if (!isMostFrequent(step)) ++others;
    const auto most = std::max_element(step.votes.rbegin(), step.votes.rend());
    level = std::max(level, static_cast<std::size_t>(step.votes.rend() - most) - 1);
    step.term = level;
  }
  if (others == 0) return notes;
  const auto by_rule = forceTerms(output, steps, end_n);
  const auto by_count = forceTerms(output, said, end_n);
  double moved_n = 0;
  if (by_rule && by_count) {
    for (const fuzzy::Term& term : by_rule->output.terms) {
      const fuzzy::Term* const other = findTerm(by_count->output.terms, term.id);
      if (other == nullptr || other->points.size() != term.points.size()) continue;
      for (std::size_t p = 0; p < term.points.size(); ++p)
        moved_n = std::max(moved_n, std::abs(term.points[p] - other->points[p]));
    }
  }
  notes.push_back(std::to_string(others) + " of " + std::to_string(decided) +
                  (others == 1 ? " winners is" : " winners are") +
                  " not the most frequent word; with those the words move by up to " + base::roundedNumber(moved_n) +
                  " N. The frequency, the thresholds and the probit (--force-terms) use every answer as it was given.");
  return notes;
}

}  // namespace tactus::elicitation
