// The effect of an edit on the force, as all parts of the screen show it: never less than on the curve on the screen.
#pragma once

#include <QString>
#include <cstddef>
#include <string>
#include <vector>

#include "app/editing/edit_impact.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

// The effect of an edit on the force, in words.

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

/// The curve on the screen: the input on its x axis and a value for each input.
struct CurveSetting {
  std::size_t x_input = 0;
  std::vector<double> values;
};

/// The forces of both models along that curve, at the sample positions of both models.
editing::GhostCurve curveBetween(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                 const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                 const CurveSetting& setting);

/// editing::editImpact, raised to what the curve shows. If `setting` has no values, or values for another number of
/// inputs, no curve is used. Thread: any.
editing::EditImpact shownImpact(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                                const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after,
                                const CurveSetting& setting);

}  // namespace tactus::workbench
