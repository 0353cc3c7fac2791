// The sources that a bundle holds for programs without libtactus: C and JavaScript, of the force and of the tube.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/exchange/origin.h"
#include "core/fuzzy/force_model.h"
#include "core/render/tube_checks.h"

namespace tactus::bundle {

struct SourceFile {
  enum class Gives { kNothing, kForce, kTube };  ///< a header gives nothing by itself

  std::string path;  ///< in the bundle: `c/tube.c`
  std::string kind;
  std::string bytes;
  Gives gives = Gives::kNothing;
};

/// All of a model, in the order of the bundle.
struct Sources {
  std::vector<SourceFile> files;
  std::vector<std::string> warnings;  ///< what is left out, and why
};
Sources sourcesOf(const fuzzy::ForceModel& model, const exchange::Origin& origin);

/// The scripted insertions of a model, and what the renderer of this program makes of them; nothing where a model has
/// no tube.
struct FeltTraces {
  std::vector<std::string> conditions;  ///< ids
  std::vector<render::TubeTrace> traces;
  std::vector<std::vector<render::TubeFeel>> felt;  ///< of each trace, step by step
};
std::optional<FeltTraces> feltTraces(const fuzzy::ForceModel& model);

/// `trace,step,position_mm,held,dt_s,` the conditions, `force_n,depth_mm,phase,stroke`.
std::string formatTubeChecks(const FeltTraces& felt);

/// The forces at `points` of a file that gives them, or step by step of all traces one after the other: by the C
/// compiler `cc` of this computer or by Node, in a folder that is removed. Nothing if there is no such program, or the
/// file cannot be run here.
std::optional<std::vector<double>> forcesOf(const Sources& sources, const SourceFile& file,
                                            const std::vector<std::vector<double>>& points,
                                            const std::stop_token& stop = {});
std::optional<std::vector<double>> forcesOf(const Sources& sources, const SourceFile& file, const FeltTraces& felt,
                                            const std::stop_token& stop = {});

}  // namespace tactus::bundle
