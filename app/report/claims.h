// The claims checklist: the paper's statements about its Fig. 10 and 11 (section 3.4), checked on a model, yes or no.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/report/force_curves.h"
#include "app/report/regions.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::report {

/// Smallest difference that counts in an order, N. Equal forces come from equal rules.
inline constexpr double kTieN = 1e-6;
/// A statement about a whole curve holds if it holds at this share of the depths and on average.
inline constexpr double kEnoughDepths = 0.9;
/// A smaller rise or drop (1 % of the force universe) would not be visible in a figure, N.
inline constexpr double kVisibleN = 0.01;
/// Profiles are similar if their correlation over the regions is at least this.
inline constexpr double kSimilarCorrelation = 0.7;

using elicitation::justNoticeableDifference;

/// The origin of the data behind a verdict.
enum class ClaimBasis {
  kPublishedRules,  ///< rules printed in the paper
  kSimulated,       ///< answers simulated to follow the paper's text
  kByConstruction,  ///< mixes published rules with answers simulated to follow the text
};

/// A statement checked on one subject.
struct Verdict {
  std::string subject;        ///< expert's id, `mean`, `all experts`
  std::optional<bool> holds;  ///< nothing: the statement does not apply to this subject
  ClaimBasis basis = ClaimBasis::kByConstruction;
  std::string numbers;  ///< the computed numbers
  std::string reason;   ///< why it does not hold, if known; else empty
};

struct Claim {
  std::string id;         ///< `10a` to `10c`, `11a` to `11f`
  std::string statement;  ///< the paper's statement in our words
  std::string rule;       ///< the decision rule
  std::vector<Verdict> verdicts;
};

/// The roles of the experts in the model.
struct ClaimSubjects {
  std::string published_expert = "S4";     ///< the expert whose rules the paper prints
  std::string highest_peak_expert = "S2";  ///< the expert whose peak is the highest according to the paper
};

/// A setting of the paper's figures: the values of all its inputs but the depth.
struct PaperSetting {
  double lubrication = 1;       ///< 0 to 1
  double neck_flexion_deg = 0;  ///< 0 to 90
  double speed_mm_s = 0;
};
/// The same as a point of `model`, whose inputs are the paper's, in any order; 0 on the way.
std::vector<double> pointAt(const fuzzy::ForceModel& model, const PaperSetting& setting);

/// Setting of Fig. 11: lubrication 1, neck flexion 60 deg, 50 mm/s.
inline constexpr PaperSetting kFig11{1, 60, 50};

/// All statements in the order of the paper: for the published expert, for the mean, and for each expert if the paper
/// speaks of all of them. Refused: a model without the four inputs of the study, or without the published expert.
base::Result<std::vector<Claim>> checkClaims(const fuzzy::ForceModel& model, const ClaimSubjects& subjects);

// Shared parts of the statements about Fig. 10 and Fig. 11. Internal to the checklist.

/// A model with the data from which the statements are computed.
struct ClaimContext {
  const fuzzy::ForceModel& model;
  const ForceCurves& curves;
  std::vector<Region> regions;
  std::size_t published_expert = 0;
  std::string highest_peak_expert;

  const fuzzy::Variable& input(std::string_view id) const;
  ForceCurve curve(const PaperSetting& setting, std::optional<std::size_t> expert) const {
    return curves.curve(pointAt(model, setting), expert);
  }
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
