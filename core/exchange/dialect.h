// The formats of other fuzzy programs that Tactus writes: one expert in one text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/exchange/origin.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

enum class Dialect {
  kFll,           ///< fuzzylite
  kFclIec,        ///< IEC 61131-7, as jFuzzyLogic reads it
  kFclFuzzylite,  ///< FCL as fuzzylite reads it
  kFis,           ///< MATLAB, Octave
  kFml,           ///< IEEE 1855-2016
};
inline constexpr Dialect kDialects[] = {Dialect::kFll, Dialect::kFclIec, Dialect::kFclFuzzylite, Dialect::kFis,
                                        Dialect::kFml};

/// `fll`, `fcl`, `fcl-fuzzylite`, `fis`, `fml`: the words of the command line.
std::string_view name(Dialect dialect) noexcept;
/// What follows the expert in a file name: `.fll`, `.iec.fcl`, `.fuzzylite.fcl`, `.fis`, `.fml`.
std::string_view suffix(Dialect dialect) noexcept;

/// How a program that reads the format computes the centroid: `count` samples, either in the middle of cells or from
/// end to end of the universe.
struct ReaderRule {
  bool midpoint;
  std::size_t count;
  double tolerance;  ///< share of the output's range that such a centroid may be off (docs/exchange.md)
};
ReaderRule readerRule(Dialect dialect) noexcept;

/// The text for expert `expert` of a valid model, with its origin in a comment. Refused with one sentence: what the
/// format cannot carry. Disabled rules are left out; the force where the expert abstains is NaN, or the model's default
/// where a format knows none.
base::Result<std::string> format(const fuzzy::ForceModel& model, std::size_t expert, Dialect dialect,
                                 const Origin& origin = {});

}  // namespace tactus::exchange
