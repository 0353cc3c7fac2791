#include <filesystem>
#include <string>

#include "core/base/check.h"
#include "core/base/json/json_document.h"
#include "core/base/tables/csv.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/bundle_check.h"
#include "core/model_io/model_file.h"

#include "tests/fuzz/fuzz_targets.h"

namespace tactus::fuzz {
namespace {

/// The values below `value`, with it.
std::size_t valuesIn(base::JsonValue value) {
  std::size_t count = 1;
  if (value.kind() != base::JsonKind::kArray && value.kind() != base::JsonKind::kObject) return count;
  for (const base::JsonValue child : value) count += valuesIn(child);
  return count;
}

}  // namespace

void fuzzModel(std::string_view bytes) {
  const auto read = model_io::parseModel(bytes, "fuzzed");
  if (!read) {
    TACTUS_CHECK(!read.error().wanted.empty());
    return;
  }
  TACTUS_CHECK(fuzzy::compile(read->model).has_value());
  const auto again = model_io::parseModel(model_io::formatModel(read->model), "written");
  TACTUS_CHECK(again.has_value() && again->model == read->model);
}

void fuzzManifest(std::string_view bytes) {
  const auto manifest = model_io::parseManifest(bytes, "fuzzed");
  if (!manifest) {
    TACTUS_CHECK(!manifest.error().wanted.empty());
    return;
  }
  for (const model_io::BundleFile& file : manifest->files) {
    const std::filesystem::path path = std::filesystem::path(file.path).lexically_normal();
    TACTUS_CHECK(path.is_relative() && !path.empty() && *path.begin() != "..");
  }
  const auto again = model_io::parseManifest(model_io::formatManifest(*manifest), "written");
  TACTUS_CHECK(again.has_value() && *again == *manifest);
}

void fuzzCsv(std::string_view bytes) {
  const auto table = base::CsvTable::parse(std::string(bytes), "fuzzed");
  if (!table) return;
  std::size_t characters = 0;
  for (std::size_t row = 0; row < table->rowCount(); ++row) {
    TACTUS_CHECK(table->line(row) > 0);
    for (std::size_t column = 0; column < table->columns().size(); ++column)
      characters += table->cell(row, column).size();
  }
  TACTUS_CHECK(characters <= 4 * bytes.size());
}

void fuzzJson(std::string_view bytes) {
  const auto document = base::JsonDocument::parse(bytes);
  if (document) TACTUS_CHECK(valuesIn(document->root()) <= bytes.size());
}

}  // namespace tactus::fuzz
