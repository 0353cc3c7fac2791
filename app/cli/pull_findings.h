// What the lint finds in a model after an edit and did not find before.
#pragma once

#include <string>
#include <vector>

#include "app/cli/opened_model.h"
#include "core/analysis/lint.h"
#include "core/analysis/pull/pull.h"

namespace tactus::cli {

class NewFindings {
 public:
  /// `before` outlives this object.
  explicit NewFindings(const OpenedModel& before)
      : before_(before), known_(analysis::lint(before.model, before.compiled).findings) {}

  /// One sentence for each finding of the model after `candidate` that the model before has not, with its expert.
  std::vector<std::string> after(const analysis::PullCandidate& candidate) const;

 private:
  const OpenedModel& before_;
  std::vector<analysis::Finding> known_;
};

}  // namespace tactus::cli
