#include "elicitation/model/method_words.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using base::formatFixed;

constexpr std::pair<std::string_view, std::string_view> kTitles[] = {
    {"shapes", "Shapes of the terms"},
    {"implication", "Implication"},
    {"depths", "Depths of the regions"},
    {"alpha", "Core of the speed terms (alpha)"},
    {"m", "Fuzziness of the clusters (m)"},
    {"trim", "Trimming of slow samples"},
    {"centres", "Centers of the speed terms"},
    {"averaging", "Averaging of the speed terms"},
    {"terms", "Whose speed terms"},
    {"force_terms", "Force terms from the judgements"},
    {"weights", "Weights of the experts"},
};

/// A share as percent that is never rounded to nothing.
std::string percentText(double share) {
  if (share > 0 && share < 0.0005) return "less than 0.1 %";
  return formatFixed(100 * share, 1) + " %";
}

std::string whyNot(const MethodStudy& study, const MethodFactor& factor) {
  const auto first = std::find_if(study.variants.begin(), study.variants.end(),
                                  [&](const MethodVariant& one) { return one.factor == factor.factor; });
  return first == study.variants.end() ? "nothing was tried" : first->unavailable;
}

std::string effectOf(const MethodVariant& one) {
  return formatFixed(one.rms_n, 3) + " N rms, " + formatFixed(one.rms_noticeable, 2) +
         " just-noticeable differences; at most " + formatFixed(one.largest_n, 3) + " N";
}

}  // namespace

std::string factorTitle(std::string_view factor) {
  const auto* const found =
      std::find_if(std::begin(kTitles), std::end(kTitles), [&](const auto& one) { return one.first == factor; });
  return std::string(found == std::end(kTitles) ? factor : found->second);
}

std::string factorVerdict(const MethodStudy& study, const MethodFactor& factor) {
  if (!factor.worst) return "Cannot be compared: " + whyNot(study, factor) + '.';
  const MethodVariant& worst = study.variants[*factor.worst];
  if (worst.largest_n == 0 && worst.only_one_share == 0) return "No: no other choice moves the force.";
  const std::string gaps = worst.only_one_share > 0
                               ? " At " + percentText(worst.only_one_share) + " only one of them gives a force."
                               : std::string();
  if (factor.matters)
    return "Yes: \"" + worst.value + "\" is felt at " + percentText(worst.noticeable_share) + '.' + gaps;
  const std::string where =
      worst.noticeable_share > 0 ? "at only " + percentText(worst.noticeable_share) : std::string("nowhere");
  return "No: even \"" + worst.value + "\" is felt " + where + '.' + gaps;
}

std::string factorSentence(const MethodStudy& study, const MethodFactor& factor) {
  if (!factor.worst) return "Cannot be compared here: " + whyNot(study, factor) + '.';
  const MethodVariant& worst = study.variants[*factor.worst];
  if (worst.largest_n == 0 && worst.only_one_share == 0) {
    return "Does not matter here: no other choice moves the force.";
  }
  const std::string instead = "\"" + worst.value + "\" instead of \"" + factor.unchanged + "\"";
  const std::string gaps = worst.only_one_share > 0
                               ? " At " + percentText(worst.only_one_share) + " only one of the two gives a force."
                               : std::string();
  if (factor.matters) {
    return "Matters here: " + instead + " is felt at " + percentText(worst.noticeable_share) + " of the input space (" +
           effectOf(worst) + ")." + gaps;
  }
  const std::string where = worst.noticeable_share > 0
                                ? "at only " + percentText(worst.noticeable_share) + " of the input space"
                                : std::string("at none of the points");
  return "Does not matter here: even " + instead + " is felt " + where + " (" + effectOf(worst) + ")." + gaps;
}

std::vector<std::size_t> factorsByEffect(const MethodStudy& study) {
  std::vector<std::size_t> order(study.factors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto effect = [&](std::size_t index) {
    const MethodFactor& factor = study.factors[index];
    return std::pair(factor.matters, factor.worst ? study.variants[*factor.worst].rms_noticeable : -1.0);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return effect(a) > effect(b); });
  return order;
}

}  // namespace tactus::elicitation
