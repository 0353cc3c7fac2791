// What an edit does to the force, in words.
#pragma once

#include <QString>
#include <string>

#include "app/editing/edit_impact.h"

namespace tactus::workbench {

/// How far a force moved, > 0: `0.032 N`, or `below 0.001 N` where it would read as nothing.
QString forceChangeText(double change_n, const std::string& unit);

/// `max ΔF at least 0.032 N (0.4 JND)`, because it is the largest of many places; just-noticeable differences only
/// where `unit`, that of the force, is newtons. `no change of the force` where it is the same.
QString impactText(const editing::EditImpact& impact, const std::string& unit);

}  // namespace tactus::workbench
