// The parts of the C source (c_source.h). Nothing outside this folder includes this.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/exchange/expert_view.h"

namespace tactus::exchange {

/// The memberships that the source computes once per point: `m[0]`, `m[1]`, … Terms that several experts share count
/// once.
class MembershipCode {
 public:
  explicit MembershipCode(const fuzzy::ForceModel& model);

  /// The index of `term` of input `input`.
  std::size_t index(std::size_t input, const fuzzy::Term& term);

  std::size_t count() const { return terms_.size(); }
  /// The function `memberships`, which fills `m` and returns NaN where an input is not finite, else 0.
  std::string function() const;
  bool usesExp() const;
  /// Some numbers are so large or so small that memberships and strengths must be kept from vanishing.
  bool isOdd() const { return odd_; }

 private:
  std::string expression(std::size_t input, const fuzzy::Term& term) const;

  const fuzzy::ForceModel& model_;
  bool odd_;
  std::vector<std::pair<std::size_t, fuzzy::Term>> terms_;  ///< input, term
};

/// The strengths of an expert's output terms in C: `s0`, `s1`, … for those that a rule can reach.
struct StrengthCode {
  std::string text;
  std::vector<std::size_t> reached;  ///< output terms, ascending
};
StrengthCode strengthCode(const ExpertView& view, MembershipCode& memberships);

/// The body of an expert's function behind the strengths: `*offset` from the lower end of the universe.
/// `index`: of the expert. `tables`: receives what must stand before the function. `general`: set where the function
/// `general_offset` is needed.
std::string centroidCode(const ExpertView& view, std::size_t index, const StrengthCode& strengths, std::string& tables,
                         bool& general);

/// The text of `general_offset`.
std::string generalOffsetText();

/// `parts` joined by calls of `function`, which takes two: a tree, because a chain would be deeper than compilers
/// accept and slower. `parts` must not be empty.
std::string tree(const std::vector<std::string>& parts, const std::string& function);

/// Outside text for a C comment.
std::string comment(std::string_view text);

/// A double in C.
std::string number(double value);

}  // namespace tactus::exchange
