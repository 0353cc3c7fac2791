// The sources that a bundle holds for programs without libtactus: C and JavaScript, of the force and of the tube.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
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

/// What the sources give, by the C compiler `cc` of this computer and by Node, in a folder that is removed. All of a
/// language run once, when one of them is first asked for. `sources`, `points` and `felt` outlive this.
class SourceRuns {
 public:
  SourceRuns(const Sources& sources, const std::vector<std::vector<double>>& points,
             const std::optional<FeltTraces>& felt, std::stop_token stop = {})
      : sources_(sources), points_(points), felt_(felt), stop_(std::move(stop)) {}

  /// The forces of a file that gives them, at the points or step by step of all traces one after the other. Nothing if
  /// there is no such program, or the sources cannot be run here.
  std::optional<std::span<const double>> of(const SourceFile& file);

  const std::vector<std::vector<double>>& points() const { return points_; }
  /// Something where there is a tube.
  const std::optional<FeltTraces>& felt() const { return felt_; }

 private:
  const Sources& sources_;
  const std::vector<std::vector<double>>& points_;
  const std::optional<FeltTraces>& felt_;
  std::stop_token stop_;
  std::map<std::string, std::optional<std::vector<double>>> forces_;  ///< of each language
};

}  // namespace tactus::bundle
