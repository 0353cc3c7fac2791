#include "core/fuzzy/model_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

using base::ErrorCode;
using base::formatNumber;

namespace {

// A Gaussian output term weaker than this in the whole universe has no area that a double can hold.
constexpr double kFaintest = 1e-250;
constexpr std::size_t kLongestId = 64;

Problem checkId(const std::string& id, const Place& place) {
  const bool control = std::any_of(id.begin(), id.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
  if (!id.empty() && id.size() <= kLongestId && !control && id.front() != ' ' && id.back() != ' ') return nullptr;
  return problem(ErrorCode::kValue, place, id.empty() ? "an empty id" : base::quoted(id),
                 "an id of 1 to 64 bytes without control characters and without spaces at its ends");
}

Problem checkPoints(const Term& term, const Place& place) {
  const auto shape = [&term] { return std::string(name(term.shape)); };
  if (term.points.size() != pointCount(term.shape)) {
    return problem(ErrorCode::kSchema, place, std::to_string(term.points.size()) + " numbers",
                   std::to_string(pointCount(term.shape)) + " for a " + shape());
  }
  for (std::size_t i = 0; i < term.points.size(); ++i) {
    if (!isWithin(term.points[i], -kLargest, kLargest)) {
      return checkNumber(term.points[i], -kLargest, kLargest, place[i]);
    }
  }
  if (term.shape == Shape::kGaussian) {
    if (term.points[1] >= kNarrowest) return nullptr;
    return problem(ErrorCode::kValue, place[1], "sigma " + formatNumber(term.points[1]), "sigma > 0");
  }
  for (std::size_t i = 1; i < term.points.size(); ++i) {
    if (term.points[i] < term.points[i - 1]) {
      return problem(ErrorCode::kValue, place[i],
                     formatNumber(term.points[i]) + " after " + formatNumber(term.points[i - 1]),
                     "the points of a " + shape() + " in ascending order");
    }
  }
  return nullptr;
}

/// An output term must cover some area of the universe, or its centroid would be 0/0.
Problem checkMeetsUniverse(const Term& term, const Variable& output, const Place& place) {
  const auto f = MembershipFunction::of(term);
  const bool meets = f.gaussian ? f(std::clamp(f.mean, output.min, output.max)) >= kFaintest
                                : std::min(f.d, output.max) > std::max(f.a, output.min);
  if (meets) return nullptr;
  return problem(
      ErrorCode::kValue, place, "an output term without area in its universe",
      "a term that meets [" + formatNumber(output.min) + ", " + formatNumber(output.max) + "] in positive width");
}

}  // namespace

Problem problem(ErrorCode code, const Place& place, std::string found, std::string wanted) {
  return std::make_unique<base::Error>(base::Error{code, {}, place.text(), std::move(found), std::move(wanted)});
}

Problem checkNumber(double value, double min, double max, const Place& place) {
  if (isWithin(value, min, max)) return nullptr;
  return problem(ErrorCode::kValue, place, formatNumber(value),
                 "a number in [" + formatNumber(min) + ", " + formatNumber(max) + "]");
}

Problem checkCount(std::size_t count, std::size_t most, std::string_view what, const Place& place) {
  if (count >= 1 && count <= most) return nullptr;
  return problem(count == 0 ? ErrorCode::kSchema : ErrorCode::kLimit, place,
                 std::to_string(count) + " " + std::string(what), "1 to " + std::to_string(most));
}

Problem checkUnique(NameList& seen, const std::string& id, const Place& place) {
  if (auto wrong = checkId(id, place)) return wrong;
  if (seen.add(id)) return nullptr;
  return problem(ErrorCode::kSchema, place, base::quoted(id) + " twice", "each id once");
}

Problem checkTerms(const std::vector<Term>& terms, const Variable* output, const Place& place, NameList& names) {
  if (auto wrong = checkCount(terms.size(), kMostTerms, "terms", place)) return wrong;
  names.clear();
  names.reserve(terms.size());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Place at = place[i];
    if (auto wrong = checkUnique(names, terms[i].id, at["id"])) return wrong;
    if (auto wrong = checkPoints(terms[i], at["points"])) return wrong;
    if (output == nullptr) continue;
    if (auto wrong = checkMeetsUniverse(terms[i], *output, at["points"])) return wrong;
  }
  return nullptr;
}

}  // namespace tactus::fuzzy
