#include "core/store/passphrase.h"

#include <crypt.h>
#include <memory>

#include "core/base/text.h"

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
  const auto found = crypted(passphrase, hash);
  if (!found) return tl::unexpected(found.error());
  return *found == hash;
}

}  // namespace tactus::store
