// Rules of FLL and FCL: `if a is x and (b is not y or c is z) then f is t with 0.5`.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {

// Rules of another program with names turned into indices.

/// `variable is [not] term` by indices; the variable is an input in a condition, an output in a conclusion.
struct ResolvedLiteral {
  std::size_t variable = 0;
  std::size_t term = 0;
  bool negated = false;
  std::size_t at = 0;

  bool isSame(const ResolvedLiteral& other) const {
    return variable == other.variable && term == other.term && negated == other.negated;
  }
};

struct ResolvedRule {
  const ForeignRule* rule = nullptr;
  /// Without the literals that always hold, and without the alternatives that never do.
  std::vector<std::vector<ResolvedLiteral>> alternatives;
  std::vector<ResolvedLiteral> conclusions;
  std::optional<Word> reads_output;  ///< an output in the condition, which Tactus lacks; such literals are left out
};

/// All rules of the model. Refused: a variable or a term that the file does not define, a weight outside
/// [0, 1].
base::Result<std::vector<ResolvedRule>> resolved(const ForeignModel& model);

/// A piece of a text; `text` is empty at its end.
struct Token {
  enum class Kind { kWord, kNumber, kSymbol, kEnd };
  Kind kind = Kind::kEnd;
  std::string_view text;
  std::size_t at = 0;

  Word word() const { return {text, at}; }
  /// Whether it is the keyword `lower_case`, in any case.
  bool is(std::string_view lower_case) const;
};

/// Tokens of a file or of a line, read from front to back. The last one is kEnd.
class TokenStream {
 public:
  explicit TokenStream(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  const Token& peek() const { return tokens_[next_]; }
  Token take() { return next_ + 1 < tokens_.size() ? tokens_[next_++] : tokens_[next_]; }
  /// Takes the next token if it is `lower_case`.
  bool takeIf(std::string_view lower_case);

 private:
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
};

/// Reads rules. A condition becomes a list of alternatives (its disjunctive normal form), which is exact for the
/// minimum and the maximum; NOT of a group follows De Morgan.
class RuleParser {
 public:
  /// FCL: warns of conditions that jFuzzyLogic reads in another order.
  RuleParser(SourceText& source, ImportFormat format) : source_(source), is_fcl_(format == ImportFormat::kFcl) {}

  /// The rule whose IF comes next, up to its weight. Refused: hedges, more than kMostAlternatives alternatives in one
  /// rule, or more than kMostInAll literals in all rules of the file, groups nested deeper than kDeepest.
  base::Result<ForeignRule> read(TokenStream& tokens);

  static constexpr std::size_t kMostAlternatives = 256;
  static constexpr std::size_t kMostInAll = std::size_t{1} << 18U;
  static constexpr int kDeepest = 32;

 private:
  using Alternatives = std::vector<Conjunction>;

  bool readCondition(bool negated, int depth, Alternatives& out);
  bool readAll(bool negated, int depth, Alternatives& out);
  bool readOne(bool negated, int depth, Alternatives& out);
  bool readLiteral(bool negated, Literal& out);
  bool readConclusions();
  bool readWeight();
  bool expect(std::string_view lower_case, std::string_view wanted);
  bool join(Alternatives& all, const Alternatives& more, bool both, std::size_t at);
  bool refuse(base::ErrorCode code, std::size_t at, std::string found, std::string wanted);
  /// A token as a message quotes it.
  static std::string shown(const Token& token);

  SourceText& source_;
  bool is_fcl_;
  std::optional<std::size_t> joined_at_;  ///< the first AND of the conjunction that was read last
  TokenStream* tokens_ = nullptr;
  ForeignRule rule_;
  std::size_t literals_ = 0;  ///< of all rules
  std::optional<base::Error> error_;
};

}  // namespace tactus::exchange
