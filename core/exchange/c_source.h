// A model as C99 source without any library: the rules are folded in, nothing is read at run time.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

struct CSource {
  std::string header;  ///< force_model.h
  std::string source;  ///< force_model.c
};

/// The source of a valid model. Its forces agree with the evaluator to 1e-12 of the output's range, `fired` exactly.
/// Refused with one sentence: an output term that is a Gaussian.
base::Result<CSource> cSource(const fuzzy::ForceModel& model);

}  // namespace tactus::exchange
