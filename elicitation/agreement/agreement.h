// Agreement of raters: all measures on one set of ratings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elicitation/agreement/agreement_data.h"
#include "elicitation/agreement/fleiss_kappa.h"
#include "elicitation/agreement/item_consensus.h"
#include "elicitation/agreement/kendall_w.h"
#include "elicitation/agreement/krippendorff_alpha.h"

namespace tactus::elicitation {

struct Agreement {
  OrReason<FleissKappa> fleiss_kappa;
  OrReason<double> alpha_nominal;
  OrReason<double> alpha_ordinal;
  OrReason<double> alpha_interval;
  OrReason<KendallW> kendall_w;
  std::vector<std::optional<ItemConsensus>> items;  ///< one per unit of the data; empty for fewer than two ratings
  long long ratings = 0;
};

Agreement agreement(const AgreementData& data);

/// One sentence: why the measures for unordered categories are low for ordered terms.
std::string_view nominalCaution();

}  // namespace tactus::elicitation
