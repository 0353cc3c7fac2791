// Models that the tests of the edits start from, and short names of their places.
#pragma once

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "app/editing/edit.h"
#include "app/editing/membership_edits.h"
#include "core/fuzzy/membership.h"

#include "tests/support/ngt_model.h"

namespace tactus::editing {

inline const TermListId kDepth{"depth", ""};
inline const TermListId kForce{"force", ""};

inline const fuzzy::Variable& variableIn(const fuzzy::ForceModel& model, const std::string& id) {
  return **findVariable(model, id);
}

inline const fuzzy::Term& termIn(const fuzzy::ForceModel& model, const std::string& variable, const std::string& id) {
  const fuzzy::Term* const term = findTerm(variableIn(model, variable).terms, id);
  EXPECT_NE(term, nullptr) << id;
  return *term;
}

inline std::vector<double> pointsOf(const fuzzy::ForceModel& model, const std::string& variable,
                                    const std::string& id) {
  return termIn(model, variable, id).points;
}

/// The model of an edit that must succeed.
inline Edit must(base::Result<Edit> edit) {
  EXPECT_TRUE(edit.has_value()) << (edit ? "" : edit.error().message());
  return edit ? std::move(*edit) : Edit{};
}

inline std::string refusal(const base::Result<Edit>& edit) {
  EXPECT_FALSE(edit.has_value());
  return edit ? std::string() : edit.error().message();
}

/// Largest distance from one of the sum of the memberships of a list of terms, over `count` places of the universe.
inline double furthestFromOne(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, int count) {
  double furthest = 0;
  for (int k = 0; k <= count; ++k) {
    const double x = variable.min + (variable.max - variable.min) * k / count;
    double sum = 0;
    for (const auto& term : terms) sum += fuzzy::MembershipFunction::of(term)(x);
    furthest = std::max(furthest, std::abs(sum - 1));
  }
  return furthest;
}

}  // namespace tactus::editing
