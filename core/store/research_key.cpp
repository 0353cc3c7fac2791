#include "core/store/research_key.h"

#include "core/store/passphrase.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;

Result<std::string> currentHash(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT k.hash, " + fitsChecksum(connection, "research_key", "k") +
                                " FROM research_key AS k ORDER BY k.place DESC LIMIT 1");
    if (!query.next()) return std::string();
    std::string hash = query.text();
    if (!query.flag()) {
      refuse(ErrorCode::kMismatch, "research key", "a record that does not fit its CRC-32",
             "the key as it was set; set it again");
    }
    return hash;
  });
}

}  // namespace

Result<void> setResearchKey(StudyFile& file, const std::string& passphrase, std::int64_t utc_ms) {
  std::string hash;
  if (!passphrase.empty()) {
    auto made = hashOfPassphrase(passphrase);
    if (!made) return tl::unexpected(made.error());
    hash = std::move(*made);
  }
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    Query insert(connection, insertion(connection, "research_key",
                                       {{"place", "(SELECT coalesce(max(place), 0) + 1 FROM research_key)"}}));
    insert.put(utc_ms).put(hash).run();
  });
}

Result<bool> hasResearchKey(const StudyFile& file) {
  const auto hash = currentHash(file);
  if (!hash) return tl::unexpected(hash.error());
  return !hash->empty();
}

Result<bool> opensResearch(const StudyFile& file, const std::string& passphrase) {
  const auto hash = currentHash(file);
  if (!hash) return tl::unexpected(hash.error());
  if (hash->empty()) return true;
  return hasHash(passphrase, *hash);
}

}  // namespace tactus::store
