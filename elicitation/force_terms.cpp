#include "elicitation/force_terms.h"

#include <optional>

#include "core/base/check.h"
#include "core/base/error.h"
#include "elicitation/rounded_number.h"

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

void fillGaps(Cores& cores, double min, double max) {
  double low = min;
  for (std::size_t k = 0; k < cores.size();) {
    if (cores[k]) {
      low = cores[k]->end;
      ++k;
      continue;
    }
    std::size_t next = k;
    while (next < cores.size() && !cores[next]) ++next;
    fillGap(cores, k, next, low, next < cores.size() ? cores[next]->begin : max);
    k = next;
  }
}

}  // namespace

base::Result<ForceTerms> forceTerms(const fuzzy::Variable& output, std::span<const VoteStep> steps) {
  std::optional<double> last;
  for (const auto& step : steps) {
    if (step.term) last = step.force_n;
  }
  if (!last || !(*last > 0)) {
    return base::fail(base::ErrorCode::kData, "vote", last ? "decided forces of 0 N alone" : "no decided force",
                      "at least one force above 0 N that somebody judged");
  }

  ForceTerms out;
  out.output = output;
  out.output.min = 0;
  out.output.max = *last;
  out.output.terms.clear();
  Cores cores = wonCores(steps, output.terms.size());
  fillGaps(cores, out.output.min, out.output.max);

  const Core* below = nullptr;
  for (std::size_t k = 0; k < cores.size(); ++k) {
    fuzzy::Term term = output.terms[k];
    if (!cores[k]) {
      out.absent.push_back(term.id);
      out.notes.push_back("No force was voted " + base::quoted(term.id) +
                          " and there is no room for it: the term does not exist.");
      continue;
    }
    const Core& core = *cores[k];
    const Core* above = nullptr;
    for (std::size_t next = k + 1; next < cores.size() && above == nullptr; ++next) {
      if (cores[next]) above = &*cores[next];
    }
    term.shape = fuzzy::Shape::kTrapezoid;
    term.points = {below == nullptr ? out.output.min : below->end, below == nullptr ? out.output.min : core.begin,
                   above == nullptr ? out.output.max : core.end, above == nullptr ? out.output.max : above->begin};
    if (core.peak) {
      out.interpolated.push_back(term.id);
      out.notes.push_back("No force was voted " + base::quoted(term.id) +
                          ": its term is placed between its neighbours, around " + roundedNumber(core.begin) + " N.");
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

}  // namespace tactus::elicitation
