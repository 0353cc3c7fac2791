#include "core/fuzzy/model_checks.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

using base::ErrorCode;
using base::fail;
using base::formatNumber;
using base::quoted;
using base::Result;

namespace {

// A Gaussian output term weaker than this in the whole universe has no area that a double can hold.
constexpr double kFaintest = 1e-250;
constexpr std::size_t kLongestId = 64;

Result<void> checkId(const std::string& id, const Place& place) {
  const bool control = std::any_of(id.begin(), id.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
  if (!id.empty() && id.size() <= kLongestId && !control && base::trimmed(id) == id) return {};
  return fail(ErrorCode::kValue, place.text(), id.empty() ? "an empty id" : quoted(id),
              "an id of 1 to 64 bytes without control characters and without spaces at its ends");
}

Result<void> checkPoints(const Term& term, const Place& place) {
  const auto shape = [&term] { return std::string(name(term.shape)); };
  if (term.points.size() != pointCount(term.shape)) {
    return fail(ErrorCode::kSchema, place.text(), std::to_string(term.points.size()) + " numbers",
                std::to_string(pointCount(term.shape)) + " for a " + shape());
  }
  for (std::size_t i = 0; i < term.points.size(); ++i) {
    if (!isWithin(term.points[i], -kLargest, kLargest)) {
      return checkNumber(term.points[i], -kLargest, kLargest, place[i]);
    }
  }
  if (term.shape == Shape::kGaussian) {
    if (term.points[1] >= kNarrowest) return {};
    return fail(ErrorCode::kValue, place[1].text(), "sigma " + formatNumber(term.points[1]), "sigma > 0");
  }
  for (std::size_t i = 1; i < term.points.size(); ++i) {
    if (term.points[i] < term.points[i - 1]) {
      return fail(ErrorCode::kValue, place[i].text(),
                  formatNumber(term.points[i]) + " after " + formatNumber(term.points[i - 1]),
                  "the points of a " + shape() + " in ascending order");
    }
  }
  return {};
}

/// An output term must cover some area of the universe, or its centroid would be 0/0.
Result<void> checkMeetsUniverse(const Term& term, const Variable& output, const Place& place) {
  const auto f = MembershipFunction::of(term);
  const bool meets = f.gaussian ? f(std::clamp(f.mean, output.min, output.max)) >= kFaintest
                                : std::min(f.d, output.max) > std::max(f.a, output.min);
  if (meets) return {};
  return fail(
      ErrorCode::kValue, place.text(), "an output term without area in its universe",
      "a term that meets [" + formatNumber(output.min) + ", " + formatNumber(output.max) + "] in positive width");
}

}  // namespace

Result<void> checkNumber(double value, double min, double max, const Place& place) {
  if (isWithin(value, min, max)) return {};
  return fail(ErrorCode::kValue, place.text(), formatNumber(value),
              "a number in [" + formatNumber(min) + ", " + formatNumber(max) + "]");
}

Result<void> checkCount(std::size_t count, std::size_t most, std::string_view what, const Place& place) {
  if (count >= 1 && count <= most) return {};
  return fail(count == 0 ? ErrorCode::kSchema : ErrorCode::kLimit, place.text(),
              std::to_string(count) + " " + std::string(what), "1 to " + std::to_string(most));
}

Result<void> checkUnique(NameList& seen, const std::string& id, const Place& place) {
  if (auto ok = checkId(id, place); !ok) return ok;
  if (seen.find(id)) return fail(ErrorCode::kSchema, place.text(), quoted(id) + " twice", "each id once");
  seen.add(id);
  return {};
}

Result<void> checkTerms(const std::vector<Term>& terms, const Variable* output, const Place& place) {
  if (auto ok = checkCount(terms.size(), kMostTerms, "terms", place); !ok) return ok;
  NameList ids;
  ids.reserve(terms.size());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Place at = place[i];
    if (auto ok = checkUnique(ids, terms[i].id, at["id"]); !ok) return ok;
    if (auto ok = checkPoints(terms[i], at["points"]); !ok) return ok;
    if (output == nullptr) continue;
    if (auto ok = checkMeetsUniverse(terms[i], *output, at["points"]); !ok) return ok;
  }
  return {};
}

}  // namespace tactus::fuzzy
