#include "questionnaires/published_rules.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/base/json/json_members.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "questionnaires/aliases.h"
#include "questionnaires/form_file.h"
#include "questionnaires/rule_sentence.h"

namespace tactus::questionnaires {
namespace {

using base::JsonMembers;
using base::required;
using base::Result;

std::vector<TableReading> readReadings(JsonMembers& json, std::optional<base::Error>& error) {
  std::vector<TableReading> readings;
  json.format("tactus-table-readings");
  for (const base::JsonValue value : json.elements(required("readings"))) {
    JsonMembers members(value, error);
    TableReading& reading = readings.emplace_back();
    members.text(required("id"), reading.id);
    members.text(required("title"), reading.title);
    members.text(required("assumes"), reading.assumes);
    members.text(required("depth_terms"), reading.depth_terms);
    members.texts(required("regions"), reading.regions);
    members.refuseOthers();
  }
  return readings;
}

/// The depth term that is meant where `printed` is printed.
const std::string& meantRegion(const TableReading& reading, const std::string& printed) {
  const auto it = std::find_if(reading.regions.begin(), reading.regions.end(),
                               [&printed](const auto& region) { return region.first == printed; });
  TACTUS_CHECK(it != reading.regions.end());
  return it->second;
}

}  // namespace

std::vector<TableReading> s4Readings() {
  auto readings = base::readJson(tableA2ReadingsJson(), "table_a2_readings.json", readReadings);
  TACTUS_CHECK(readings.has_value());
  return std::move(*readings);
}

Result<std::vector<study::GivenRule>> s4Rules(std::string_view reading_id) {
  const auto readings = s4Readings();
  const auto reading = std::find_if(readings.begin(), readings.end(),
                                    [reading_id](const TableReading& candidate) { return candidate.id == reading_id; });
  if (reading == readings.end()) {
    std::vector<std::string> ids;
    for (const auto& known : readings) ids.push_back(known.id);
    return base::fail(base::ErrorCode::kReference, "reading of Table A2", base::quoted(reading_id),
                      "one of " + base::joined(ids, ", "));
  }

  const auto table = base::CsvTable::parse(std::string(tableA2Csv()), "table_a2.csv");
  TACTUS_CHECK(table.has_value());
  const auto text_column = table->find("text");
  TACTUS_CHECK(text_column.has_value());
  const AliasTable aliases = ngtAliases();
  std::vector<study::GivenRule> rules;
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    auto sentence = parseRuleSentence(table->cell(row, *text_column), aliases);
    TACTUS_CHECK(sentence.has_value() && !sentence->then.empty());
    for (auto& condition : sentence->conditions) {
      if (condition.input == "depth") condition.term = meantRegion(*reading, condition.term);
    }
    rules.push_back({"S4", reading->id, std::move(sentence->conditions), std::move(sentence->then), 1});
  }
  return rules;
}

}  // namespace tactus::questionnaires
