// Does a choice of the method matter here? The averaged model under other choices, one at a time, in newtons.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "elicitation/model/model_builder.h"

namespace tactus::elicitation {

/// The averaged model with one choice changed, against the model with none changed. Forces are compared where both give
/// one.
struct MethodVariant {
  std::string factor;         ///< `shapes`, `implication`, `depths`, `alpha`, `m`, `trim`, `centres`, `averaging`, …
  std::string value;          ///< e.g. `0.9`, `scale`, `thresholds`
  std::string unavailable;    ///< why the data do not allow it; then only factor and value are set
  double rms_n = 0;           ///< root mean square over the points of the box
  double rms_noticeable = 0;  ///< the same in just-noticeable differences at the unchanged force
  double largest_n = 0;       ///< over the box and, without Gaussians, the combinations of vertices; a lower bound
  double largest_noticeable = 0;
  std::vector<double> at;       ///< point of largest_n; empty if the forces are equal
  double noticeable_share = 0;  ///< share of the box where the difference is above one just-noticeable difference
  double only_one_share = 0;    ///< share of the box where only one of the models gives a force
};

/// One choice and the largest effect of its values.
struct MethodFactor {
  std::string factor;
  std::string unchanged;             ///< its value in the settings
  std::optional<std::size_t> worst;  ///< index of the variant with the largest rms_noticeable; nothing without any
  bool matters = false;              ///< that variant is noticeable at more than kMattersShare of the box
};

/// A choice matters if it is felt at more than this share of the input space.
inline constexpr double kMattersShare = 0.05;

struct MethodStudy {
  std::vector<MethodVariant> variants;
  std::vector<MethodFactor> factors;  ///< in the order of the variants
  std::size_t points = 0;             ///< of the box
};

struct MethodStudyRun {
  std::stop_token stop;
  std::function<void(double share_done)> progress;  ///< called in the thread of the call
  /// Choices that are compared; empty: all.
  std::function<bool(std::string_view factor)> wanted = {};
  /// An earlier result for the same arguments: what it has is not compared again. May be null.
  const MethodStudy* known = nullptr;
};

/// Compares shapes of the terms (triangles, Gaussians), implication, the depths of the regions (template, measured),
/// alpha, m, trimming, centers, averaging, whose speed terms, force terms (vote, frequency, thresholds) and weights
/// with the model of `settings`, one at a time. `built`: from `study` with `settings`. A choice that has no data
/// (speeds, judgements, weights) is not tried, or says why it cannot be made. Four participants take a few seconds.
/// Returns kCancelled after a stop request. Thread: any; works on several (base::spareThreads).
base::Result<MethodStudy> methodStudy(const study::Study& study, std::span<const study::Form> forms,
                                      const BuildSettings& settings, const BuiltModel& built,
                                      const MethodStudyRun& run = {});

/// The model of one variant of `methodStudy` with the same arguments. Returns why the data do not allow it.
base::Result<fuzzy::ForceModel> methodModel(const study::Study& study, std::span<const study::Form> forms,
                                            const BuildSettings& settings, const BuiltModel& built,
                                            const MethodVariant& variant);

/// What replacing `unchanged` by `changed` does, over the same points as `methodStudy`; factor and value stay empty.
/// Both have the same inputs. Returns the error of `fuzzy::compile`.
base::Result<MethodVariant> methodDifference(const fuzzy::ForceModel& unchanged, const fuzzy::ForceModel& changed);

// The method study in words: what a factor is, and one sentence that says whether the choice matters here.

/// `Shapes of the terms`, `Fuzziness m of the clusters`; the factor itself if it is unknown.
std::string factorTitle(std::string_view factor);

/// One sentence: whether another choice is felt, which one moves the force most, and by how much. `factor`: of `study`.
std::string factorSentence(const MethodStudy& study, const MethodFactor& factor);

/// The same in a few words, for a table that has the numbers beside it: `No: even "median" is felt nowhere.`
std::string factorVerdict(const MethodStudy& study, const MethodFactor& factor);

/// Indices of the factors, those that matter first, of them the largest effect; what cannot be compared comes last.
std::vector<std::size_t> factorsByEffect(const MethodStudy& study);

}  // namespace tactus::elicitation
