#include "core/exchange/import/method_checks.h"

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/base/text.h"

namespace tactus::exchange {
namespace {

using base::ErrorCode;
using base::quoted;

/// What a method is called, in words and in the format.
struct Kind {
  const char* what;
  Meaning wanted;
  const char* keys[3];   ///< in FLL, FCL, FIS
  const char* words[3];  ///< of the wanted one
};

constexpr Kind kConjunction{
    "conjunction", Meaning::kMinimum, {"conjunction", "AND", "AndMethod"}, {"Minimum", "MIN", "min"}};
constexpr Kind kDisjunction{
    "disjunction", Meaning::kMaximum, {"disjunction", "OR", "OrMethod"}, {"Maximum", "MAX", "max"}};
constexpr Kind kImplication{"implication",
                            Meaning::kMinimum,
                            {"implication", "ACT", "ImpMethod"},
                            {"Minimum or AlgebraicProduct", "MIN or PROD", "min or prod"}};
constexpr Kind kAggregation{
    "aggregation", Meaning::kMaximum, {"aggregation", "ACCU", "AggMethod"}, {"Maximum", "MAX", "max"}};
constexpr Kind kDefuzzifier{
    "defuzzifier", Meaning::kCentroid, {"defuzzifier", "METHOD", "DefuzzMethod"}, {"Centroid", "COG", "centroid"}};

/// The defuzzifiers of systems whose terms are no fuzzy sets.
const char* systemOf(std::string_view word) {
  const std::string lower = base::lowered(word);
  const bool weighted = lower.starts_with("weighted") || lower.starts_with("wt") || lower == "cogs" || lower == "cogf";
  return weighted ? " of a Takagi-Sugeno or Tsukamoto system" : "";
}

class MethodChecker {
 public:
  explicit MethodChecker(const ForeignModel& model)
      : model_(model), source_(*model.source), format_(static_cast<std::size_t>(model.format)) {}

  /// An error unless `method` is the wanted one. A method that is not stated: the default of FCL and FIS.
  bool want(const std::optional<Method>& method, const Kind& kind, std::size_t at) {
    if (error_) return false;
    if (!method && model_.format != ImportFormat::kFll) {
      const std::string first = std::string(kind.words[format_]).substr(0, std::string(kind.words[format_]).find(' '));
      if (warned_.insert(kind.what).second)
        source_.warn(at, std::string(kind.keys[format_]) + " is not stated; " + first + " is taken");
      return true;
    }
    if (method && method->meaning == kind.wanted) return true;
    return refuse(method, kind, at);
  }

  /// Minimum or product.
  void wantImplication(const ForeignBlock& block, std::size_t at) {
    const bool scales = block.implication && block.implication->meaning == Meaning::kProduct;
    if (!scales && !want(block.implication, kImplication, at)) return;
    if (implication_ && *implication_ != scales) {
      error_ = source_.error(ErrorCode::kValue, at, "rule blocks with different implications",
                             "one for all rules of an output");
    }
    implication_ = scales;
  }

  void wantActivation(const ForeignBlock& block) {
    if (error_ || !block.activation) return;
    error_ = source_.error(ErrorCode::kValue, block.activation->word.at,
                           "the activation " + quoted(block.activation->word.text), "General: Tactus takes all rules");
  }

  const std::optional<base::Error>& error() const { return error_; }
  bool scales() const { return implication_.value_or(false); }

 private:
  bool refuse(const std::optional<Method>& method, const Kind& kind, std::size_t at) {
    const bool none = !method || method->meaning == Meaning::kNone;
    const std::size_t where = method && !method->word.text.empty() ? method->word.at : at;
    error_ = source_.error(
        ErrorCode::kValue, where,
        none ? std::string("no ") + kind.what
             : std::string("the ") + kind.what + " " + quoted(method->word.text) + systemOf(method->word.text),
        std::string(kind.words[format_]) + ", all that Tactus has");
    return false;
  }

  const ForeignModel& model_;
  SourceText& source_;
  std::size_t format_;
  std::set<std::string> warned_;
  std::optional<bool> implication_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<fuzzy::Implication> checkMethods(const ForeignModel& model, const ForeignVariable& output,
                                              const std::vector<ResolvedRule>& rules) {
  MethodChecker checker(model);
  checker.want(output.defuzzifier, kDefuzzifier, output.name.at);
  std::set<std::size_t> blocks;
  for (const ResolvedRule& rule : rules) {
    const ForeignBlock& block = model.blocks[rule.rule->block];
    if (blocks.insert(rule.rule->block).second) {
      checker.want(output.aggregation ? output.aggregation : block.aggregation, kAggregation, output.name.at);
      checker.wantActivation(block);
      checker.wantImplication(block, rule.rule->at);
    }
    // IEC 61131-7 pairs MIN with MAX: stating one states the other.
    const bool paired = model.format == ImportFormat::kFcl;
    const bool is_max = block.disjunction && block.disjunction->meaning == Meaning::kMaximum;
    const bool is_min = block.conjunction && block.conjunction->meaning == Meaning::kMinimum;
    if (rule.rule->and_at && !(paired && !block.conjunction && is_max))
      checker.want(block.conjunction, kConjunction, *rule.rule->and_at);
    if (rule.rule->or_at && !(paired && !block.disjunction && is_min))
      checker.want(block.disjunction, kDisjunction, *rule.rule->or_at);
    if (checker.error()) break;
  }
  if (checker.error()) return tl::unexpected(*checker.error());
  return checker.scales() ? fuzzy::Implication::kScale : fuzzy::Implication::kClip;
}

}  // namespace tactus::exchange
