#include "app/report/claims.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::report {
namespace {

// The inputs of the paper.
constexpr std::string_view kLubrication = "lubrication";
constexpr std::string_view kNeckFlexion = "neck_flexion";
constexpr std::string_view kDepth = "depth";
constexpr std::string_view kSpeed = "speed";

base::Result<void> requirePaperInputs(const fuzzy::ForceModel& model) {
  constexpr std::array kInputs = {kLubrication, kNeckFlexion, kDepth, kSpeed};
  const std::string wanted = "the four inputs lubrication, neck_flexion, depth and speed";
  if (model.inputs.size() != kInputs.size()) {
    return base::fail(base::ErrorCode::kSchema, "/inputs", std::to_string(model.inputs.size()) + " inputs", wanted);
  }
  for (const std::string_view id : kInputs) {
    if (std::none_of(model.inputs.begin(), model.inputs.end(), [id](const auto& input) { return input.id == id; }))
      return base::fail(base::ErrorCode::kReference, "/inputs", "no input " + base::quoted(id), wanted);
  }
  return {};
}

}  // namespace

std::string newtons(double force_n) { return base::formatFixed(force_n, 3) + " N"; }

std::string percent(double share) { return base::formatFixed(100 * share, 0) + " %"; }

std::string millimeters(double depth_mm) { return base::formatFixed(depth_mm, 0) + " mm"; }

const fuzzy::Variable& ClaimContext::input(std::string_view id) const {
  const fuzzy::Variable* found = nullptr;
  for (const fuzzy::Variable& variable : model.inputs) {
    if (variable.id == id) found = &variable;
  }
  TACTUS_CHECK(found != nullptr);
  return *found;
}

std::vector<double> pointAt(const fuzzy::ForceModel& model, const PaperSetting& setting) {
  std::vector<double> point;
  for (const fuzzy::Variable& input : model.inputs) {
    point.push_back(input.id == kLubrication   ? setting.lubrication
                    : input.id == kNeckFlexion ? setting.neck_flexion_deg
                    : input.id == kSpeed       ? setting.speed_mm_s
                                               : 0);
  }
  return point;
}

bool wasAsked(const fuzzy::Expert& expert, const std::string& region) {
  const fuzzy::Condition inside{std::string(kDepth), region};
  return std::any_of(expert.rules.begin(), expert.rules.end(), [&](const fuzzy::Rule& rule) {
    return std::find(rule.conditions.begin(), rule.conditions.end(), inside) != rule.conditions.end();
  });
}

Profile profileOf(const ClaimContext& context, std::optional<std::size_t> expert) {
  Profile profile{.subject = expert ? context.model.experts[*expert].id : "mean",
                  .basis = expert ? context.basisOf(*expert) : ClaimBasis::kByConstruction,
                  .expert = expert,
                  .curve = context.curve(kFig11, expert)};
  std::erase_if(profile.curve, [](const CurvePoint& point) { return !point.force_n.has_value(); });
  return profile;
}

/// Depths at which the curve is at its largest force.
std::vector<CurvePoint> peaksOf(const ForceCurve& curve) {
  const double high_n = forceRange(curve)->high_n;
  std::vector<CurvePoint> peaks;
  for (const CurvePoint& point : curve) {
    if (high_n - *point.force_n <= kTieN) peaks.push_back(point);
  }
  return peaks;
}

std::string peakText(const ClaimContext& context, const std::vector<CurvePoint>& peaks) {
  std::string text = newtons(*peaks.front().force_n) + " at " + millimeters(peaks.front().depth_mm);
  if (peaks.size() > 1) {
    text = newtons(*peaks.front().force_n) + " from " + millimeters(peaks.front().depth_mm) + " to " +
           millimeters(peaks.back().depth_mm);
  }
  return text + " (" + whereabouts(context.regions, peaks.front().depth_mm) + ")";
}

base::Result<std::vector<Claim>> checkClaims(const fuzzy::ForceModel& model, const ClaimSubjects& subjects) {
  if (auto ok = requirePaperInputs(model); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(const auto curves, ForceCurves::of(model));
  ClaimContext context{.model = model,
                       .curves = curves,
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
  context.regions = wayRegions(*procedure::defaultProcedure(), context.input(kDepth));
  std::vector<Claim> claims = claimsOfOrder(context);
  for (Claim& claim : claimsOfProfile(context)) claims.push_back(std::move(claim));
  for (Claim& claim : claimsOfAgreement(context)) claims.push_back(std::move(claim));
  return claims;
}

}  // namespace tactus::report
