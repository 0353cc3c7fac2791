// The insertion renderer (core/render) as a source without any library, beside the force of the model (c_source.h,
// js_source.h): the same recurrences with the model's parameters folded in. docs/renderer.md numbers them.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/exchange/origin.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

struct TubeSource {
  std::string header;  ///< tube.h
  std::string source;  ///< tube.c, which asks force_model.c
};

/// C99, with its origin in the head. Every bit is that of libtactus where the bits of force_model.c are. Refused: a
/// model that has no tube (render::tubeInputs).
base::Result<TubeSource> cTube(const fuzzy::ForceModel& model, const Origin& origin = {});

/// Plain JavaScript, a module for Node and a script for a page: tube.js, which asks force_model.js. Refused as cTube.
base::Result<std::string> jsTube(const fuzzy::ForceModel& model, const Origin& origin = {});

}  // namespace tactus::exchange
