#include "tests/bench/machine.h"

#include <fstream>

#if __has_include("core/fuzzy/instruction_set.h")
#include "core/fuzzy/instruction_set.h"
#endif

namespace tactus::bench {
namespace {

/// The first `model name` of /proc/cpuinfo.
std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string instructionSet() {
#if __has_include("core/fuzzy/instruction_set.h")
  return std::string(fuzzy::activeInstructionSet());
#else
  return "plain";
#endif
}

}  // namespace

std::vector<std::string> machineLines() {
  return {"Processor: " + processorName(), "Instruction set of our evaluators: " + instructionSet(),
          "Compiler: " + std::string(TACTUS_COMPILER) + ", build type " + TACTUS_BUILD_TYPE};
}

}  // namespace tactus::bench
