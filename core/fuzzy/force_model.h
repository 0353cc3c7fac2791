// The force model as people edit it and files hold it: variables, terms, rules, experts.
// Plain data; `validate` says whether it makes sense, `compile` turns it into what evaluates (compiled_model.h).
// Semantics: docs/semantics.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/fuzzy/renderer_parameters.h"

namespace tactus::fuzzy {

// Limits of a model. They bound the stack that evaluation needs; raising them costs stack space in every caller.
inline constexpr std::size_t kMostInputs = 8;
inline constexpr std::size_t kMostTerms = 64;    ///< of one variable
inline constexpr std::size_t kMostRules = 4096;  ///< of one expert
inline constexpr std::size_t kMostExperts = 1024;

enum class Shape {
  kTrapezoid,  ///< points a <= b <= c <= d
  kTriangle,   ///< points a <= b <= c
  kGaussian,   ///< points mean, sigma > 0
};

/// All shapes, for whoever has to find one by its name.
inline constexpr Shape kShapes[] = {Shape::kTrapezoid, Shape::kTriangle, Shape::kGaussian};

/// A linguistic term: a name for a fuzzy set on the universe of its variable.
struct Term {
  std::string id;
  std::string label;
  Shape shape = Shape::kTrapezoid;
  std::vector<double> points;  ///< 4, 3 or 2 numbers in the unit of the variable, see Shape

  bool operator==(const Term&) const = default;
};

/// A linguistic variable: its universe [min, max] in `unit`, and its terms.
struct Variable {
  std::string id;
  std::string label;
  std::string unit;
  double min = 0;
  double max = 1;
  std::vector<Term> terms;

  bool operator==(const Variable&) const = default;
};

/// `input is term`.
struct Condition {
  std::string input;
  std::string term;

  bool operator==(const Condition&) const = default;
};

/// IF all conditions THEN the output is `then`. Firing strength = weight * min of the memberships.
struct Rule {
  std::vector<Condition> conditions;
  std::string then;
  double weight = 1;  ///< in [0, 1]
  bool enabled = true;

  bool operator==(const Rule&) const = default;
};

/// A list of terms that takes the place of a variable's own list for one expert.
struct TermOverride {
  std::string variable;
  std::vector<Term> terms;

  bool operator==(const TermOverride&) const = default;
};

/// One expert's rule base.
struct Expert {
  std::string id;
  std::string label;
  double weight = 1;  ///< share in the averaged force, >= 0
  std::vector<TermOverride> overrides;
  std::vector<Rule> rules;

  bool operator==(const Expert&) const = default;
};

enum class Implication {
  kClip,   ///< min(strength, membership)
  kScale,  ///< strength * membership
};

/// A reference evaluation that travels with a model and is repeated on import.
struct Check {
  std::vector<double> in;  ///< one value per input, in the order of the inputs
  double force = 0;
  bool fired = true;

  bool operator==(const Check&) const = default;
};

/// A key and its value as JSON text.
struct NamedJson {
  std::string key;
  std::string json;

  bool operator==(const NamedJson&) const = default;
};

/// Where a model comes from.
struct Provenance {
  std::string study;
  std::vector<NamedJson> settings;  ///< how it was made
  std::vector<NamedJson> sources;   ///< from what
  std::string notes;

  bool operator==(const Provenance&) const = default;
};

struct ForceModel {
  std::string name;
  std::string created_utc;  ///< `2026-11-21T08:00:00Z`
  std::string generator;    ///< program and version that wrote it
  std::optional<Provenance> provenance;
  std::vector<Variable> inputs;
  Variable output;
  Implication implication = Implication::kClip;  ///< conjunction is min, aggregation max, defuzzification centroid
  double default_force_n = 0;                    ///< the force where every expert abstains
  std::vector<std::string> accepted_holes;
  std::vector<Expert> experts;
  std::optional<RendererParameters> renderer;
  std::vector<Check> checks;
  std::vector<NamedJson> extra;  ///< unknown top-level keys of the file it was read from

  bool operator==(const ForceModel&) const = default;
};

/// `trapezoid`, `triangle`, `gaussian`.
std::string_view name(Shape shape) noexcept;
/// `clip`, `scale`.
std::string_view name(Implication implication) noexcept;
/// How many points a shape has: 4, 3, 2.
std::size_t pointCount(Shape shape) noexcept;

/// The term `id` of the list, or null.
const Term* findTerm(const std::vector<Term>& terms, std::string_view id) noexcept;

/// The terms of `variable` (one of the model's inputs or its output) as `expert` understands them: the expert's own
/// list or the variable's.
const std::vector<Term>& termsFor(const Expert& expert, const Variable& variable) noexcept;

}  // namespace tactus::fuzzy
