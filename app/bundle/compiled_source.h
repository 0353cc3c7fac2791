// The C source of a bundle, compiled and run: what its forces really are.
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/exchange/c_source.h"

namespace tactus::bundle {

/// The forces of `force_model` at `points`, computed by a program made of `source` with the C compiler `cc` of this
/// computer, in a folder that is removed. Nothing if there is no compiler, or it cannot be run here.
std::optional<std::vector<double>> forcesOf(const exchange::CSource& source,
                                            const std::vector<std::vector<double>>& points,
                                            const std::stop_token& stop = {});

}  // namespace tactus::bundle
