// The words of FLL, FCL and FIS for norms, defuzzifiers and shapes.
#pragma once

#include <string>
#include <string_view>

#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {

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

}  // namespace tactus::exchange
