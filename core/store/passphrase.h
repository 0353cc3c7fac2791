// Salted slow hashes of passphrases. Private to core/store.
#pragma once

#include <string>

#include "core/base/error.h"

namespace tactus::store {

/// yescrypt (the hash of Debian's passwords, from libxcrypt) with a random salt; it takes about 0.1 s and 16 MiB, so
/// that guessing is slow. The text holds method, cost and salt.
/// Returns an error for fewer than 6 or more than 500 bytes, and for a byte 0.
base::Result<std::string> hashOfPassphrase(const std::string& passphrase);

/// Whether the passphrase has this hash. Returns an error for a hash that this machine cannot compute.
base::Result<bool> hasHash(const std::string& passphrase, const std::string& hash);

}  // namespace tactus::store
