#include "core/store/withdrawn_codes.h"

#include <algorithm>
#include <set>

#include "core/base/clock.h"
#include "core/base/files/checksums.h"
#include "core/store/query.h"
#include "core/store/recoding.h"
#include "core/store/record_checksum.h"

namespace tactus::store {
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
