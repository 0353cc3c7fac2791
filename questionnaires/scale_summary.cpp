#include "questionnaires/scale_summary.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "core/base/tables/csv.h"
#include "questionnaires/form_file.h"

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

namespace {

constexpr double kHalfPrintedDigit = 0.005 + 1e-9;  // two decimals are printed

/// Searches the multisets of `left` more answers of at least `lowest`, the largest of which is row.max.
class Search {
 public:
  Search(const ScaleSummary& row, std::size_t n, int points) : row_(row), n_(static_cast<double>(n)), points_(points) {}

  bool fits(std::size_t left, int lowest, double sum, double squares) const {
    if (left == 0) {
      const double mean = sum / n_;
      const double sd = std::sqrt(std::max(0.0, (squares - sum * mean) / (n_ - 1)));
      return lowest == row_.max && std::abs(mean - row_.mean) <= kHalfPrintedDigit &&
             std::abs(sd - row_.sd) <= kHalfPrintedDigit;
    }
    for (int answer = lowest; answer <= std::min(row_.max, points_); ++answer) {
      if (fits(left - 1, answer, sum + answer, squares + answer * answer)) return true;
    }
    return false;
  }

 private:
  const ScaleSummary& row_;
  double n_;
  int points_;
};

}  // namespace

std::vector<ScaleSummary> summarize(const ScaleForm& form, std::span<const study::AnswerRecord> answers) {
  std::set<study::RecordId> superseded;
  for (const auto& answer : answers) {
    if (answer.entry.supersedes) superseded.insert(*answer.entry.supersedes);
  }
  std::vector<ScaleSummary> rows;
  for (const auto& item : form.items) {
    std::vector<double> points;
    for (const auto& answer : answers) {
      const bool counts = answer.form == form.id && answer.form_version == form.version && answer.item == item.number &&
                          answer.status == study::Answer::Status::kAnswered && !superseded.contains(answer.entry.id);
      int point = 0;
      const char* const end = answer.value.data() + answer.value.size();
      if (counts && std::from_chars(answer.value.data(), end, point).ptr == end) points.push_back(point);
    }
    ScaleSummary row{item.number, points.size(), 0, 0, 0, 0};
    if (!points.empty()) {
      const auto [least, most] = std::minmax_element(points.begin(), points.end());
      row.mean = base::mean(points);
      row.sd = base::standardDeviation(points);
      row.min = static_cast<int>(*least);
      row.max = static_cast<int>(*most);
    }
    rows.push_back(row);
  }
  return rows;
}

bool isPossible(const ScaleSummary& row, std::size_t n, int points) {
  if (n < 2 || row.min < 1 || row.max > points || row.min > row.max) return false;
  // The least answer is row.min; the others follow in ascending order.
  return Search(row, n, points).fits(n - 1, row.min, row.min, row.min * row.min);
}

}  // namespace tactus::questionnaires
