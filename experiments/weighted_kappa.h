// Agreement of two series of ordered answers beyond chance.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace tactus::experiments {

/// Cohen's kappa with quadratic weights (Cohen 1968; Fleiss and Cohen 1973) of pairs of categories by their place from
/// 0: 1 - (sum of squared differences) / (the same as chance would have it, from the shares of both sides). Nothing
/// where there are no pairs, or where all answers are one category and chance cannot differ.
std::optional<double> quadraticWeightedKappa(std::span<const std::pair<std::size_t, std::size_t>> pairs);

}  // namespace tactus::experiments
