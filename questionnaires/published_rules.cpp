#include "questionnaires/published_rules.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "questionnaires/aliases.h"
#include "questionnaires/embedded_data.h"
#include "questionnaires/json_reading.h"
#include "questionnaires/rule_sentence.h"

namespace tactus::questionnaires {
namespace {

using base::Result;

Result<TableReading> tableReading(const JsonPlace& json) {
  TableReading reading;
  const std::pair<std::string_view, std::string*> texts[] = {{"id", &reading.id},
                                                             {"title", &reading.title},
                                                             {"assumes", &reading.assumes},
                                                             {"depth_terms", &reading.depth_terms}};
  for (const auto& [key, target] : texts) {
    auto text = json.string(key);
    if (!text) return tl::unexpected(text.error());
    *target = std::move(*text);
  }
  const auto regions = json.member("regions").and_then([](const JsonPlace& place) { return place.object(); });
  if (!regions) return tl::unexpected(regions.error());
  for (const auto& [printed, place] : *regions) {
    auto meant = place.string();
    if (!meant) return tl::unexpected(meant.error());
    reading.regions.emplace_back(printed, std::move(*meant));
  }
  return reading;
}

Result<std::vector<TableReading>> tableReadings() {
  const auto json = parseJson(tableA2ReadingsJson(), "tactus-table-readings");
  if (!json) return tl::unexpected(json.error());
  const auto places =
      JsonPlace{&*json, {}}.member("readings").and_then([](const JsonPlace& place) { return place.array(); });
  if (!places) return tl::unexpected(places.error());
  std::vector<TableReading> readings;
  for (const auto& place : *places) {
    auto reading = tableReading(place);
    if (!reading) return tl::unexpected(reading.error());
    readings.push_back(std::move(*reading));
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
  auto readings = tableReadings();
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
