// The variables of a foreign model as Tactus carries them, and what each term of the file became.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/exchange/import/carried_term.h"
#include "core/exchange/import/foreign_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

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
