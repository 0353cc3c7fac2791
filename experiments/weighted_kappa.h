// Agreement of two series of ordered answers beyond chance.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace tactus::experiments {

/// Cohen's kappa with quadratic weights (Cohen 1968; Fleiss and Cohen 1973): 1 - (sum of squared differences) / (the
/// same sum expected by chance from the shares of both sides). `pairs`: indices of categories from 0. Nothing if there
/// are no pairs, or if all answers are one category.
std::optional<double> quadraticWeightedKappa(std::span<const std::pair<std::size_t, std::size_t>> pairs);

}  // namespace tactus::experiments
