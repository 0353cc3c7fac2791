// The method study in words: what a factor is, and one sentence that says whether the choice matters here.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elicitation/model/method_study.h"

namespace tactus::elicitation {

/// `Shapes of the terms`, `Fuzziness m of the clusters`; the factor itself if it is unknown.
std::string factorTitle(std::string_view factor);

/// One sentence: whether another choice is felt, which one moves the force most, and by how much. `factor`: of `study`.
std::string factorSentence(const MethodStudy& study, const MethodFactor& factor);

/// The same in a few words, for a table that has the numbers beside it: `No: even "median" is felt nowhere.`
std::string factorVerdict(const MethodStudy& study, const MethodFactor& factor);

/// Indices of the factors, those that matter first, of them the largest effect; what cannot be compared comes last.
std::vector<std::size_t> factorsByEffect(const MethodStudy& study);

}  // namespace tactus::elicitation
