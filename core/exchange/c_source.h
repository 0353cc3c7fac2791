// A model as C99 source without any library: the rules are folded in, nothing is read at run time.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/exchange/origin.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

struct CSource {
  std::string header;  ///< force_model.h
  std::string source;  ///< force_model.c
};

/// An input that stays at a value, clamped to its universe.
struct FixedInput {
  std::size_t input = 0;
  double value = 0;
};

/// The source of a valid model. Its forces agree with the evaluator to 1e-12 of the output's range, `fired` exactly.
/// The memberships of the `fixed` inputs are folded in: the source takes the other inputs alone, in the order of the
/// model. The header names the `origin`, with the checksum as FORCE_MODEL_SHA256. Refused: a value that is not finite,
/// an input fixed twice, all inputs fixed.
base::Result<CSource> cSource(const fuzzy::ForceModel& model, std::span<const FixedInput> fixed = {},
                              const Origin& origin = {});

}  // namespace tactus::exchange
