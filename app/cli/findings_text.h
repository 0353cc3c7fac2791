// The findings about rules in the output of `tactus build` and `tactus check`.
#pragma once

#include <span>
#include <string>

#include "core/base/json/json_writer.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::cli {

/// Groups the findings by kind. Each kind has a line with its number of findings, then a few of them, largest force
/// first, and the number of the rest. `unit`: unit of the forces.
std::string findingsAsText(std::span<const elicitation::RuleFinding> findings, const std::string& unit);

/// Writes all findings as the member `findings` of the open object of `json`.
void writeFindings(std::span<const elicitation::RuleFinding> findings, base::JsonWriter& json);

}  // namespace tactus::cli
