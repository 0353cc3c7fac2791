#include "experiments/published_tables.h"

#include "core/base/check.h"
#include "core/base/tables/csv.h"

namespace tactus::experiments {
namespace {

/// The embedded table, whose faults are ours.
base::CsvTable embeddedTable(std::string_view text, const std::string& file) {
  auto table = base::CsvTable::parse(std::string(text), file);
  TACTUS_CHECK(table.has_value());
  return std::move(*table);
}

double numberAt(const base::CsvTable& table, std::size_t row, std::size_t column) {
  const auto number = table.number(row, column);
  TACTUS_CHECK(number.has_value());
  return *number;
}

}  // namespace

std::vector<PublishedSpeed> publishedSpeeds() {
  const auto table = embeddedTable(table1Csv(), "table1.csv");
  std::vector<PublishedSpeed> speeds;
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    speeds.push_back({std::string(table.cell(row, 0)), std::string(table.cell(row, 1)), numberAt(table, row, 2),
                      numberAt(table, row, 3)});
  }
  return speeds;
}

std::vector<std::string> publishedVoteTerms() {
  const auto table = embeddedTable(table2Csv(), "table2.csv");
  return {table.columns().begin() + 1, table.columns().end()};
}

std::vector<PublishedVotes> publishedVotes() {
  const auto table = embeddedTable(table2Csv(), "table2.csv");
  std::vector<PublishedVotes> rows;
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    PublishedVotes votes{numberAt(table, row, 0), {}};
    for (std::size_t column = 1; column < table.columns().size(); ++column) {
      const auto count = table.integer(row, column);
      TACTUS_CHECK(count.has_value());
      votes.votes.push_back(static_cast<int>(*count));
    }
    rows.push_back(std::move(votes));
  }
  return rows;
}

}  // namespace tactus::experiments
