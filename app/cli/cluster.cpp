#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_validity.h"

namespace tactus::cli {
namespace {

using base::JsonWriter;
using base::Result;

struct Column {
  std::vector<double> values;
  std::vector<std::string> warnings;
  std::string name;  ///< empty in a file without a header
};

/// The samples of the column, missing values refused with their place.
Result<Column> readColumn(const ClusterOptions& options) {
  TACTUS_TRY(const auto table, base::CsvTable::read(options.speeds, base::CsvTable::Header::kOptional));
  Column column;
  if (auto note = table.note()) column.warnings.push_back(std::move(*note));
  std::size_t index = 0;
  if (table.hasHeader()) {
    TACTUS_TRY(const auto found, table.require(options.column));
    index = found;
    column.name = options.column;
  } else {
    column.warnings.push_back(options.speeds + ": no header, the first column is taken");
  }
  column.values.reserve(table.rowCount());
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    TACTUS_TRY(const auto value, table.number(row, index));
    column.values.push_back(value);
  }
  return column;
}

std::string asJson(const elicitation::FcmResult& result, const elicitation::FcmValidity& validity,
                   const std::vector<std::string>& warnings) {
  JsonWriter json;
  json.beginObject().key("centres").values(result.centres).key("objective").value(result.objective);
  if (!result.objective) json.key("objective_log10").value(result.objective_log10);
  json.key("iterations").value(result.iterations).key("stop_reason").value(std::string(name(result.stop)));
  json.key("validity").beginObject().key("partition_coefficient").value(validity.partition_coefficient);
  json.key("modified_partition_coefficient").value(validity.modified_coefficient);
  json.key("partition_entropy").value(validity.partition_entropy).key("xie_beni").value(validity.xie_beni);
  json.key("fuzzy_silhouette").value(validity.fuzzy_silhouette);
  json.key("crisp_silhouette").value(validity.crisp_silhouette);
  json.key("sizes").beginArray(JsonWriter::Layout::kInline);
  for (const std::size_t size : validity.sizes) json.value(size);
  json.endArray().endObject().key("other_minima").beginArray();
  for (const auto& minimum : result.other_minima) {
    json.beginObject(JsonWriter::Layout::kInline).key("centres").values(minimum.centres);
    json.key("objective_ratio").value(minimum.objective_ratio).endObject();
  }
  json.endArray().key("warnings").values(warnings).endObject();
  return json.text();
}

/// `column` is empty for a file without a header.
std::string asText(const elicitation::FcmResult& result, const elicitation::FcmValidity& validity,
                   const std::string& column) {
  const std::string centre = column.empty() ? "center" : base::oneLine("center (" + column + ")");
  std::size_t samples = 0;
  for (const std::size_t size : validity.sizes) samples += size;
  std::string text = "cluster  " + padded(centre, 12, 2) + "nearest samples\n";
  for (std::size_t k = 0; k < result.centres.size(); ++k) {
    const double percent = 100 * static_cast<double>(validity.sizes[k]) / static_cast<double>(samples);
    text += padded(std::to_string(k + 1), 9, 2) +
            padded(base::formatFixed(result.centres[k], 3), std::max<std::size_t>(12, characters(centre) + 2), 2) +
            std::to_string(validity.sizes[k]) + " (" + base::formatFixed(percent, 1) + " %)\n";
  }
  return text + std::to_string(samples) + " samples; " + std::string(name(result.stop)) + " after " +
         std::to_string(result.iterations) + " iterations; partition coefficient " +
         base::formatFixed(validity.partition_coefficient, 3) + " (1 is clear-cut)\n";
}

}  // namespace

Result<Output> cluster(const ClusterOptions& options) {
  TACTUS_TRY(auto column, readColumn(options));
  if (options.clusters < 1) {
    return base::fail(base::ErrorCode::kValue, "-c", std::to_string(options.clusters),
                      "1 to " + std::to_string(elicitation::kMostClusters) + " clusters");
  }
  elicitation::FcmSettings settings;
  settings.clusters = static_cast<std::size_t>(options.clusters);
  settings.m = options.m;
  const auto result = elicitation::fuzzyCMeans(column.values, settings);
  if (!result) return inFile(result.error(), options.speeds);
  const auto validity = elicitation::fcmValidity(column.values, result->centres, options.m);
  auto& warnings = column.warnings;
  warnings.insert(warnings.end(), result->warnings.begin(), result->warnings.end());
  if (options.json) return Output{asJson(*result, validity, warnings), {}};
  return Output{asText(*result, validity, column.name), warnings};
}

}  // namespace tactus::cli
