#include "core/store/name_cleaning.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/files/name_removal.h"
#include "core/base/files/checksums.h"
#include "core/base/json/json_writer.h"
#include "core/model_io/expert_removal.h"
#include "core/store/entry_tables.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"

namespace tactus::store {
namespace {

using study::RecordId;

/// `name` as it stands within the quotes of a JSON text.
std::string inJson(const std::string& name) {
  const std::string quoted = base::jsonString(name);
  return quoted.substr(1, quoted.size() - 2);
}

/// The word before the first colon, with the colon: what happened to the model (docs/study-file.md).
std::string_view kindOf(std::string_view label) {
  const auto colon = label.find(": ");
  if (colon == std::string_view::npos) return {};
  const std::string_view word = label.substr(0, colon);
  const bool is_kind = std::all_of(word.begin(), word.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
  return is_kind ? label.substr(0, colon + 2) : std::string_view();
}

std::string cleanedLabel(const std::string& label, const std::vector<std::string>& names) {
  if (!base::holdsName(label, names)) return label;
  const std::string kind(kindOf(label));
  return (base::holdsName(kind, names) ? std::string() : kind) + std::string(base::kRemovedName);
}

/// The rows of one column in which one of the names stands, in whatever form.
std::vector<std::pair<RecordId, std::string>> rowsNaming(Connection& connection, const FreeText& place,
                                                         const std::vector<std::string>& names) {
  std::string condition;
  for (std::size_t i = 1; i <= names.size(); ++i) {
    condition.append(i == 1 ? "" : " OR ").append("instr(").append(place.column).append(", ?");
    condition.append(std::to_string(i)).append(") > 0");
  }
  Query query(connection,
              "SELECT id, " + std::string(place.column) + " FROM " + std::string(place.table) + " WHERE " + condition);
  for (const auto& name : names) query.put(name);
  std::vector<std::pair<RecordId, std::string>> rows;
  while (query.next()) {
    const RecordId id = query.id();
    rows.emplace_back(id, query.text());
  }
  return rows;
}

void cleanColumn(Connection& connection, const FreeText& place, const NameCleaning& cleaning) {
  const auto rows = rowsNaming(connection, place, cleaning.names());
  if (rows.empty()) return;
  Query change(connection, update(connection, place.table, {{std::string(place.column), "?2"}}) + " WHERE id = ?1");
  for (const auto& [id, text] : rows) {
    const std::string clean = cleaning.cleaned(text);
    if (clean != text) change.put(id).put(clean).run();
  }
}

std::vector<std::int64_t> placesOfModels(Connection& connection) {
  Query query(connection, "SELECT place FROM model_version ORDER BY place");
  std::vector<std::int64_t> places;
  while (query.next()) places.push_back(query.integer());
  return places;
}

}  // namespace

NameCleaning::NameCleaning(std::vector<std::string> names) : names_(std::move(names)) {
  std::erase(names_, std::string());
  for (std::size_t i = names_.size(); i-- > 0;) {
    std::string spelled = inJson(names_[i]);
    if (spelled != names_[i]) names_.push_back(std::move(spelled));
  }
  std::sort(names_.begin(), names_.end());
  names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
}

std::string NameCleaning::cleaned(std::string_view text) const { return base::withoutNames(text, names_); }

bool NameCleaning::clean(ModelTexts& version) const {
  // Most versions name no person; a JSON text may spell a name with escapes.
  const bool may_name = base::holdsName(version.text, names_) || version.text.find("\\u") != std::string::npos ||
                        base::holdsName(version.label, names_) || base::holdsName(version.author, names_);
  if (!may_name) return false;
  const ModelTexts before = version;
  auto removal = model_io::withoutExperts(version.text, names_);
  version.text = std::move(removal.text);
  version.author = cleaned(version.author);
  // An edit is told with the expert's label.
  std::vector<std::string> told = std::move(removal.labels);
  told.insert(told.end(), names_.begin(), names_.end());
  version.label = cleanedLabel(version.label, told);
  return version.text != before.text || version.author != before.author || version.label != before.label;
}

const std::vector<FreeText>& freeTexts() {
  static const std::vector<FreeText> places = [] {
    std::vector<FreeText> all = {{"study", "name"},
                                 {"session", "consent_version"},
                                 {"session", "station"},
                                 {"session", "device"},
                                 {"session", "settings"},
                                 {"profile", "category"},
                                 {"profile", "handedness"},
                                 {"profile", "gloves"},
                                 {"profile", "tube_size"},
                                 {"profile", "haptic_experience"},
                                 {"profile", "comfort"},
                                 {"protocol", "author"},
                                 {"protocol", "reason"},
                                 {"depth_measurement", "author"},
                                 {"depth_measurement", "text"},
                                 {"event", "detail"},
                                 {"import_log", "source"},
                                 {"import_log", "detail"},
                                 {"incident", "detail"}};
    for (const std::string_view table : kEntryTables) all.push_back({table, "reason"});
    return all;
  }();
  return places;
}

long long cleanRecords(Connection& connection, const NameCleaning& cleaning, std::int64_t utc_ms) {
  if (cleaning.isEmpty()) return 0;
  for (const FreeText& place : freeTexts()) cleanColumn(connection, place, cleaning);
  long long changed = 0;
  Query read(connection, "SELECT author, label, text FROM model_version WHERE place = ?");
  Query change(connection, update(connection, "model_version",
                                  {{"author", "?2"},
                                   {"label", "?3"},
                                   {"text", "?4"},
                                   {"sha256", "?5"},
                                   {"cleaned_utc_ms", "min(?6, coalesce(cleaned_utc_ms, ?6))"}}) +
                               " WHERE place = ?1");
  for (const std::int64_t place : placesOfModels(connection)) {
    read.put(place);
    if (!read.next()) continue;
    ModelTexts version;
    version.author = read.text();
    version.label = read.text();
    version.text = read.text();
    read.reset();
    if (!cleaning.clean(version)) continue;
    change.put(place).put(version.author).put(version.label).put(version.text);
    change.put(base::sha256(version.text)).put(utc_ms).run();
    ++changed;
  }
  return changed;
}

std::vector<std::string> expertsOfModels(Connection& connection) {
  std::set<std::string> experts;
  Query read(connection, "SELECT text FROM model_version WHERE place = ?");
  for (const std::int64_t place : placesOfModels(connection)) {
    if (!read.put(place).next()) continue;
    for (auto& id : model_io::expertIds(read.text())) experts.insert(std::move(id));
    read.reset();
  }
  return {experts.begin(), experts.end()};
}

}  // namespace tactus::store
