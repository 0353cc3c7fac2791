// The force model in its editable form, as in the model file: variables, terms, rules, experts.
// Plain data. `validate` checks it; `compile` turns it into a CompiledModel for evaluation (compiled_model.h).
// Semantics: docs/semantics.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/fuzzy/renderer_parameters.h"

namespace tactus::fuzzy {

// Limits of a model. They bound the stack space of an evaluation; a higher limit costs stack space in every caller.
inline constexpr std::size_t kMostInputs = 8;
inline constexpr std::size_t kMostTerms = 64;    ///< per variable
inline constexpr std::size_t kMostRules = 4096;  ///< per expert
inline constexpr std::size_t kMostExperts = 1024;
inline constexpr std::size_t kMostContracts = 64;
inline constexpr std::size_t kMostEvents = 8;

enum class Shape {
  kTrapezoid,  ///< points a <= b <= c <= d
  kTriangle,   ///< points a <= b <= c
  kGaussian,   ///< points mean, sigma > 0
};

/// All shapes, for a search by name.
inline constexpr Shape kShapes[] = {Shape::kTrapezoid, Shape::kTriangle, Shape::kGaussian};

/// A linguistic term: a name for a fuzzy set on the universe of its variable.
struct Term {
  std::string id;
  std::string label;
  Shape shape = Shape::kTrapezoid;
  std::vector<double> points;  ///< 4, 3 or 2 numbers (see Shape) in the unit of the variable

  bool operator==(const Term&) const = default;
};

/// What an input is to a tube: how deep its tip is, how fast it moves, or a condition. Unsaid: by the id, `depth` is
/// the way and `speed` the rate.
enum class Role { kUnsaid, kCondition, kWay, kRate };

inline constexpr Role kRoles[] = {Role::kCondition, Role::kWay, Role::kRate};  ///< that can be said

/// A linguistic variable: its universe [min, max] in `unit`, and its terms.
struct Variable {
  std::string id;
  std::string label;
  std::string unit;
  double min = 0;
  double max = 1;
  std::vector<Term> terms;
  Role role = Role::kUnsaid;  ///< of an input

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

/// A list of terms that replaces the variable's own list for one expert.
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

/// A reference evaluation stored with a model. The program repeats it when it imports the model.
struct Check {
  std::vector<double> in;  ///< one value per input, in the order of the inputs
  double force = 0;
  bool fired = true;

  bool operator==(const Check&) const = default;
};

/// A promise about the force in the whole input space, or where inputs are in words (docs/contracts.md). Its names may
/// be of variables and terms that the model no longer has: then it says nothing, and the check says so.
struct Contract {
  enum class Kind {
    kNeverRaises,  ///< more of `input` never raises the force
    kNeverLowers,
    kNeverHarder,  ///< in `word` of `input` the force is never above that in `than`, at equal other inputs
    kNoStep,       ///< within `within` of `input` the force never changes by more than `limit`
    kNeverAbove,   ///< the force is never above `limit`
    kNeverBelow,
    kNeverSilent,  ///< some rule fires
  };
  std::string id;
  Kind kind = Kind::kNeverSilent;
  std::string input;
  std::string word, than;
  double within = 0;  ///< in the unit of the input, > 0
  double limit = 0;   ///< in the unit of the output, or in just-noticeable differences; of kNoStep > 0
  bool limit_in_jnd = false;
  std::vector<Condition> where;  ///< inputs whose membership in a word is at least one half; others are free

  bool operator==(const Contract&) const = default;
};

/// All kinds, for a search by name.
inline constexpr Contract::Kind kContractKinds[] = {
    Contract::Kind::kNeverRaises, Contract::Kind::kNeverLowers, Contract::Kind::kNeverHarder, Contract::Kind::kNoStep,
    Contract::Kind::kNeverAbove,  Contract::Kind::kNeverBelow,  Contract::Kind::kNeverSilent};

/// A puncture: behind a word of the way a share of the force is lost, once in a stroke. Only a tube renders it, because
/// it depends on what was felt before (docs/renderer.md); the force of the model itself knows no events.
struct TubeEvent {
  std::string term;  ///< of the way, in the variable's own list
  double share = 0;  ///< in (0, 1)

  bool operator==(const TubeEvent&) const = default;
};

/// A key and its value as JSON text.
struct NamedJson {
  std::string key;
  std::string json;

  bool operator==(const NamedJson&) const = default;
};

/// The origin of a model.
struct Provenance {
  std::string study;
  std::vector<NamedJson> settings;  ///< settings of the program that made the model
  std::vector<NamedJson> sources;   ///< input data of the model
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
  double default_force_n = 0;                    ///< the force if every expert abstains
  std::vector<std::string> accepted_holes;
  std::vector<Expert> experts;
  std::optional<RendererParameters> renderer;
  std::vector<Check> checks;
  std::vector<Contract> contracts;
  std::vector<TubeEvent> events;
  std::vector<NamedJson> extra;  ///< unknown top-level keys of the model file

  bool operator==(const ForceModel&) const = default;
};

/// `trapezoid`, `triangle`, `gaussian`.
std::string_view name(Shape shape) noexcept;
/// `condition`, `way`, `rate`.
std::string_view name(Role role) noexcept;
/// `clip`, `scale`.
std::string_view name(Implication implication) noexcept;
/// `never_raises`, `never_lowers`, `never_harder`, `no_step`, `never_above`, `never_below`, `never_silent`.
std::string_view name(Contract::Kind kind) noexcept;

/// Which members a kind of contract has beside `id`, `kind` and `where`; the others keep their first values.
struct ContractMembers {
  bool input = false;
  bool words = false;   ///< `word` and `than`
  bool within = false;  ///< with `limit_in_jnd`
  bool limit = false;
};
ContractMembers membersOf(Contract::Kind kind) noexcept;

/// The number of points of a shape: 4, 3, 2.
std::size_t pointCount(Shape shape) noexcept;

/// The role of `input`, said or by its id; never kUnsaid.
Role roleOf(const Variable& input) noexcept;
/// The index of the input along which the tip moves, mm; nothing if there is none.
std::optional<std::size_t> wayOf(std::span<const Variable> inputs) noexcept;
/// The index of the input that is the speed of the tip, mm/s; nothing if there is none.
std::optional<std::size_t> rateOf(std::span<const Variable> inputs) noexcept;

/// The term with the id `id`, or null.
const Term* findTerm(const std::vector<Term>& terms, std::string_view id) noexcept;

/// Where on the way `term` ends to hold fully: the last point of membership 1 (the third point of a trapezoid, the peak
/// of the other shapes), within the universe.
double endOfCore(const Variable& way, const Term& term) noexcept;

/// `vein wall, 60 % of the force is lost`. `way`: the input whose term the event names.
std::string eventText(const Variable& way, const TubeEvent& event);
/// The same for each event of a valid model.
std::vector<std::string> eventTexts(const ForceModel& model);

/// Removes the events whose term the way no longer has.
void eraseLostEvents(ForceModel& model);

/// The terms of `variable` for `expert`: the expert's own list if there is one, else the variable's list. `variable` is
/// an input of the model or its output.
const std::vector<Term>& termsFor(const Expert& expert, const Variable& variable) noexcept;

/// The weights with which every mean over experts is taken, in the order of the experts: the largest lies in [1, 2),
/// and whoever has a weight above 0 keeps one. The ratios are those of `weights` (finite, >= 0, any size), but for the
/// next smaller weight more than 2^72 below: it moves up to that distance, where it still vanishes beside the larger
/// ones in the rounding. So no sum of them is infinite, and among the small ones the ratios are kept where the large
/// ones abstain.
std::vector<double> normalizedWeights(std::span<const double> weights);
std::vector<double> normalizedWeights(const ForceModel& model);

// Which rules of a model count.

/// Whether `rule` can fire: it is enabled and has a weight.
inline bool takesPart(const Rule& rule) { return rule.enabled && rule.weight > 0; }

}  // namespace tactus::fuzzy
