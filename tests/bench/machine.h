// On what the benchmark ran.
#pragma once

#include <string>
#include <vector>

namespace tactus::bench {

/// Processor, compiler, build type, and the instruction set that the evaluators use.
std::vector<std::string> machineLines();

}  // namespace tactus::bench
