// The findings about the data of a study, as text and as JSON.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/json/json_writer.h"
#include "core/study/data_finding.h"

namespace tactus::cli {

/// `look at the data first: 2` and one sentence for each finding with table and line; empty where there is none. Those
/// that are refused are marked, and so are those of them whose kind is `accepted`.
std::string dataAsText(const std::vector<study::DataFinding>& findings,
                       std::span<const study::DataFinding::Kind> accepted = {});

/// Writes the findings as the member `data` of the open object of `json`: `kind`, `severity`, `participant`, `table`,
/// `line`, `column` (null if there is none) and `sentence`.
void writeData(const std::vector<study::DataFinding>& findings, base::JsonWriter& json);

}  // namespace tactus::cli
