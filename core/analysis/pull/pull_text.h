// What a pull finds, in words: the same on the command line and in the window.
#pragma once

#include <cstddef>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/analysis/lint.h"
#include "core/analysis/pull/pull.h"
#include "core/analysis/pull/pull_curve.h"

namespace tactus::analysis {

/// `Insertion depth, Laryngopharynx/Esophagus: the transition ends at 202.107 instead of 215.000 mm`. `model`: before
/// the edit.
std::string editText(const fuzzy::ForceModel& model, const PullEdit& edit);

/// Several edits, made one after the other. `model`: before all of them.
std::string editsText(const fuzzy::ForceModel& model, std::span<const PullEdit> edits);

/// `laryngopharynx/esophagus` for a ramp, `laryngopharynx` for a term: ids.
std::string gapOf(const fuzzy::ForceModel& model, const PullEdit& edit);

/// `elsewhere it moves the force by 0.090 just-noticeable differences, at most 0.159 N`.
std::string elsewhereText(const PullCandidate& candidate);

/// The experts whose rules get another word or are taken away, each once.
std::vector<std::string> contradicted(const PullCandidate& candidate);
/// `; contradicts S4's answer` where there are any; otherwise nothing.
std::string contradictionText(const PullCandidate& candidate);

/// The edits of a candidate; for one that does not give the target also the force it gives. `model`: before the edits.
std::string outcomeText(const fuzzy::ForceModel& model, const PullCandidate& candidate);
/// The same with what is left to a reference curve; `5 edits give the same curve` where it does not tell them apart.
std::string outcomeText(const fuzzy::ForceModel& model, const CurveCandidate& candidate);

/// `outcomeText` with `contradictionText`.
std::string candidateText(const fuzzy::ForceModel& model, const PullCandidate& candidate);
std::string candidateText(const fuzzy::ForceModel& model, const CurveCandidate& candidate);

/// Why no single edit gives the target, as a clause: `beyond the nearest edit Laryngopharynx would have no core`.
std::string blockerText(const fuzzy::ForceModel& model, const Pull& pull);
/// What stays in the way of a reference curve, as a clause; empty if an edit comes close.
std::string blockerText(const CurvePull& pull);

/// The best candidate of each kind, at most three, by their places in the list; without a plausible one the first.
std::vector<std::size_t> bestOfEachKind(std::span<const PullCandidate> candidates);

/// What the lint finds in a model after an edit and not before. Thread: any.
class NewFindings {
 public:
  NewFindings(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled, const std::stop_token& stop = {});

  /// One sentence for each finding, with its expert; none for a model that does not compile.
  std::vector<std::string> of(const fuzzy::ForceModel& after, const std::stop_token& stop = {}) const;

 private:
  std::vector<Finding> known_;
};

}  // namespace tactus::analysis
