// The parts of the C source (c_source.h). Nothing outside this folder includes this.
#pragma once

#include <cstddef>
#include <map>
#include <memory_resource>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/exchange/expert_view.h"
#include "core/exchange/origin.h"
#include "core/fuzzy/closed_form.h"
#include "core/fuzzy/mean_order.h"

namespace tactus::exchange {

/// The inputs that are fixed when the source is written: a value for each fixed input, nothing for the others.
using FixedInputs = std::vector<std::optional<double>>;

/// The memberships that the source computes once per point: `m[0]`, `m[1]`, … Terms that several experts share count
/// once.
class MembershipCode {
 public:
  /// `fixed`: one entry per input of the model.
  MembershipCode(const fuzzy::ForceModel& model, FixedInputs fixed);

  /// The index of `term` of input `input`.
  std::size_t index(std::size_t input, const fuzzy::Term& term);
  /// The membership of `term` where `input` is fixed; nothing where it is not.
  std::optional<double> fixedAt(std::size_t input, const fuzzy::Term& term) const;

  std::size_t count() const { return terms_.size(); }
  /// Input and term of membership `index`.
  const std::pair<std::size_t, fuzzy::Term>& operator[](std::size_t index) const { return terms_[index]; }
  /// The function `memberships`, which fills `m` and returns 1 where an input is not finite, else 0.
  std::string function() const;
  /// The function `other_memberships`, which leaves out those of `input` and gives its value within the universe in
  /// `at`. Its memberships may be below 0, which stands for 0. Needs numbers that are not odd.
  std::string functionBut(std::size_t input) const;
  /// Membership `index` in C, as in `functionBut`.
  std::string expressionBelowZero(std::size_t index) const;
  bool usesExp() const;
  /// Some numbers are so large or so small that memberships and strengths must be kept from vanishing.
  bool isOdd() const { return odd_; }
  /// Some membership above 0 may be so small that the squares of strengths vanish.
  bool canBeTiny() const;

 private:
  /// Some term of `input`, which is not fixed, begins or ends at 0: next to it, memberships would be too small for a
  /// double.
  bool hasRampToZero(std::size_t input) const;
  std::string expression(std::size_t input, const fuzzy::Term& term, bool below_zero = false) const;
  std::string valuesText() const;

  const fuzzy::ForceModel& model_;
  FixedInputs fixed_;
  bool odd_;
  std::vector<std::pair<std::size_t, fuzzy::Term>> terms_;  ///< input, term
};

/// Memberships that must all hold, ascending.
using Premise = std::vector<std::size_t>;
/// The premises of the rules for one output term, by weight.
using TermRules = std::map<double, std::vector<Premise>>;

/// The strengths of an expert's output terms that a rule can reach.
struct Strength {
  std::size_t term = 0;
  TermRules rules;
  std::string text;  ///< an expression in `m`
};
/// Ascending by term.
std::vector<Strength> strengthsOf(const ExpertView& view, MembershipCode& memberships);

/// Several strengths in C, each part that some of them share computed once.
struct SharedStrengths {
  std::string statements;           ///< declare what is shared, one line each
  std::vector<std::string> values;  ///< an expression for each
};
/// `pivots`: memberships of which a premise has at most one; rules that differ in it alone are joined.
SharedStrengths sharedStrengths(std::span<const TermRules> rules, std::span<const std::size_t> pivots);

/// A stretch of an input, `after < x <= until`, and what memberships of the input are there.
struct Stretch {
  double after = 0, until = 0;
  std::vector<std::size_t> in_part;  ///< above 0 somewhere, and below 1 somewhere
  std::vector<std::size_t> whole;    ///< 1 everywhere; all others of the input are 0
};
/// The stretches of the input between the ends of its terms, ascending; empty if there are too many.
std::vector<Stretch> stretchesOf(const fuzzy::Variable& input, std::size_t index, const MembershipCode& memberships);

/// Experts whose output terms have an order and are the same: their centroids are the same function of the strengths.
struct CentroidGroup {
  std::vector<fuzzy::Term> terms;
  fuzzy::ClosedForm form;
  std::vector<std::size_t> live;  ///< output terms that a rule of one of them reaches, ascending
};

/// The body of an expert's function where the output terms have no order, or some of them are Gaussians: `*offset` from
/// the lower end of the universe. `tables`: receives what must stand before the function.
std::string walkedCode(const ExpertView& view, std::size_t index, const std::vector<Strength>& strengths,
                       std::string& tables);

/// The functions that such bodies call: `general_offset` and, with Gaussians, `gaussian_offset`.
std::string generalOffsetText();
std::string gaussianOffsetText();
/// What both need, for experts of `most_terms` strengths at most.
std::string outputSetText(std::size_t most_terms);

/// `parts` joined by calls of `function`, which takes two: a tree, because a chain would be deeper than compilers
/// accept and slower. `parts` must not be empty.
std::string tree(const std::vector<std::string>& parts, const std::string& function);

/// Outside text for a C comment.
std::string comment(std::string_view text);

/// A double in C.
std::string number(double value);

// The texts of the tube (tube_source.h): what stands in tube.h, what stands before the recurrences in either language,
// and the recurrences.
extern const std::string_view kTubeHeader;
extern const std::string_view kTubeStartInC;
extern const std::string_view kTubeStartInJs;
extern const std::string_view kTubeBody;

/// A script that may stand in a page: nothing in it, be it a comment or a text, ends the page's script.
std::string forAPage(std::string script);

// What the C source of one model is made of (c_source.h). Nothing outside this folder includes this.

/// Writes the source of one model: what each expert needs, and from it the functions of the header.
class SourceWriter {
 public:
  /// `order`: of the compiled model.
  SourceWriter(const fuzzy::ForceModel& model, const FixedInputs& fixed, const Origin& origin, fuzzy::MeanOrder order)
      : model_(model), order_(std::move(order)), fixed_(fixed), origin_(origin), memberships_(model, fixed) {
    for (std::size_t e = 0; e < model.experts.size(); ++e) addExpert(e);
  }

  std::string header() const;
  std::string source() const;

 private:
  /// An expert whose centroid is the function of a group.
  struct Ordered {
    std::size_t group = 0;
    std::vector<Strength> strengths;
  };

  void addExpert(std::size_t index);
  std::size_t groupOf(const ExpertView& view, fuzzy::ClosedForm form, const std::vector<Strength>& strengths);
  bool isLarge() const;
  /// The experts that count.
  std::vector<std::size_t> counting() const;
  bool areOneGroup(const std::vector<std::size_t>& experts) const;
  std::string strengthFunction(std::size_t index, const Ordered& expert) const;
  std::string largest(const CentroidGroup& group, const std::string& at) const;
  std::string orderedFunctions(std::size_t index) const;
  std::string expertFunctions() const;
  std::string meanText() const;
  std::vector<std::size_t> membershipsOf(std::size_t input) const;
  std::size_t inputOfMostMemberships() const;
  std::optional<std::size_t> pivotFor(const std::vector<std::size_t>& experts) const;
  std::string stretchesText(const std::vector<std::size_t>& experts, std::size_t pivot) const;
  std::string stretchedText(const std::vector<std::size_t>& experts, std::size_t pivot) const;
  std::string sideBySideStart(const std::vector<std::size_t>& experts) const;
  std::string sideBySideCentroids(const std::vector<std::size_t>& experts) const;
  std::string oneByOneText(const std::vector<std::size_t>& experts) const;
  std::string sideBySideText(const std::vector<std::size_t>& experts) const;
  bool goesInBlocks(const std::vector<std::size_t>& experts) const;
  std::string batchText() const;
  std::string columnsText(std::string& point) const;
  std::string strengthsTogether(const std::vector<std::size_t>& experts) const;
  std::string blockText(const std::vector<std::size_t>& experts) const;
  std::string expertText() const;
  std::string centroidOf(std::size_t expert) const;
  bool isAlone(std::size_t expert) const;
  std::string centroidFunctions() const;
  std::string meanOfAll(const std::vector<std::size_t>& experts) const;
  std::string meanOfSomeText(const std::vector<std::size_t>& experts) const;
  std::string meanOf(const std::vector<std::size_t>& experts) const;
  std::string share(std::size_t expert) const;

  const fuzzy::ForceModel& model_;
  const std::vector<double> weights_ = normalizedWeights(model_);  ///< of the experts
  const fuzzy::MeanOrder order_;
  const FixedInputs& fixed_;
  const Origin& origin_;
  MembershipCode memberships_;
  std::pmr::monotonic_buffer_resource memory_;
  std::vector<CentroidGroup> groups_;
  std::vector<std::optional<Ordered>> ordered_;  ///< of each expert
  std::vector<std::string> walked_;              ///< the body of each other expert
  std::string tables_;
  std::size_t most_walked_ = 0;  ///< strengths of such an expert
  bool general_ = false;
  bool gaussian_ = false;
};

}  // namespace tactus::exchange
