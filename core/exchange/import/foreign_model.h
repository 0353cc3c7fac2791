// A model of another fuzzy program as its file states it, before it is decided what Tactus can carry.
// The three readers make it; `converted` (convert.h) turns it into a ForceModel.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/import/source_text.h"

namespace tactus::exchange {

/// What the words of the formats for norms and defuzzifiers mean, as far as Tactus knows them.
enum class Meaning { kOther, kNone, kMinimum, kMaximum, kProduct, kCentroid };

/// A norm, a defuzzifier or the like under the word of the file.
struct Method {
  Word word;
  Meaning meaning = Meaning::kOther;
};

// Far more than a model of Tactus may have; they keep a hostile file from taking minutes.
inline constexpr std::size_t kMostForeignVariables = 100;  ///< inputs, and outputs
inline constexpr std::size_t kMostForeignTerms = 500;      ///< of a variable

struct ForeignNumber {
  double value = 0;
  std::size_t at = 0;
};

enum class ForeignShape {
  kTrapezoid,  ///< a b c d
  kTriangle,   ///< a b c
  kGaussian,   ///< mean, sigma
  kRectangle,  ///< from, to
  kRamp,       ///< the place of 0, the place of 1
  kRising,     ///< foot, shoulder; equal: a step
  kFalling,    ///< shoulder, foot; equal: a step
  kStep,       ///< place, direction of 1: inf or -inf
  kPoints,     ///< x y x y …, straight between, flat outside
  kOther,
};

struct ForeignTerm {
  Word name;
  ForeignShape shape = ForeignShape::kOther;
  Word word;  ///< the shape as the file calls it
  std::vector<ForeignNumber> numbers;
  ForeignNumber height{1, 0};
};

struct ForeignRange {
  double min = 0;
  double max = 0;
};

struct ForeignVariable {
  Word name;
  std::optional<ForeignRange> range;  ///< as the file states it; finite, min < max
  std::size_t range_at = 0;
  bool enabled = true;
  std::vector<ForeignTerm> terms;
  std::optional<std::size_t> stated_terms;  ///< how many terms the file says that it has

  // Of outputs only:
  std::optional<Method> aggregation;
  std::optional<Method> defuzzifier;
  std::optional<ForeignNumber> fallback;  ///< the value where no rule fires; NaN: none
  std::optional<std::size_t> holds_last;  ///< the file says here that the last value stays where no rule fires
};

/// `variable is [not] term`.
struct Literal {
  Word variable;
  Word term;
  bool negated = false;
};

/// Literals that hold together.
using Conjunction = std::vector<Literal>;

struct ForeignRule {
  std::size_t at = 0;
  std::vector<Conjunction> alternatives;  ///< the condition: one of them holds
  std::optional<std::size_t> and_at;      ///< where its first AND is
  std::optional<std::size_t> or_at;       ///< where its first OR is
  std::vector<Literal> conclusions;
  ForeignNumber weight{1, 0};
  std::size_t block = 0;
};

struct ForeignBlock {
  Word name;
  bool enabled = true;
  std::optional<Method> conjunction;
  std::optional<Method> disjunction;
  std::optional<Method> implication;
  std::optional<Method> aggregation;
  std::optional<Method> activation;  ///< kOther: a strategy that does not take all rules
};

enum class ImportFormat { kFll, kFcl, kFis };

/// An error if one more variable or term, `name`, would be too much.
std::optional<base::Error> tooMany(const SourceText& source, const std::vector<ForeignVariable>& variables, Word name);
std::optional<base::Error> tooMany(const SourceText& source, const std::vector<ForeignTerm>& terms, Word name);

struct ForeignModel {
  ImportFormat format = ImportFormat::kFll;
  std::shared_ptr<SourceText> source;
  std::string name;  ///< of the engine, function block or system; may be empty
  std::vector<ForeignVariable> inputs;
  std::vector<ForeignVariable> outputs;
  std::vector<ForeignBlock> blocks;
  std::vector<ForeignRule> rules;
};

// Names of other programs: ids of Tactus made from them, and the search for what a rule names.

/// ASCII letters, digits and `_` of `name`, one `_` for each run of other characters inside it; at most 64 bytes.
/// `otherwise` where nothing remains. `very small` gives `very_small`, `dV*` gives `dV`.
std::string idFrom(std::string_view name, const std::string& otherwise);

/// The names of one list, found as the program of the format finds them: FCL in any case, FLL also without the
/// characters that fuzzylite drops from names. A name that is meant exactly always wins.
class ForeignNames {
 public:
  explicit ForeignNames(ImportFormat format) : format_(format) {}

  /// Adds the next name.
  void add(std::string_view name);
  /// The place of a name in the list; nothing where it is not there or could be two.
  std::optional<std::size_t> find(std::string_view name) const;
  /// The names for a message: `'low', 'high'`.
  std::string listed() const;
  /// ` ('low'?)` for the closest one.
  std::string suggestion(std::string_view name) const;

 private:
  static constexpr std::size_t kSeveral = static_cast<std::size_t>(-1);

  std::string loose(std::string_view name) const;

  ImportFormat format_;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t, std::less<>> exact_;
  std::map<std::string, std::size_t, std::less<>> loose_;
};

// The words of FLL, FCL and FIS for norms, defuzzifiers and shapes.

/// A norm or a defuzzifier, in any case.
Method methodOf(Word word);

/// The shape that a word means, in any case; kOther for a shape that Tactus lacks.
ForeignShape shapeOf(std::string_view word);

/// `'Sigmoid', a shape that Tactus lacks`, for a message; names Sugeno's functions.
std::string shapeFound(std::string_view word);

/// Splits the extra last number of `term`, its height, off its numbers.
void takeHeight(ForeignTerm& term);

/// Whether the word is a hedge of one of the formats: any, extremely, seldom, somewhat, very and others.
bool isHedge(std::string_view word);
/// The hedge that stands in the place of a term and always holds: `x is any`.
bool isAny(std::string_view word);

// The readers of the three formats. Nothing outside this folder includes this; `importModel` (import_model.h) does.

/// Reads a text completely. An error has line and column: what was found, and what was wanted. What the text says but
/// Tactus need not know becomes a warning of `source`.
base::Result<ForeignModel> readFll(const std::shared_ptr<SourceText>& source);
base::Result<ForeignModel> readFcl(const std::shared_ptr<SourceText>& source);
base::Result<ForeignModel> readFis(const std::shared_ptr<SourceText>& source);

}  // namespace tactus::exchange
