#include "app/cli/pull_findings.h"

#include <algorithm>

namespace tactus::cli {

std::vector<std::string> NewFindings::after(const analysis::PullCandidate& candidate) const {
  const auto model = applied(before_.model, candidate.edits);
  const auto compiled = fuzzy::compile(model);
  if (!compiled) return {};  // no such candidate is offered
  std::vector<std::string> out;
  for (const analysis::Finding& one : analysis::lint(model, *compiled).findings) {
    const bool is_known = std::any_of(known_.begin(), known_.end(), [&](const analysis::Finding& other) {
      return other.kind == one.kind && other.expert == one.expert && other.where == one.where;
    });
    if (!is_known) out.push_back((one.expert.empty() ? "" : one.expert + ": ") + one.text);
  }
  return out;
}

}  // namespace tactus::cli
