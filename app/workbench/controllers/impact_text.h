// What an edit does to the force, in words.
#pragma once

#include <QString>
#include <string>

#include "app/editing/edit_impact.h"

namespace tactus::workbench {

/// `max ΔF 0.032 N (0.4 JND)`; just-noticeable differences only where `unit`, that of the force, is newtons.
QString impactText(const editing::EditImpact& impact, const std::string& unit);

}  // namespace tactus::workbench
