// Simulated strokes to cluster, and where the textbook iteration stands still on them.
#pragma once

#include <cstddef>
#include <vector>

namespace tactus::bench {

/// Speeds in mm/s of twelve simulated strokes, four for each of three levels, sampled evenly: bell-shaped speed
/// profiles with the means of the paper's Table 1 for S1, strokes that differ, and noise of 2 mm/s. No person made
/// them.
std::vector<double> simulatedStrokes(std::size_t samples);

/// Centres of the fixed point of the textbook iteration in long double.
std::vector<long double> referenceCentres(const std::vector<double>& samples, std::size_t clusters, double m);

/// The largest distance of a centre from the reference; infinite for another number of centres.
double largestError(std::vector<double> centres, const std::vector<long double>& reference);

}  // namespace tactus::bench
