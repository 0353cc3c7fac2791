// One expert of a model as the writers of other formats see it: terms resolved, names that every format takes.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

/// A term under the name that it has in the file.
struct NamedTerm {
  std::string name;
  const fuzzy::Term* term;
};

/// A variable with the terms of this expert.
struct NamedVariable {
  std::string name;
  const fuzzy::Variable* variable;
  std::vector<NamedTerm> terms;
};

/// A rule by indices. Disabled rules are left out.
struct IndexedRule {
  std::vector<std::pair<std::size_t, std::size_t>> conditions;  ///< input, term
  std::size_t then = 0;
  double weight = 1;
};

struct ExpertView {
  const fuzzy::ForceModel* model;
  const fuzzy::Expert* expert;
  std::string name;  ///< of the system in the file
  std::vector<NamedVariable> inputs;
  NamedVariable output;
  std::vector<IndexedRule> rules;
  std::size_t disabled_rules = 0;
  std::string origin = {};  ///< a line for the head of the file (origin.h)
};

/// The view of expert `expert`. `model` must be valid, and stays in use. Names are letters, digits and `_`, begin with
/// a letter, are no word of a format, and differ from each other in more than upper and lower case.
ExpertView viewOf(const fuzzy::ForceModel& model, std::size_t expert);

/// Corners a <= b <= c <= d of a trapezoid or triangle.
struct Corners {
  double a, b, c, d;
};
Corners cornersOf(const fuzzy::Term& term);

}  // namespace tactus::exchange
