#include "core/store/withdrawn_codes.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/clock.h"
#include "core/base/files/checksums.h"
#include "core/base/files/name_removal.h"
#include "core/base/json/json_writer.h"
#include "core/model_io/expert_removal.h"
#include "core/store/entries.h"
#include "core/store/felt_events.h"
#include "core/store/person_codes.h"
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

/// The rows of one column in which one of the names stands, in whatever form. Without those of a seal, which a change
/// would break.
std::vector<std::pair<RecordId, std::string>> rowsNaming(Connection& connection, const FreeText& place,
                                                         const std::vector<std::string>& names) {
  std::string condition;
  for (std::size_t i = 1; i <= names.size(); ++i) {
    condition.append(i == 1 ? "" : " OR ").append("instr(").append(place.column).append(", ?");
    condition.append(std::to_string(i)).append(") > 0");
  }
  const std::string but_seals = place.table == "event" ? std::string(" AND NOT ") + kIsOfSeal : std::string();
  Query query(connection, "SELECT id, " + std::string(place.column) + " FROM " + std::string(place.table) + " WHERE (" +
                              condition + ")" + but_seals);
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

namespace {

using base::ErrorCode;
using study::RecordId;

constexpr std::size_t kSaltBytes = 16;
constexpr std::size_t kHashBytes = 32;

/// SHA-256 as bytes.
std::string digest(std::string_view bytes) {
  const std::string digits = base::sha256(bytes);
  const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string out;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    out += static_cast<char>(value(digits[i]) * 16 + value(digits[i + 1]));
  }
  return out;
}

std::string hashOf(std::string_view salt, std::string_view code) {
  return digest(std::string(salt) + std::string(code));
}

std::set<std::string> split(std::string_view hashes) {
  std::set<std::string> out;
  for (; hashes.size() >= kHashBytes; hashes.remove_prefix(kHashBytes)) out.emplace(hashes.substr(0, kHashBytes));
  return out;
}

void putBytes(Query& query, const std::string& bytes) {
  if (bytes.empty()) {
    query.put(std::optional<double>());
  } else {
    query.putBlob(bytes);
  }
}

}  // namespace

TombstoneRow tombstoneFor(const RecordId& person, std::int64_t utc_ms, const std::vector<std::string>& codes) {
  TombstoneRow out{person, utc_ms, {}, {}};
  if (codes.empty()) return out;
  out.code_salt = digest("tactus tombstone " + study::toText(person)).substr(0, kSaltBytes);
  std::set<std::string> hashes;
  for (const auto& code : codes) hashes.insert(hashOf(out.code_salt, code));
  for (const auto& hash : hashes) out.code_hashes += hash;
  return out;
}

TombstoneRow joined(const TombstoneRow& one, const TombstoneRow& other) {
  TombstoneRow out = one;
  out.utc_ms = std::min(one.utc_ms, other.utc_ms);
  if (out.code_salt.empty()) out.code_salt = other.code_salt;
  std::set<std::string> hashes = split(one.code_hashes);
  hashes.merge(split(other.code_hashes));
  out.code_hashes.clear();
  for (const auto& hash : hashes) out.code_hashes += hash;
  return out;
}

std::vector<TombstoneRow> readTombstones(Connection& connection) {
  Query query(connection, "SELECT t.person_id, t.utc_ms, t.code_salt, t.code_hash, " +
                              fitsChecksum(connection, "tombstone", "t") +
                              " FROM tombstone AS t ORDER BY t.utc_ms, t.person_id");
  std::vector<TombstoneRow> found;
  while (query.next()) {
    TombstoneRow row;
    row.person = query.id();
    row.utc_ms = query.integer();
    row.code_salt = query.text();
    row.code_hashes = query.text();
    query.requireIntact("tombstone", row.person);
    found.push_back(std::move(row));
  }
  return found;
}

void noteErasure(Connection& connection, const RecordId& person, std::int64_t utc_ms) {
  Query note(connection,
             "INSERT INTO erasure (person_id, utc_ms) SELECT ?1, ?2"
             " WHERE NOT EXISTS (SELECT 1 FROM erasure WHERE person_id = ?1)");
  note.put(person).put(utc_ms).run();
}

void leaveTombstone(Connection& connection, const TombstoneRow& tombstone) {
  const auto there = readTombstones(connection);
  const auto old =
      std::find_if(there.begin(), there.end(), [&](const auto& row) { return row.person == tombstone.person; });
  if (old == there.end()) {
    Query insert(connection, insertion(connection, "tombstone"));
    insert.put(tombstone.person).put(tombstone.utc_ms);
    putBytes(insert, tombstone.code_salt);
    putBytes(insert, tombstone.code_hashes);
    insert.run();
    noteErasure(connection, tombstone.person, tombstone.utc_ms);
    return;
  }
  const TombstoneRow both = joined(*old, tombstone);
  if (both.utc_ms == old->utc_ms && both.code_hashes == old->code_hashes) return;
  noteErasure(connection, tombstone.person, both.utc_ms);
  Query change(connection,
               update(connection, "tombstone", {{"utc_ms", "?2"}, {"code_salt", "?3"}, {"code_hash", "?4"}}) +
                   " WHERE person_id = ?1");
  change.put(tombstone.person).put(both.utc_ms);
  putBytes(change, both.code_salt);
  putBytes(change, both.code_hashes);
  change.run();
}

std::string unfinishedErasure(Connection& connection) {
  Query count(connection, "SELECT count(*) FROM erasure");
  count.next();
  const auto persons = count.integer();
  if (persons == 0) return {};
  return "the erasure of " + std::to_string(persons) + (persons == 1 ? " participant" : " participants") +
         " who withdrew was interrupted; finish it: tactus study erase " + shellWord(connection.path());
}

const TombstoneRow* withdrawnWith(const std::vector<TombstoneRow>& tombstones, std::string_view code) {
  for (const TombstoneRow& row : tombstones) {
    if (row.code_hashes.empty()) continue;
    const std::string hash = hashOf(row.code_salt, code);
    for (std::size_t at = 0; at < row.code_hashes.size(); at += kHashBytes) {
      if (row.code_hashes.compare(at, kHashBytes, hash) == 0) return &row;
    }
  }
  return nullptr;
}

std::string describeWithdrawn(std::string_view code, const TombstoneRow& tombstone) {
  const std::chrono::system_clock::time_point when{std::chrono::milliseconds(tombstone.utc_ms)};
  return "the code " + base::quoted(code) + " of a participant who withdrew on " + base::formatUtc(when);
}

void refuseWithdrawnCode(Connection& connection, std::string_view code) {
  const auto tombstones = readTombstones(connection);
  if (const auto* row = withdrawnWith(tombstones, code); row != nullptr) {
    refuse(ErrorCode::kValue, {}, describeWithdrawn(code, *row),
           "a person who has not taken back their consent; another person needs another code");
  }
}

std::vector<std::string> codesOf(Connection& connection, const RecordId& person) {
  Query query(connection,
              "SELECT code FROM (SELECT 0 AS later, 0 AS utc_ms, id, code FROM person WHERE id = ?1"
              " UNION ALL SELECT 1, utc_ms, id, code FROM person_code WHERE person_id = ?1)"
              " ORDER BY later, utc_ms, id");
  query.put(person);
  std::vector<std::string> codes;
  while (query.next()) {
    std::string code = query.text();
    if (std::find(codes.begin(), codes.end(), code) == codes.end()) codes.push_back(std::move(code));
  }
  return codes;
}

std::vector<std::string> codesOfNobodyElse(Connection& connection, const RecordId& person,
                                           const std::vector<std::string>& codes) {
  Query query(connection,
              "SELECT 1 FROM person WHERE code = ?2 AND id <> ?1"
              " UNION ALL SELECT 1 FROM person_code WHERE code = ?2 AND person_id <> ?1");
  std::vector<std::string> own;
  for (const auto& code : codes) {
    query.put(person).put(code);
    if (!query.next()) own.push_back(code);
    query.reset();
  }
  return own;
}

}  // namespace tactus::store
