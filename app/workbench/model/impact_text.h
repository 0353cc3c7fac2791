// The effect of an edit on the force, in words.
#pragma once

#include <QString>
#include <string>

#include "app/editing/edit_impact.h"

namespace tactus::workbench {

/// A change of force > 0: `0.032 N`, or `below 0.001 N` if it would round to zero.
QString forceChangeText(double change_n, const std::string& unit);

/// `max ΔF at least 0.032 N (0.4 JND)`: "at least", because it is the largest of a sample of points. Just-noticeable
/// differences appear only if `unit`, the unit of the force, is newtons. `no change of the force` if the sample has no
/// difference.
QString impactText(const editing::EditImpact& impact, const std::string& unit);

}  // namespace tactus::workbench
