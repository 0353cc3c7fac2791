#include <chrono>
#include <filesystem>

#include "app/cli/commands.h"
#include "app/session/known_forms.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/csv.h"
#include "core/base/json_writer.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"
#include "core/study/csv_tables.h"
#include "elicitation/model_builder.h"
#include "elicitation/ngt_variables.h"

namespace tactus::cli {
namespace {

using base::Result;
using elicitation::WeightPolicy;

Result<elicitation::WeightSettings> weightSettings(const std::string& word) {
  elicitation::WeightSettings settings;
  for (const auto policy :
       {WeightPolicy::kEqual, WeightPolicy::kYears, WeightPolicy::kCategory, WeightPolicy::kColumn}) {
    if (word != name(policy)) continue;
    settings.policy = policy;
    return settings;
  }
  const auto table = base::CsvTable::read(word);
  if (!table) {
    auto error = table.error();
    if (error.code == base::ErrorCode::kIo) error.wanted = "equal, years, category, column or a CSV file for --weights";
    return tl::unexpected(error);
  }
  auto weights = elicitation::readWeightTable(*table);
  if (!weights) return tl::unexpected(weights.error());
  settings.policy = WeightPolicy::kTable;
  settings.table = std::move(*weights);
  settings.table_file = word;
  return settings;
}

std::string summary(const BuildOptions& options, const elicitation::BuiltModel& built) {
  std::string text =
      options.out + ": " + built.model.name + "; experts " + std::to_string(built.model.experts.size()) + '\n';
  for (const auto& expert : built.model.experts) {
    text += "  " + expert.id + ": rules " + std::to_string(expert.rules.size()) + ", weight " +
            base::formatNumber(expert.weight) + '\n';
  }
  for (const auto& note : built.notes) text += "note: " + note + '\n';
  return text;
}

std::string asJson(const BuildOptions& options, const elicitation::BuiltModel& built) {
  base::JsonWriter json;
  json.beginObject().key("model").value(options.out).key("name").value(built.model.name);
  json.key("experts").beginArray();
  for (const auto& expert : built.model.experts) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("id").value(expert.id);
    json.key("rules").value(expert.rules.size()).key("weight").value(expert.weight).endObject();
  }
  json.endArray().key("notes").values(built.notes).endObject();
  return json.text();
}

}  // namespace

Result<Output> build(const BuildOptions& options) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(options.study, ignored)) {
    return tl::unexpected(
        base::Error{base::ErrorCode::kSchema, options.study, {}, "a file", "a folder with the CSV tables of a study"});
  }
  auto weights = weightSettings(options.weights);
  if (!weights) return tl::unexpected(weights.error());
  const auto tables = study::readStudyFolder(options.study, elicitation::ngtInputIds());
  if (!tables) return tl::unexpected(tables.error());

  elicitation::BuildSettings settings;
  settings.created_utc = base::formatUtc(std::chrono::system_clock::now());
  settings.generator = kGenerator;
  settings.speed.alpha = options.alpha;
  settings.speed.trim = options.trim;
  const std::string weights_file = weights->table_file;
  settings.weights = std::move(*weights);
  settings.terms = options.own_terms ? elicitation::SpeedTermsOf::kOwn : elicitation::SpeedTermsOf::kAveraged;
  const auto built = elicitation::buildModel(tables->study, session::knownForms(), settings);
  if (!built) {
    const bool about_weights = !built.error().file.empty() && built.error().file == weights_file;
    return about_weights ? tl::unexpected(built.error()) : study::inStudyFolder(built.error(), options.study);
  }
  if (auto written = model_io::writeModel(built->model, options.out); !written) return tl::unexpected(written.error());
  return Output{options.json ? asJson(options, *built) : summary(options, *built), tables->notes};
}

}  // namespace tactus::cli
