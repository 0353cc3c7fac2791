// Fuzzy C-Means as it is often written: the membership matrix is stored and filled with pow.
#pragma once

#include <cstddef>
#include <vector>

namespace tactus::bench {

/// From equal widths until no membership changes by 1e-9. Centres ascending.
std::vector<double> textbookFcm(const std::vector<double>& samples, std::size_t clusters, double m);

}  // namespace tactus::bench
