// The C source of a model, compiled and loaded.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/exchange/c_source.h"

namespace tactus::bench {

struct LoadedSource {
  double (*force)(const double* inputs, int* fired);
  void (*batch)(const double* inputs, std::size_t points, double* force, unsigned char* fired);
};

/// Compiles with `compiler`, a command with its options. Nothing where that fails. The code stays loaded to the end.
std::optional<LoadedSource> loadSource(const exchange::CSource& source, const std::string& compiler);

}  // namespace tactus::bench
