#include <algorithm>

#include "app/report/claim_parts.h"

namespace tactus::report {

namespace {

Verdict verdictFor(const Profile& profile) {
  Verdict verdict{
      .subject = profile.subject, .holds = std::nullopt, .basis = profile.basis, .numbers = {}, .reason = {}};
  if (profile.curve.empty()) verdict.reason = "No rule fires at this setting.";
  return verdict;
}

/// The first rise of a curve that is followed by a drop, both at least kVisibleN.
struct Bump {
  CurvePoint before, top, after;
  bool risen = false;
  bool dropped = false;
};

Bump firstBump(const ForceCurve& curve) {
  Bump bump{curve.front(), curve.front(), curve.front()};
  for (const CurvePoint& point : curve) {
    const double force_n = *point.force_n;
    if (!bump.risen) {
      if (force_n < *bump.before.force_n) bump.before = point;
      bump.risen = force_n - *bump.before.force_n >= kVisibleN;
      if (bump.risen) bump.top = bump.after = point;
    } else if (!bump.dropped && force_n > *bump.top.force_n) {
      bump.top = bump.after = point;
    } else if (force_n < *bump.after.force_n) {
      bump.after = point;
      bump.dropped = bump.dropped || *bump.top.force_n - force_n >= kVisibleN;
    } else if (bump.dropped && force_n - *bump.after.force_n >= kVisibleN) {
      break;
    }
  }
  return bump;
}

/// Why the force is constant in the nasal cavity, if its term is a shoulder from the start.
std::string shoulderReason(const ClaimContext& context, const Profile& profile) {
  const fuzzy::Variable& depth = context.input("depth");
  const auto& terms = profile.expert ? fuzzy::termsFor(context.model.experts[*profile.expert], depth) : depth.terms;
  const fuzzy::Term* nasal = fuzzy::findTerm(terms, "nasal_cavity");
  if (nasal == nullptr || nasal->shape != fuzzy::Shape::kTrapezoid || nasal->points[1] > depth.min) return {};
  return "The membership function of the nasal cavity is a shoulder: 1 from " + millimeters(depth.min) + " to " +
         millimeters(nasal->points[2]) + ", so there the force cannot change with depth.";
}

Verdict nasalBump(const ClaimContext& context, const Profile& profile) {
  Verdict verdict = verdictFor(profile);
  if (profile.curve.empty()) return verdict;
  const double nasal_end_mm = regionOf(context.regions, "nasal_cavity").to_mm;
  const Bump bump = firstBump(profile.curve);
  verdict.holds = bump.risen && bump.dropped && bump.top.depth_mm <= nasal_end_mm;
  if (!bump.risen) {
    verdict.numbers = "The force never rises by " + newtons(kVisibleN) + " or more.";
  } else {
    verdict.numbers = "First rise from " + newtons(*bump.before.force_n) + " at " + millimeters(bump.before.depth_mm) +
                      " to " + newtons(*bump.top.force_n) + " at " + millimeters(bump.top.depth_mm) + " (" +
                      whereabouts(context.regions, bump.top.depth_mm) + ")";
    verdict.numbers += bump.dropped ? ", then a drop to " + newtons(*bump.after.force_n) + " at " +
                                          millimeters(bump.after.depth_mm) + "."
                                    : ", no drop after it.";
  }
  if (!*verdict.holds) verdict.reason = shoulderReason(context, profile);
  return verdict;
}

Verdict oropharyngealPeak(const ClaimContext& context, const Profile& profile) {
  Verdict verdict = verdictFor(profile);
  if (profile.curve.empty()) return verdict;
  const Region& nasopharynx = regionOf(context.regions, "nasopharynx");
  const Region& oropharynx = regionOf(context.regions, "oropharynx");
  const std::vector<CurvePoint> peaks = peaksOf(profile.curve);
  const auto inside = std::find_if(peaks.begin(), peaks.end(), [&](const CurvePoint& point) {
    return point.depth_mm >= oropharynx.from_mm && point.depth_mm <= oropharynx.to_mm;
  });
  double low_n = *peaks.front().force_n;
  for (const CurvePoint& point : profile.curve) {
    if (point.depth_mm >= nasopharynx.from_mm && point.depth_mm <= peaks.front().depth_mm) {
      low_n = std::min(low_n, *point.force_n);
    }
  }
  const double rise_n = *peaks.front().force_n - low_n;
  verdict.holds = inside != peaks.end() && rise_n >= kVisibleN;
  verdict.numbers = "Peak " + peakText(context, peaks) + ", " + newtons(rise_n) +
                    " above the lowest force since the nasopharynx was reached at " + millimeters(nasopharynx.from_mm) +
                    ".";
  if (!*verdict.holds && profile.expert) {
    const fuzzy::Expert& expert = context.model.experts[*profile.expert];
    if (!wasAsked(expert, "oropharynx")) verdict.reason = "No rule of this expert is about the oropharynx.";
  }
  return verdict;
}

}  // namespace

std::vector<Claim> claimsOfProfile(const ClaimContext& context) {
  std::vector<Profile> profiles = {profileOf(context, context.published_expert), profileOf(context, std::nullopt)};
  for (std::size_t i = 0; i < context.model.experts.size(); ++i) {
    if (i != context.published_expert) profiles.push_back(profileOf(context, i));
  }
  const std::string visible = newtons(kVisibleN);
  Claim bump{"11a",
             "In the nasal cavity the force first rises, then drops slightly.",
             "Yes if the first rise of at least " + visible + " that is followed by a drop of at least " + visible +
                 " has its top inside the nasal cavity.",
             {}};
  Claim peak{"11b",
             "After the nasopharynx is reached the force rises again and peaks in the oropharynx.",
             "Yes if the largest force of the whole curve lies inside the oropharynx, limits included, at least " +
                 visible + " above the lowest force since the nasopharynx was reached.",
             {}};
  for (const Profile& profile : profiles) {
    bump.verdicts.push_back(nasalBump(context, profile));
    peak.verdicts.push_back(oropharyngealPeak(context, profile));
  }
  return {std::move(bump), std::move(peak)};
}

}  // namespace tactus::report
