#include "elicitation/agreement/agreement.h"

namespace tactus::elicitation {

Agreement agreement(const AgreementData& data) {
  Agreement out{.fleiss_kappa = fleissKappa(data.counts),
                .alpha_nominal = krippendorffAlpha(data.counts, AlphaLevel::kNominal),
                .alpha_ordinal = krippendorffAlpha(data.counts, AlphaLevel::kOrdinal),
                .alpha_interval = krippendorffAlpha(data.counts, AlphaLevel::kInterval),
                .kendall_w = tl::unexpected(
                    std::string("a table of counts does not say who chose what, and the measure compares persons")),
                .items = {}};
  if (data.ratings) out.kendall_w = kendallW(*data.ratings);
  for (const auto& unit : data.counts.units) {
    out.items.push_back(itemConsensus(unit));
    out.ratings += ratingsOf(unit);
  }
  return out;
}

std::string_view nominalCaution() {
  return "Fleiss' kappa misleads here: it takes neighboring terms for as different as the ends of the scale, so "
         "raters "
         "who are one term apart count as strangers.";
}

}  // namespace tactus::elicitation
