#include "core/base/check.h"
#include "core/base/tables/csv.h"
#include "questionnaires/embedded_data.h"
#include "questionnaires/scale_summary.h"

namespace tactus::questionnaires {
namespace {

constexpr std::size_t kTeachers = 9;  // paper, Section 5.4

}  // namespace

std::vector<ScaleSummary> publishedUsability() {
  const auto table = base::CsvTable::parse(std::string(table3Csv()), "table_3.csv");
  TACTUS_CHECK(table.has_value());
  std::vector<ScaleSummary> rows;
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    const auto number = [&](std::string_view column) { return *table->number(row, *table->require(column)); };
    rows.push_back({static_cast<int>(number("item")), kTeachers, number("mean"), number("sd"),
                    static_cast<int>(number("min")), static_cast<int>(number("max"))});
  }
  return rows;
}

}  // namespace tactus::questionnaires
