#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <thread>

#include "app/bundle/bounded_table.h"
#include "core/analysis/sample_points.h"
#include "core/base/error.h"
#include "core/base/in_parallel.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/fuzzy/batch.h"

namespace tactus::bundle {
namespace {

using Lines = std::vector<std::vector<double>>;

constexpr std::size_t kMostRows = 100'000'000;  // of a file that is read

std::size_t nodesOf(const Lines& lines) {
  std::size_t nodes = 1;
  for (const auto& one : lines) {
    if (one.size() > kMostRows || nodes > kMostRows) return kMostRows + 1;
    nodes *= one.size();
  }
  return nodes;
}

/// Drops every second inner line of the input with the most lines, until the grid fits.
Lines thinned(Lines lines, std::size_t most_nodes) {
  while (nodesOf(lines) > most_nodes) {
    auto& longest =
        *std::max_element(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    if (longest.size() <= 2) break;
    std::vector<double> kept;
    for (std::size_t k = 0; k < longest.size(); ++k) {
      if (k % 2 == 0 || k + 1 == longest.size()) kept.push_back(longest[k]);
    }
    longest = std::move(kept);
  }
  return lines;
}

/// Calls `visit(point)` for every node in order.
template <class Visit>
void forEachNode(const Lines& lines, Visit&& visit) {
  std::vector<std::size_t> index(lines.size(), 0);
  std::vector<double> point(lines.size());
  for (bool more = true; more;) {
    for (std::size_t i = 0; i < lines.size(); ++i) point[i] = lines[i][index[i]];
    visit(point);
    more = false;
    for (std::size_t i = lines.size(); i-- > 0 && !more;) {
      more = ++index[i] < lines[i].size();
      if (!more) index[i] = 0;
    }
  }
}

}  // namespace

double ForceTable::force(std::span<const double> point) const {
  std::array<std::size_t, fuzzy::kMostInputs> low{};
  std::array<double, fuzzy::kMostInputs> share{};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& line = lines[i];
    const double x = std::clamp(point[i], line.front(), line.back());
    const auto above = std::upper_bound(line.begin() + 1, line.end() - 1, x);
    low[i] = static_cast<std::size_t>(above - line.begin()) - 1;
    share[i] = (x - line[low[i]]) / (line[low[i] + 1] - line[low[i]]);
  }
  double sum = 0;
  for (std::size_t corner = 0; corner < (std::size_t{1} << lines.size()); ++corner) {
    double weight = 1;
    std::size_t node = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const bool upper = (corner >> i & 1U) != 0;
      weight *= upper ? share[i] : 1 - share[i];
      node = node * lines[i].size() + low[i] + (upper ? 1 : 0);
    }
    if (weight != 0) sum += weight * force_n[node];
  }
  return sum;
}

std::vector<std::vector<double>> vertexLines(const fuzzy::ForceModel& model, std::size_t most_nodes) {
  Lines lines = analysis::sortedVertices(model);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].insert(lines[i].end(), {model.inputs[i].min, model.inputs[i].max});
    std::sort(lines[i].begin(), lines[i].end());
    lines[i].erase(std::unique(lines[i].begin(), lines[i].end()), lines[i].end());
  }
  return thinned(std::move(lines), most_nodes);
}

ForceTable forceTable(const fuzzy::CompiledModel& compiled, std::vector<std::vector<double>> lines) {
  constexpr std::size_t kAtOnce = 4096;
  ForceTable table;
  table.lines = std::move(lines);
  const std::size_t nodes = nodesOf(table.lines);
  table.force_n.resize(nodes);
  base::inParallel((nodes + kAtOnce - 1) / kAtOnce, std::thread::hardware_concurrency(), [&](std::size_t part) {
    const std::size_t first = part * kAtOnce;
    const std::size_t count = std::min(kAtOnce, nodes - first);
    std::vector<std::vector<double>> inputs(table.lines.size(), std::vector<double>(count));
    std::size_t stride = nodes;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto& line = table.lines[i];
      stride /= line.size();
      for (std::size_t k = 0; k < count; ++k) inputs[i][k] = line[(first + k) / stride % line.size()];
    }
    const std::vector<std::span<const double>> columns(inputs.begin(), inputs.end());
    std::vector<std::uint8_t> fired(count);
    fuzzy::evaluateBatch(compiled, columns, {std::span(table.force_n).subspan(first, count), fired});
  });
  return table;
}

std::string formatTable(const fuzzy::ForceModel& model, const ForceTable& table) {
  std::vector<std::string> columns;
  for (const fuzzy::Variable& input : model.inputs) columns.push_back(input.id);
  columns.emplace_back("force");
  base::CsvWriter csv(columns);
  std::size_t node = 0;
  forEachNode(table.lines, [&](const std::vector<double>& point) {
    for (const double value : point) csv.cell(value);
    csv.cell(table.force_n[node++]).endRow();
  });
  return csv.text();
}

base::Result<ForceTable> parseTable(const fuzzy::ForceModel& model, std::string text, const std::string& file) {
  TACTUS_TRY(const auto csv, base::CsvTable::parse(std::move(text), file));
  std::vector<std::size_t> columns;
  for (const fuzzy::Variable& input : model.inputs) {
    TACTUS_TRY(const auto column, csv.require(input.id));
    columns.push_back(column);
  }
  TACTUS_TRY(const auto force, csv.require("force"));
  columns.push_back(force);

  ForceTable table;
  table.lines.resize(model.inputs.size());
  std::vector<std::vector<double>> rows(csv.rowCount());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const std::size_t column : columns) {
      TACTUS_TRY(const auto value, csv.number(r, column));
      rows[r].push_back(value);
    }
    for (std::size_t i = 0; i < table.lines.size(); ++i) table.lines[i].push_back(rows[r][i]);
    table.force_n.push_back(rows[r].back());
  }
  for (auto& line : table.lines) {
    std::sort(line.begin(), line.end());
    line.erase(std::unique(line.begin(), line.end()), line.end());
  }
  const bool plain = std::all_of(table.lines.begin(), table.lines.end(), [](const auto& l) { return l.size() >= 2; });
  std::size_t wrong = 0;
  std::size_t node = 0;
  if (plain && nodesOf(table.lines) == rows.size()) {
    forEachNode(table.lines, [&](const std::vector<double>& point) {
      wrong += std::equal(point.begin(), point.end(), rows[node].begin()) ? 0 : 1;
      ++node;
    });
    if (wrong == 0) return table;
  }
  return tl::unexpected(base::Error{base::ErrorCode::kData,
                                    file,
                                    {},
                                    "rows that are no grid",
                                    "every node of a grid once, the last input running fastest"});
}

}  // namespace tactus::bundle
