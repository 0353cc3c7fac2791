#include "elicitation/agreement/agreement.h"

#include <algorithm>

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "app/session/study_source.h"
#include "app/session/table_words.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "core/study/csv_tables.h"

namespace tactus::cli {
namespace {

using base::JsonWriter;
using base::Result;
using elicitation::AgreementData;
using elicitation::OrReason;

struct Rated {
  AgreementData data;
  std::string source;  ///< `answers`, `judgements` or `counts`
  std::vector<std::string> warnings;
};

Result<Rated> rated(Result<AgreementData> data, std::string source, const std::string& file,
                    std::vector<std::string> notes) {
  if (data) return Rated{std::move(*data), std::move(source), std::move(notes)};
  auto error = data.error();
  error.file = file;
  return tl::unexpected(std::move(error));
}

Result<Rated> readCounts(const base::CsvTable& table, const std::vector<std::string>& terms) {
  TACTUS_TRY(const auto votes, elicitation::readVoteTable(table, terms));
  Rated out{elicitation::agreementData(votes.steps, terms), "counts", {}};
  for (const auto& column : votes.ignored) {
    out.warnings.push_back(table.file() + ": column " + base::quoted(column) + " is ignored");
  }
  return out;
}

Result<Rated> readTable(const base::CsvTable& table, const AgreementOptions& options) {
  TACTUS_TRY(const auto about, session::procedureOfTable(options.file, options.pack));
  std::vector<std::string> terms;
  for (const auto& term : about->output.terms) terms.push_back(term.id);
  if (elicitation::isVoteTable(table, terms)) return readCounts(table, terms);
  std::vector<std::string> notes;
  if (table.find("item")) {
    TACTUS_TRY(const auto answers, session::readAnswerTable(table, notes));
    return rated(elicitation::agreementData(answers, options.form, session::knownForms(*about), terms), "answers",
                 options.file, std::move(notes));
  }
  if (table.find("series") || table.find("term")) {
    TACTUS_TRY(const auto judgements, session::readJudgementTable(table, notes));
    return rated(elicitation::agreementData(judgements, options.series, terms), "judgements", options.file,
                 std::move(notes));
  }
  return tl::unexpected(base::Error{
      base::ErrorCode::kSchema, options.file, "header", "the columns " + base::listed(table.columns()),
      "answers (" + base::joined(study::kAnswerColumns, ",") + "), judgements (" +
          base::joined(study::kJudgementColumns, ",") + ") or counts (force_n," + base::joined(terms, ",") + ")"});
}

Result<Rated> readRated(const AgreementOptions& options) {
  TACTUS_TRY(const auto table, base::CsvTable::read(options.file));
  auto rated = readTable(table, options);
  if (auto note = table.note(); note && rated) rated->warnings.push_back(std::move(*note));
  return rated;
}

/// p values as people read them.
std::string probability(double p) { return p < 0.0001 ? "below 0.0001" : base::formatFixed(p, 4); }

std::string valueOrReason(const OrReason<double>& value) {
  return value ? base::formatFixed(*value, 4) : "none: " + value.error();
}

std::string kappaText(const OrReason<elicitation::FleissKappa>& kappa) {
  if (!kappa) return "none: " + kappa.error();
  return base::formatFixed(kappa->kappa, 4) + " (z " + base::formatFixed(kappa->z, 2) + ", p " + probability(kappa->p) +
         ")";
}

std::string concordanceText(const OrReason<elicitation::KendallW>& w) {
  if (!w) return "none: " + w.error();
  std::string text = base::formatFixed(w->w, 4) + " (chi-square " + base::formatFixed(w->chi_square, 2) + ", " +
                     std::to_string(w->degrees) + " degrees of freedom, p " + probability(w->p) + "; " +
                     std::to_string(w->units) + " units";
  if (w->dropped_units > 0) {
    text += ", " + std::to_string(w->dropped_units) + " dropped that not every rater rated";
  }
  return text + ")";
}

std::string itemsText(const AgreementData& data, const elicitation::Agreement& agreement) {
  std::string text = "votes for " + base::oneLine(base::joined(data.terms, ", ")) + ":\n" +
                     "unit       ratings  consensus  entropy_bits  spread_terms  votes\n";
  for (std::size_t i = 0; i < data.units.size(); ++i) {
    const auto& votes = data.counts.units[i];
    const auto& item = agreement.items[i];
    text += padded(data.units[i].name, 11) + padded(std::to_string(elicitation::ratingsOf(votes)), 9);
    text += padded(item ? base::formatFixed(item->consensus, 3) : "-", 11);
    text += padded(item ? base::formatFixed(item->entropy_bits, 3) : "-", 14);
    text += padded(item ? std::to_string(item->spread_terms) : "-", 14);
    std::vector<std::string> counts;
    for (const int count : votes) counts.push_back(std::to_string(count));
    text += base::joined(counts, " ") + '\n';
  }
  return text;
}

std::string asText(const AgreementData& data, const elicitation::Agreement& agreement) {
  std::string text = "ordinal Krippendorff alpha  " + valueOrReason(agreement.alpha_ordinal) +
                     "  (1 full agreement, 0 chance)\n" + std::to_string(data.units.size()) + " units, " +
                     (data.ratings ? std::to_string(data.raters.size()) + " raters, " : "") +
                     std::to_string(agreement.ratings) + " ratings\n\n" + itemsText(data, agreement) + '\n';
  text += "interval Krippendorff alpha " + valueOrReason(agreement.alpha_interval) + '\n';
  text += "nominal Krippendorff alpha  " + valueOrReason(agreement.alpha_nominal) + '\n';
  text += wrapped(concordanceText(agreement.kendall_w), "Kendall's W                 ", 28);
  text += wrapped(kappaText(agreement.fleiss_kappa), "Fleiss' kappa               ", 28);
  text += wrapped(elicitation::nominalCaution(), "", 0);
  for (const auto& note : data.notes) text += wrapped(note, "note: ", 6);
  return text;
}

void writeItems(JsonWriter& json, const AgreementData& data, const elicitation::Agreement& agreement) {
  json.key("items").beginArray();
  for (std::size_t i = 0; i < data.units.size(); ++i) {
    const auto& unit = data.units[i];
    json.beginObject(JsonWriter::Layout::kInline).key("unit").value(unit.name);
    if (unit.force_n) json.key("force_n").value(*unit.force_n);
    if (unit.item) json.key("item").value(*unit.item);
    if (!unit.text.empty()) json.key("text").value(unit.text);
    json.key("votes").beginArray();
    for (const int count : data.counts.units[i]) json.value(count);
    json.endArray();
    const auto& item = agreement.items[i];
    json.key("consensus");
    item ? json.value(item->consensus) : json.null();
    json.key("entropy_bits");
    item ? json.value(item->entropy_bits) : json.null();
    json.key("spread_terms");
    item ? json.value(item->spread_terms) : json.null();
    json.endObject();
  }
  json.endArray();
}

/// Why a measure is null, for each that is.
void writeReasons(JsonWriter& json, const elicitation::Agreement& agreement) {
  json.key("reasons").beginObject();
  const auto reason = [&json](std::string_view key, const auto& measure) {
    if (!measure) json.key(key).value(measure.error());
  };
  reason("fleiss_kappa", agreement.fleiss_kappa);
  reason("krippendorff_alpha", agreement.alpha_ordinal);
  reason("kendall_w", agreement.kendall_w);
  json.endObject();
}

std::string asJson(const Rated& rated, const AgreementOptions& options, const elicitation::Agreement& agreement) {
  const auto& data = rated.data;
  const auto& kappa = agreement.fleiss_kappa;
  const auto& w = agreement.kendall_w;
  JsonWriter json;
  json.beginObject().key("fleiss_kappa");
  kappa ? json.value(kappa->kappa) : json.null();
  json.key("krippendorff_alpha").beginObject(JsonWriter::Layout::kInline);
  json.key("nominal").value(agreement.alpha_nominal).key("ordinal").value(agreement.alpha_ordinal);
  json.key("interval").value(agreement.alpha_interval).endObject().key("kendall_w");
  w ? json.value(w->w) : json.null();

  json.key("source").value(rated.source);
  if (rated.source == "answers") json.key("form").value(data.form);
  if (rated.source == "judgements") json.key("series").value(options.series);
  json.key("terms").values(data.terms).key("units").value(data.units.size()).key("raters");
  data.ratings ? json.values(data.raters) : json.null();
  json.key("ratings").value(static_cast<long long>(agreement.ratings));
  if (kappa) {
    json.key("fleiss").beginObject(JsonWriter::Layout::kInline).key("z").value(kappa->z).key("p").value(kappa->p);
    json.key("standard_error").value(kappa->standard_error).endObject();
  }
  if (w) {
    json.key("kendall").beginObject(JsonWriter::Layout::kInline).key("chi_square").value(w->chi_square);
    json.key("degrees").value(w->degrees).key("p").value(w->p).key("raters").value(w->raters);
    json.key("units").value(w->units).key("dropped_units").value(w->dropped_units).endObject();
  }
  writeReasons(json, agreement);
  writeItems(json, data, agreement);
  std::vector<std::string> notes = data.notes;
  notes.insert(notes.end(), rated.warnings.begin(), rated.warnings.end());
  json.key("notes").values(notes).endObject();
  return json.text();
}

}  // namespace

Result<Output> agreement(const AgreementOptions& options) {
  TACTUS_TRY(const auto rated, readRated(options));
  const auto result = elicitation::agreement(rated.data);
  if (options.json) return Output{asJson(rated, options, result), {}};
  return Output{asText(rated.data, result), rated.warnings};
}

}  // namespace tactus::cli
