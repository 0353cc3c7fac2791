// What a researcher should know about a valid model before it is used: findings, not errors.
#pragma once

#include <string>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

struct Finding {
  enum class Kind {
    kHole,             ///< a region where no rule fires
    kConflict,         ///< the same conditions with another consequent
    kDirectionChange,  ///< a step against the direction of most steps of the same expert and input
    kDisagreement,     ///< an expert whose direction for an input is opposite to that of most experts
    kUnusedTerm,       ///< a term that no enabled rule of the expert mentions
  };
  Kind kind = Kind::kHole;
  std::string expert;  ///< expert id; empty where the averaged model is meant
  std::string place;   ///< what it is about: a region, a rule, an input
  std::string text;    ///< one sentence
};

/// `hole`, `conflict`, …
std::string_view name(Finding::Kind kind) noexcept;

/// Smallest and largest force seen.
struct ForceRange {
  double min_n = 0;
  double max_n = 0;
  std::size_t points = 0;  ///< where it was looked at
  std::size_t fired = 0;   ///< of these, where some rule fired; 0 means that there is no range
};

struct Lint {
  std::vector<Finding> findings;
  bool coverage_complete = true;
  ForceRange reachable;
};

/// All findings about `model`, which must be valid. Holes have exact boundaries. Directions are read off the rules:
/// along the terms of one input, in the order of their centres, with the other conditions of a rule held fixed, each
/// change of the consequent is a step up or down; three quarters of an expert's steps in one direction make it the
/// direction. The reachable range is what was seen at the vertices of the terms and between them, so the true range may
/// be a little wider.
Lint lint(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled);

}  // namespace tactus::analysis
