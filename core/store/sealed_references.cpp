#include "core/store/sealed_references.h"

#include <algorithm>
#include <limits>
#include <set>
#include <sodium.h>
#include <utility>

#include "core/base/files/checksums.h"
#include "core/base/files/name_removal.h"
#include "core/base/text.h"
#include "core/store/felt_events.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/query.h"
#include "core/store/withdrawal.h"

namespace tactus::store {

using base::ErrorCode;
using base::JsonMembers;
using base::JsonWriter;
using base::required;
using base::Result;
using study::EventRecord;

namespace {

constexpr std::string_view kSealMethod = "argon2id13-xchacha20poly1305";
constexpr std::string_view kSealPlace = "sealed reference";

constexpr std::uint64_t kOperations = 3;
constexpr std::uint64_t kMemoryBytes = std::uint64_t{64} << 20U;
// What a file may ask of the machine that opens it.
constexpr std::uint64_t kMostOperations = 16;
constexpr std::uint64_t kMostMemoryBytes = std::uint64_t{1} << 30U;

constexpr std::size_t kKeyBytes = crypto_aead_xchacha20poly1305_ietf_KEYBYTES;
constexpr std::size_t kNonceBytes = crypto_aead_xchacha20poly1305_ietf_NPUBBYTES;
constexpr std::size_t kTagBytes = crypto_aead_xchacha20poly1305_ietf_ABYTES;

constexpr std::size_t kShortestPassphrase = 8;
constexpr std::size_t kLongestPassphrase = 500;

const unsigned char* rawOf(const std::string& text) { return reinterpret_cast<const unsigned char*>(text.data()); }
unsigned char* rawOf(std::string& text) { return reinterpret_cast<unsigned char*>(text.data()); }

std::string randomBytes(std::size_t count) {
  std::string out(count, '\0');
  randombytes_buf(out.data(), out.size());
  return out;
}

/// A key that leaves the memory with its owner.
struct Key {
  std::string bytes = std::string(kKeyBytes, '\0');

  Key() = default;
  Key(const Key&) = delete;
  Key& operator=(const Key&) = delete;
  ~Key() { sodium_memzero(bytes.data(), bytes.size()); }
};

Result<void> prepareSodium() {
  if (sodium_init() >= 0) return {};
  return base::fail(ErrorCode::kIo, std::string(kSealPlace), "no random numbers of the system",
                    "a system that has them");
}

/// Only after prepareSodium.
Result<void> derive(Key& key, const SealedReference& reference, const std::string& passphrase) {
  if (passphrase.size() < kShortestPassphrase || passphrase.size() > kLongestPassphrase) {
    return base::fail(ErrorCode::kValue, "passphrase", "one of " + std::to_string(passphrase.size()) + " bytes",
                      "8 to 500 bytes of text");
  }
  if (crypto_pwhash(rawOf(key.bytes), key.bytes.size(), passphrase.data(), passphrase.size(), rawOf(reference.salt),
                    reference.operations, static_cast<std::size_t>(reference.memory_bytes),
                    crypto_pwhash_ALG_ARGON2ID13) != 0) {
    return base::fail(ErrorCode::kLimit, std::string(kSealPlace), "not enough memory to derive the key",
                      std::to_string(reference.memory_bytes >> 20U) + " MiB of free memory");
  }
  return {};
}

std::string base64Of(const std::string& bytes) {
  std::string out(sodium_base64_encoded_len(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
  sodium_bin2base64(out.data(), out.size(), rawOf(bytes), bytes.size(), sodium_base64_VARIANT_ORIGINAL);
  out.pop_back();  // the final zero
  return out;
}

/// The bytes of a base64 text, at least `least` and at most `most` of them.
void readBytes(JsonMembers& members, std::string_view key, std::string& target, std::size_t least, std::size_t most) {
  std::string text;
  members.text(required(key), text);
  std::string out(text.size(), '\0');
  std::size_t size = 0;
  if (sodium_base642bin(rawOf(out), out.size(), text.data(), text.size(), nullptr, &size, nullptr,
                        sodium_base64_VARIANT_ORIGINAL) != 0 ||
      size < least || size > most) {
    members.refuse(key, "base64 of " + std::to_string(least) +
                            (least == most ? std::string() : " to " + std::to_string(most)) + " bytes");
    return;
  }
  out.resize(size);
  target = std::move(out);
}

/// What can be read without the passphrase, into the open object.
void writeHeader(const SealedReference& record, JsonWriter& json) {
  json.key("method").value(kSealMethod).key("sha256").value(record.sha256).key("late").value(record.late);
  if (!record.note.empty()) json.key("note").value(record.note);
  json.key("conditions").beginObject(JsonWriter::Layout::kInline);
  for (const auto& [input, value] : record.conditions) json.key(input).value(value);
  json.endObject();
  json.key("operations").value(static_cast<std::size_t>(record.operations));
  json.key("memory_bytes").value(static_cast<std::size_t>(record.memory_bytes));
  json.key("salt").value(base64Of(record.salt));
}

/// What the authentication tag covers beside the content.
std::string boundTextOf(const SealedReference& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("sealed_utc_ms");
  json.value(static_cast<long long>(record.entry.when.utc_ms));
  writeHeader(record, json);
  return json.endObject().text();
}

EventRecord eventOf(const SealedReference& record) {
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline);
  writeHeader(record, json);
  json.key("nonce").value(base64Of(record.nonce)).key("cipher").value(base64Of(record.cipher));
  return eventWith(record.entry, kSealedKind, json.endObject());
}

Result<SealedReference> sealedReferenceOf(const EventRecord& event) {
  return recordOf<SealedReference>(event, [](auto& out, JsonMembers& members, auto&) {
    const std::string_view methods[] = {kSealMethod};
    members.word(required("method"), methods);
    members.text(required("sha256"), out.sha256);
    members.flag(required("late"), out.late);
    members.text("note", out.note);
    members.numbers(required("conditions"), out.conditions, base::kAnyNumber);
    members.integer(required("operations"), out.operations);
    members.integer(required("memory_bytes"), out.memory_bytes);
    if (out.operations < crypto_pwhash_OPSLIMIT_MIN || out.operations > kMostOperations) {
      members.refuse("operations", "1 to 16");
    }
    if (out.memory_bytes < crypto_pwhash_MEMLIMIT_MIN || out.memory_bytes > kMostMemoryBytes) {
      members.refuse("memory_bytes", "8192 bytes to 1 GiB");
    }
    readBytes(members, "salt", out.salt, crypto_pwhash_SALTBYTES, crypto_pwhash_SALTBYTES);
    readBytes(members, "nonce", out.nonce, kNonceBytes, kNonceBytes);
    readBytes(members, "cipher", out.cipher, kTagBytes, kTagBytes + kMostSealedBytes);
  });
}

EventRecord eventOf(const SealOpening& record) {
  std::vector<std::string> versions;
  for (const auto& id : record.versions) versions.push_back(study::toText(id));
  JsonWriter json;
  json.beginObject(JsonWriter::Layout::kInline).key("reference").value(study::toText(record.reference));
  json.key("early").value(record.early).key("content").value(record.content).key("versions").values(versions);
  json.key("records").beginObject(JsonWriter::Layout::kInline);
  for (const auto& [session, count] : record.records) json.key(study::toText(session)).value(count);
  json.endObject();
  return eventWith(record.entry, kOpenedKind, json.endObject());
}

Result<SealOpening> openingOf(const EventRecord& event) {
  return recordOf<SealOpening>(event, [](auto& out, JsonMembers& members, auto&) {
    readId(members, required("reference"), out.reference);
    members.flag(required("early"), out.early);
    members.text(required("content"), out.content);
    std::vector<std::string> versions;
    members.texts(required("versions"), versions);
    for (const auto& text : versions) {
      const auto id = study::parseRecordId(text);
      if (!id) return members.refuse("versions", "ids of 32 hexadecimal digits");
      out.versions.push_back(*id);
    }
    std::map<std::string, double> records;
    members.numbers(required("records"), records, kCount);
    for (const auto& [text, count] : records) {
      const auto id = study::parseRecordId(text);
      if (!id) return members.refuse("records", "numbers by ids of 32 hexadecimal digits");
      out.records[*id] = static_cast<std::size_t>(count);
    }
  });
}

/// Strokes, judgements, answers and rules of each session that has any. Those of feeling a model are none of the
/// elicitation.
Result<std::map<study::RecordId, std::size_t>> elicitedRecords(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection,
                "SELECT e.session_id, count(*) FROM (SELECT session_id FROM stroke UNION ALL SELECT session_id FROM "
                "judgement UNION ALL SELECT session_id FROM answer UNION ALL SELECT session_id FROM rule) AS e "
                "JOIN session AS s ON s.id = e.session_id WHERE s.kind <> 'usability' GROUP BY e.session_id");
    std::map<study::RecordId, std::size_t> out;
    while (query.next()) {
      const study::RecordId session = query.id();
      out[session] = static_cast<std::size_t>(query.integer());
    }
    return out;
  });
}

Result<void> requireContent(const SealedReference& reference, const std::string& content, ErrorCode code) {
  if (base::sha256(content) == reference.sha256) return {};
  return base::fail(code, std::string(kSealPlace), "content with another SHA-256",
                    "the one of the seal, " + reference.sha256);
}

/// The versions that each of the openings found.
std::set<study::RecordId> foundByAll(const std::vector<SealOpening>& openings) {
  std::map<study::RecordId, std::size_t> times;
  for (const auto& one : openings) {
    for (const auto& version : one.versions) ++times[version];
  }
  std::set<study::RecordId> out;
  for (const auto& [version, count] : times) {
    if (count == openings.size()) out.insert(version);
  }
  return out;
}

/// The smallest number of records of `session` that one of the openings found.
std::size_t leastFound(const std::vector<SealOpening>& openings, const study::RecordId& session) {
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const auto& one : openings) {
    const auto found = one.records.find(session);
    least = std::min(least, found == one.records.end() ? 0 : found->second);
  }
  return least;
}

auto byTime() {
  return [](const auto& a, const auto& b) { return a.entry.when.utc_ms < b.entry.when.utc_ms; };
}

}  // namespace

bool isSignOff(const study::ModelVersion& version) { return version.label.starts_with("sign-off"); }

Result<void> sealContent(SealedReference& record, const std::string& content, const std::string& passphrase) {
  if (content.empty() || content.size() > kMostSealedBytes) {
    return base::fail(ErrorCode::kLimit, {}, std::to_string(content.size()) + " bytes",
                      "1 to " + std::to_string(kMostSealedBytes) + " bytes");
  }
  if (auto ok = prepareSodium(); !ok) return ok;
  record.sha256 = base::sha256(content);
  record.operations = kOperations;
  record.memory_bytes = kMemoryBytes;
  record.salt = randomBytes(crypto_pwhash_SALTBYTES);
  record.nonce = randomBytes(kNonceBytes);
  Key key;
  if (auto ok = derive(key, record, passphrase); !ok) return ok;
  const std::string bound = boundTextOf(record);
  record.cipher.resize(content.size() + kTagBytes);
  crypto_aead_xchacha20poly1305_ietf_encrypt(rawOf(record.cipher), nullptr, rawOf(content), content.size(),
                                             rawOf(bound), bound.size(), nullptr, rawOf(record.nonce),
                                             rawOf(key.bytes));
  return {};
}

Result<std::string> openContent(const SealedReference& reference, const std::string& passphrase) {
  if (auto ok = prepareSodium(); !ok) return tl::unexpected(ok.error());
  Key key;
  if (auto ok = derive(key, reference, passphrase); !ok) return tl::unexpected(ok.error());
  const std::string bound = boundTextOf(reference);
  std::string content(reference.cipher.size() - kTagBytes, '\0');
  if (crypto_aead_xchacha20poly1305_ietf_decrypt(rawOf(content), nullptr, nullptr, rawOf(reference.cipher),
                                                 reference.cipher.size(), rawOf(bound), bound.size(),
                                                 rawOf(reference.nonce), rawOf(key.bytes)) != 0) {
    return base::fail(ErrorCode::kMismatch, std::string(kSealPlace), "a passphrase that does not open it",
                      "the passphrase with which it was sealed, and a seal of which nothing was changed");
  }
  if (auto ok = requireContent(reference, content, ErrorCode::kMismatch); !ok) return tl::unexpected(ok.error());
  return content;
}

Result<bool> elicitationBegan(const StudyFile& file) {
  TACTUS_TRY(const auto withdrawn, tombstones(file));
  if (!withdrawn.empty()) return true;
  TACTUS_TRY(const auto records, elicitedRecords(file));
  return !records.empty();
}

Result<void> append(StudyFile& file, const SealedReference& record) {
  TACTUS_TRY(const bool began, elicitationBegan(file));
  if (began && !record.late) {
    return base::inFile({ErrorCode::kValue,
                         {},
                         std::string(kSealPlace),
                         "a study with strokes, judgements, answers or rules, or with a participant who withdrew",
                         "a study before its elicitation, or a seal that is marked as late"},
                        file.path());
  }
  TACTUS_TRY(const auto all, persons(file));
  std::vector<std::string> codes;
  for (const auto& person : all) codes.push_back(person.code);
  if (base::holdsName(record.note, codes)) {
    return base::inFile({ErrorCode::kValue,
                         {},
                         std::string(kSealPlace),
                         "a note with the code of a person",
                         "a note without one: a withdrawal could not take it out"},
                        file.path());
  }
  return appendEvent(file, eventOf(record), sealedReferenceOf);
}

Result<void> append(StudyFile& file, const SealOpening& record) {
  TACTUS_TRY(const auto trials, sealedTrials(file));
  const auto trial = std::find_if(trials.begin(), trials.end(),
                                  [&](const auto& one) { return one.reference.entry.id == record.reference; });
  if (trial == trials.end()) {
    return base::inFile({ErrorCode::kReference,
                         {},
                         "opening",
                         "no reference " + study::toText(record.reference),
                         "the id of a sealed reference"},
                        file.path());
  }
  if (auto ok = requireContent(trial->reference, record.content, ErrorCode::kMismatch); !ok) {
    return base::inFile(ok.error(), file.path());
  }
  TACTUS_TRY(const auto versions, modelVersions(file));
  if (!record.early && std::none_of(versions.begin(), versions.end(), isSignOff)) {
    return base::inFile({ErrorCode::kValue,
                         {},
                         std::string(kSealPlace),
                         "no version of the model that is signed off",
                         "a sign-off, or an opening that is marked as early"},
                        file.path());
  }
  SealOpening whole = record;
  whole.versions.clear();
  for (const auto& version : versions) whole.versions.push_back(version.id);
  TACTUS_TRY(whole.records, elicitedRecords(file));
  return appendEvent(file, eventOf(whole), openingOf);
}

Result<std::vector<SealedTrial>> sealedTrials(const StudyFile& file) {
  TACTUS_TRY(const auto all, events(file));
  std::optional<base::Error> first;
  const auto keep = [&](const base::Error& error) {
    if (!first) first = error;
  };
  std::vector<SealedTrial> out;
  for (auto& reference : readEvents(all, kSealedKind, sealedReferenceOf, keep)) {
    out.emplace_back().reference = std::move(reference);
  }
  auto openings = readEvents(all, kOpenedKind, openingOf, keep);
  if (first) return base::inFile(*first, file.path());
  std::stable_sort(openings.begin(), openings.end(), byTime());
  std::stable_sort(out.begin(), out.end(),
                   [](const auto& a, const auto& b) { return byTime()(a.reference, b.reference); });
  if (out.empty()) return out;
  TACTUS_TRY(const auto versions, modelVersions(file));
  TACTUS_TRY(const auto records, elicitedRecords(file));
  for (auto& trial : out) {
    for (const auto& opening : openings) {
      if (opening.reference != trial.reference.entry.id) continue;
      if (auto ok = requireContent(trial.reference, opening.content, ErrorCode::kMismatch); !ok) {
        return base::inFile(ok.error(), file.path());
      }
      trial.openings.push_back(opening);
    }
    if (trial.openings.empty()) continue;
    const auto found = foundByAll(trial.openings);
    for (const auto& version : versions) {
      if (!found.contains(version.id)) {
        trial.changed_after.push_back(version);
      } else if (isSignOff(version)) {
        trial.signed_off = version;
      }
    }
    if (trial.signed_off) {
      TACTUS_TRY(trial.signed_off, modelVersion(file, trial.signed_off->id));
    }
    for (const auto& [session, count] : records) {
      const std::size_t least = leastFound(trial.openings, session);
      if (count > least) trial.records_after += count - least;
    }
  }
  return out;
}

Result<std::vector<std::string>> checkSealedReferences(const StudyFile& file) {
  TACTUS_TRY(const auto all, events(file));
  std::vector<std::string> findings;
  const auto tell = [&](const base::Error& error) { findings.push_back(error.message()); };
  const auto references = readEvents(all, kSealedKind, sealedReferenceOf, tell);
  for (const auto& opening : readEvents(all, kOpenedKind, openingOf, tell)) {
    const auto found = std::find_if(references.begin(), references.end(),
                                    [&](const auto& one) { return one.entry.id == opening.reference; });
    const std::string what =
        "opening " + study::toText(opening.entry.id) + ": of sealed reference " + study::toText(opening.reference);
    if (found == references.end()) {
      findings.push_back(what + ", which is missing");
    } else if (base::sha256(opening.content) != found->sha256) {
      findings.push_back(what + ", whose content has another SHA-256");
    }
  }
  return findings;
}

}  // namespace tactus::store
