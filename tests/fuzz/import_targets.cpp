#include <string>

#include "core/base/check.h"
#include "core/exchange/import/import_model.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"

#include "tests/fuzz/fuzz_targets.h"

namespace tactus::fuzz {
namespace {

void importBytes(std::string_view bytes, exchange::ImportFormat format) {
  const auto file = exchange::ReadFile::read(std::string(bytes), "fuzzed", format);
  if (!file) {
    TACTUS_CHECK(!file.error().wanted.empty());
    return;
  }
  const auto names = file->outputs();
  for (std::size_t i = 0; i < names.size() && i < 2; ++i) {
    const auto model = file->model(names.size() > 1 ? names[i] : std::string());
    if (!model) continue;
    const auto compiled = fuzzy::compile(*model);
    TACTUS_CHECK(compiled.has_value());
    std::vector<double> point;
    for (const auto& input : model->inputs) point.push_back(input.min + 0.3 * (input.max - input.min));
    const auto result = compiled->evaluate(point);
    TACTUS_CHECK(!result.fired || (result.force_n >= model->output.min && result.force_n <= model->output.max));
    const auto again = model_io::parseModel(model_io::formatModel(*model), "written");
    TACTUS_CHECK(again.has_value() && again->model == *model);
  }
  TACTUS_CHECK(file->warnings().size() <= 101);
}

}  // namespace

void fuzzFll(std::string_view bytes) { importBytes(bytes, exchange::ImportFormat::kFll); }
void fuzzFcl(std::string_view bytes) { importBytes(bytes, exchange::ImportFormat::kFcl); }
void fuzzFis(std::string_view bytes) { importBytes(bytes, exchange::ImportFormat::kFis); }

}  // namespace tactus::fuzz
