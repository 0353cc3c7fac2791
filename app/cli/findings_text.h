// Findings about rules as `tactus build` and `tactus check` print them.
#pragma once

#include <span>
#include <string>

#include "core/base/json/json_writer.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::cli {

/// By kind, each kind with its number on a line of its own and then a few of its findings, the largest forces first,
/// and how many more there are. `unit` is that of the forces.
std::string findingsAsText(std::span<const elicitation::RuleFinding> findings, const std::string& unit);

/// All of them, as the member `findings` of the object that `json` is in.
void writeFindings(std::span<const elicitation::RuleFinding> findings, base::JsonWriter& json);

}  // namespace tactus::cli
