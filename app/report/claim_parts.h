// Shared parts of the statements about Fig. 10 and Fig. 11. Internal to the checklist.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/report/claims.h"
#include "app/report/force_curves.h"
#include "app/report/regions.h"

namespace tactus::report {

/// A model with the data from which the statements are computed.
struct ClaimContext {
  const fuzzy::ForceModel& model;
  const ForceCurves& curves;
  std::vector<Region> regions;
  std::size_t published_expert = 0;
  std::string highest_peak_expert;

  const fuzzy::Variable& input(std::string_view id) const;
  ClaimBasis basisOf(std::size_t expert) const {
    return expert == published_expert ? ClaimBasis::kPublishedRules : ClaimBasis::kSimulated;
  }
};

/// Statements about Fig. 10: the order of curves.
std::vector<Claim> claimsOfOrder(const ClaimContext& context);
/// Statements about Fig. 11: the shape of each curve.
std::vector<Claim> claimsOfProfile(const ClaimContext& context);
/// Statements about Fig. 11: how the curves of the experts compare.
std::vector<Claim> claimsOfAgreement(const ClaimContext& context);

/// Setting of Fig. 11: lubrication 1, neck flexion 60 deg, 50 mm/s.
inline constexpr CurveSetting kFig11{1, 60, 50};

/// The curve of Fig. 11 of one expert or of the mean.
struct Profile {
  std::string subject;
  ClaimBasis basis = ClaimBasis::kByConstruction;
  std::optional<std::size_t> expert;
  ForceCurve curve;  ///< depths with a force only
};
Profile profileOf(const ClaimContext& context, std::optional<std::size_t> expert);

/// The points of `curve` with its largest force. `curve` must not be empty, and every point must have a force.
std::vector<CurvePoint> peaksOf(const ForceCurve& curve);
/// Force, depth and region of the peaks.
std::string peakText(const ClaimContext& context, const std::vector<CurvePoint>& peaks);

/// Whether a rule of the expert names the region.
bool wasAsked(const fuzzy::Expert& expert, const std::string& region);

/// `0.468 N`.
std::string newtons(double force_n);
/// `92 %`.
std::string percent(double share);
/// `125 mm`.
std::string millimeters(double depth_mm);

}  // namespace tactus::report
