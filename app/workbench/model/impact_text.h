// The effect of an edit on the force, in words.
#pragma once

#include <QString>
#include <string>

#include "app/editing/edit_impact.h"

namespace tactus::workbench {

/// A change of force > 0: `0.032 N`, or `below 0.001 N` if it would round to zero.
QString forceChangeText(double change_n, const std::string& unit);

/// Over which settings a maximum was looked for.
enum class Scope {
  kAnywhere,   ///< a sample of all settings
  kThisCurve,  ///< the positions of the curve on the screen
};

/// The one sentence about a largest change of force > 0, of which every other one is made: `max ΔF anywhere at least
/// 0.032 N`, `max ΔF on this curve at least 0.032 N`. "At least", because both are the largest of a sample.
QString largestChangeText(double change_n, const std::string& unit, Scope scope);

/// The same where room is scarce: `ΔF ≥ 0.032 N anywhere`, `ΔF ≥ 0.032 N on this curve`.
QString briefChangeText(double change_n, const std::string& unit, Scope scope);

/// `max ΔF anywhere at least 0.032 N (0.4 JND)`. Just-noticeable differences appear only if `unit`, the unit of the
/// force, is newtons. `no change of the force` if the sample has no difference.
QString impactText(const editing::EditImpact& impact, const std::string& unit);

}  // namespace tactus::workbench
