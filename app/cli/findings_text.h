// The findings about rules in the output of `tactus build` and `tactus check`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/json/json_writer.h"
#include "core/study/data_finding.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::cli {

// The findings about the data of a study, as text and as JSON.

/// `look at the data first: 2` and one sentence for each finding with table and line; empty where there is none. Those
/// that are refused are marked, and so are those of them whose kind is `accepted`.
std::string dataAsText(const std::vector<study::DataFinding>& findings,
                       std::span<const study::DataFinding::Kind> accepted = {});

/// Writes the findings as the member `data` of the open object of `json`: `kind`, `severity`, `participant`, `table`,
/// `line`, `column` (null if there is none) and `sentence`.
void writeData(const std::vector<study::DataFinding>& findings, base::JsonWriter& json);

/// Groups the findings by kind. Each kind has a line with its number of findings, then a few of them, largest force
/// first, and the number of the rest. `unit`: unit of the forces.
std::string findingsAsText(std::span<const elicitation::RuleFinding> findings, const std::string& unit);

/// Writes all findings as the member `findings` of the open object of `json`.
void writeFindings(std::span<const elicitation::RuleFinding> findings, base::JsonWriter& json);

}  // namespace tactus::cli
