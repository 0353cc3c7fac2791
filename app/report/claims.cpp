#include "app/report/claims.h"

#include "app/report/claim_parts.h"

namespace tactus::report {

base::Result<std::vector<Claim>> checkClaims(const fuzzy::ForceModel& model, const ClaimSubjects& subjects) {
  const auto curves = ForceCurves::of(model);
  if (!curves) return tl::unexpected(curves.error());
  ClaimContext context{.model = model,
                       .curves = *curves,
                       .regions = {},
                       .published_expert = model.experts.size(),
                       .highest_peak_expert = subjects.highest_peak_expert};
  for (std::size_t i = 0; i < model.experts.size(); ++i) {
    if (model.experts[i].id == subjects.published_expert) context.published_expert = i;
  }
  if (context.published_expert == model.experts.size()) {
    return base::fail(base::ErrorCode::kReference, "/experts", "no expert " + base::quoted(subjects.published_expert),
                      "the expert whose rules are published");
  }
  context.regions = depthRegions(context.input("depth"));
  std::vector<Claim> claims = claimsOfOrder(context);
  for (Claim& claim : claimsOfProfile(context)) claims.push_back(std::move(claim));
  for (Claim& claim : claimsOfAgreement(context)) claims.push_back(std::move(claim));
  return claims;
}

}  // namespace tactus::report
