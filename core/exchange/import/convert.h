// From a foreign model to a force model: the variables as Tactus carries them, and what each term of the file became.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/import/foreign_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

// From the model of another program to a force model of one expert.

/// The valid ForceModel with the forces of `foreign`, or one sentence: what Tactus cannot carry, with its place. OR and
/// NOT are split into rules and terms, exactly. What changes no force becomes a warning of the source. `output`: the
/// name of the output to take where there are several; may be empty.
base::Result<fuzzy::ForceModel> converted(const ForeignModel& foreign, const std::string& output);

// A term of another program as Tactus carries it, exactly or not at all.

/// A shape of Tactus with its points.
struct CarriedTerm {
  fuzzy::Shape shape = fuzzy::Shape::kTrapezoid;
  std::vector<double> points;
};

/// Why a term is not carried.
struct TermProblem {
  base::Error error;
  bool is_wrong = false;  ///< the term makes no sense in its own format either, so the file is refused in any case
};

/// The places on the axis that the term needs; nothing for a shape that Tactus lacks. A Gaussian needs four sigmas.
std::optional<ForeignRange> reachOf(const ForeignTerm& term);

/// `term` on the universe `range`. Exact inside the universe: a rectangle, a ramp, a step and points that go from 0 to
/// 1 and back become trapezoids, and what continues beyond the universe ends at its end. `fold`: shoulders beyond the
/// universe are put back to its end (FIS files move them out).
tl::expected<CarriedTerm, TermProblem> carried(const ForeignTerm& term, ForeignRange range, bool fold,
                                               const SourceText& source);

/// NOT of a term: the part below its falling edge and the part above its rising edge, each 1 where the term is 0. None
/// where the term covers the universe. Nothing for a Gaussian, whose complement is no shape of Tactus.
std::optional<std::vector<CarriedTerm>> complement(const CarriedTerm& term, ForeignRange range);

/// Whether the term is above 0 in positive width of the universe.
bool meets(const CarriedTerm& term, ForeignRange range);

/// A variable of the model in the making.
class CarriedVariable {
 public:
  /// `is_output`: terms without area in the universe are told apart. `used`: for each term of the file, whether a rule
  /// needs it; a term that Tactus lacks is refused where it is used, and left out with a warning elsewhere. Refused
  /// too: a term that makes no sense, two terms that would have the same id, no universe.
  static base::Result<CarriedVariable> carry(const ForeignModel& model, const ForeignVariable& variable, bool is_output,
                                             std::size_t number, const std::vector<bool>& used);

  /// The ids of the terms whose maximum is the term `index` of the file, or its complement; added to the variable where
  /// they are new. Empty where that is 0 in the whole universe. Refused: the complement of a Gaussian. `at`: the place
  /// of the rule.
  base::Result<std::vector<std::string>> idsOf(std::size_t index, bool negated, std::size_t at);

  const fuzzy::Variable& variable() const { return variable_; }

 private:
  CarriedVariable(const ForeignModel& model, const ForeignVariable& from, bool is_output)
      : source_(model.source.get()), from_(&from), is_output_(is_output) {}

  base::Result<void> setRange();
  base::Result<void> addTerm(const ForeignModel& model, std::size_t index, bool is_used);
  const std::string& addPart(const CarriedTerm& part, const std::string& id, const std::string& label);
  bool hasId(const std::string& id) const;

  SourceText* source_;
  const ForeignVariable* from_;
  bool is_output_;
  ForeignRange range_;
  fuzzy::Variable variable_;
  std::vector<std::optional<CarriedTerm>> terms_;              ///< of the file; nothing for one that is left out
  std::vector<std::vector<std::string>> ids_;                  ///< of them, in the model; none for one without area
  std::vector<std::optional<std::vector<std::string>>> nots_;  ///< of their complements, as far as they are needed
};

}  // namespace tactus::exchange
