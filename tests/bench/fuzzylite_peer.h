// fuzzylite (Rada-Vilela 2017) as a peer: present where it was installed when this was built.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/fuzzy/force_model.h"

namespace tactus::bench {

/// Its version, or that it is missing.
std::string fuzzyliteVersion();

/// Forces at points given row by row.
using PeerEvaluator = std::function<void(std::span<const double> rows, std::span<double> out)>;

/// The first expert of `model` in fuzzylite: an engine built once; for each point the input values are set, the engine
/// processes and the output value is read. `resolution`: the samples of its centroid. Empty where fuzzylite is not
/// installed. Trapezoids and triangles only.
PeerEvaluator fuzzylitePeer(const fuzzy::ForceModel& model, int resolution);

}  // namespace tactus::bench
