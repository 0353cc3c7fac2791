#include "elicitation/depth/insertion_length.h"

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;

// biblio.ugent.be/publication/8599660; there in cm.
constexpr double kSlope = 0.38696;
constexpr double kHansonOffsetMm = 303.7;
constexpr double kCorrectedOffsetMm = 363.7;
constexpr DepthRange kBeyondSphincterMm{30, 100};

double lengthBy(LengthFormula formula, double nex_mm) {
  switch (formula) {
    case LengthFormula::kNoseEarXiphoid: return nex_mm;
    case LengthFormula::kHanson: return kSlope * nex_mm + kHansonOffsetMm;
    case LengthFormula::kCorrected: return kSlope * nex_mm + kCorrectedOffsetMm;
  }
  return nex_mm;
}

}  // namespace

std::string_view name(LengthFormula formula) noexcept {
  switch (formula) {
    case LengthFormula::kNoseEarXiphoid: return "nose_ear_xiphoid";
    case LengthFormula::kHanson: return "hanson";
    case LengthFormula::kCorrected: return "corrected";
  }
  return "";
}

DepthRange targetDepth(double scale, double sphincter_mm) {
  return {sphincter_mm * scale + kBeyondSphincterMm.from_mm, sphincter_mm * scale + kBeyondSphincterMm.to_mm};
}

base::Result<std::vector<InsertionLength>> insertionLengths(double nex_mm, double scale, double sphincter_mm) {
  if (!(scale >= 0.5 && scale <= 2)) {
    return fail(ErrorCode::kValue, "anatomical scale", base::formatNumber(scale), "a factor from 0.5 to 2");
  }
  if (!(nex_mm >= kNoseEarXiphoidMm.from_mm && nex_mm <= kNoseEarXiphoidMm.to_mm)) {
    return fail(ErrorCode::kValue, "nose-ear-xiphoid length", base::formatNumber(nex_mm) + " mm",
                "a length of adults, " + base::formatNumber(kNoseEarXiphoidMm.from_mm) + " to " +
                    base::formatNumber(kNoseEarXiphoidMm.to_mm) + " mm");
  }
  const DepthRange target = targetDepth(scale, sphincter_mm);
  std::vector<InsertionLength> out;
  for (const auto formula : {LengthFormula::kNoseEarXiphoid, LengthFormula::kHanson, LengthFormula::kCorrected}) {
    const double length_mm = lengthBy(formula, nex_mm);
    out.push_back({formula, length_mm, length_mm - sphincter_mm * scale,
                   length_mm >= target.from_mm && length_mm <= target.to_mm});
  }
  return out;
}

}  // namespace tactus::elicitation
