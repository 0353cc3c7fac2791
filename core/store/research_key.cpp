#include "core/store/research_key.h"

#include <crypt.h>
#include <memory>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;

constexpr const char* kMethod = "$y$";
/// Cost of yescrypt, 1 to 11; one more doubles time and memory. 5 is the library's default.
constexpr unsigned long kCost = 5;
constexpr std::size_t kShortestBytes = 6;
constexpr std::size_t kLongestBytes = 500;

Result<std::string> crypted(const std::string& passphrase, const std::string& setting) {
  const auto data = std::make_unique<crypt_data>();  // 32 KiB
  const char* const hash = crypt_rn(passphrase.c_str(), setting.c_str(), data.get(), sizeof(crypt_data));
  if (hash == nullptr) {
    return base::fail(ErrorCode::kValue, "research key", "a hash that this machine cannot compute",
                      "a key that was set on this machine; set it again");
  }
  return std::string(hash);
}

}  // namespace

Result<std::string> hashOfPassphrase(const std::string& passphrase) {
  if (passphrase.size() < kShortestBytes || passphrase.size() > kLongestBytes ||
      passphrase.find('\0') != std::string::npos) {
    return base::fail(ErrorCode::kValue, "research key",
                      "a passphrase of " + std::to_string(passphrase.size()) + " bytes", "6 to 500 bytes of text");
  }
  // The library takes the salt from the system's random numbers.
  const auto data = std::make_unique<crypt_data>();
  const char* const setting = crypt_gensalt_rn(kMethod, kCost, nullptr, 0, data->output, sizeof(data->output));
  if (setting == nullptr) {
    return base::fail(ErrorCode::kValue, "research key", "no yescrypt in the system's libcrypt",
                      "libxcrypt 4.3 or later");
  }
  return crypted(passphrase, setting);
}

Result<bool> hasHash(const std::string& passphrase, const std::string& hash) {
  TACTUS_TRY(const auto found, crypted(passphrase, hash));
  return found == hash;
}

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
    TACTUS_TRY(auto made, hashOfPassphrase(passphrase));
    hash = std::move(made);
  }
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    Query insert(connection, insertion(connection, "research_key",
                                       {{"place", "(SELECT coalesce(max(place), 0) + 1 FROM research_key)"}}));
    insert.put(utc_ms).put(hash).run();
  });
}

Result<bool> hasResearchKey(const StudyFile& file) {
  TACTUS_TRY(const auto hash, currentHash(file));
  return !hash.empty();
}

Result<bool> opensResearch(const StudyFile& file, const std::string& passphrase) {
  TACTUS_TRY(const auto hash, currentHash(file));
  if (hash.empty()) return true;
  return hasHash(passphrase, hash);
}

}  // namespace tactus::store
