// The research key of a study file: the passphrase that leads from the participant's screens to the researcher's.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::store {

// Salted slow hashes of passphrases. Private to core/store.

/// yescrypt (the hash of Debian's passwords, from libxcrypt) with a random salt; it takes about 0.1 s and 16 MiB, so
/// that guessing is slow. The text holds method, cost and salt.
/// Returns an error for fewer than 6 or more than 500 bytes, and for a byte 0.
base::Result<std::string> hashOfPassphrase(const std::string& passphrase);

/// Whether the passphrase has this hash. Returns an error for a hash that this machine cannot compute.
base::Result<bool> hasHash(const std::string& passphrase, const std::string& hash);

/// Sets the key, or removes it if `passphrase` is empty. Only a salted slow hash is stored; it stays in this file (and
/// its backups), no export or merge takes it along. Takes about 0.1 s. Returns an error for fewer than 6 or more than
/// 500 bytes.
base::Result<void> setResearchKey(StudyFile& file, const std::string& passphrase, std::int64_t utc_ms);

/// Whether a key is set.
base::Result<bool> hasResearchKey(const StudyFile& file);

/// Whether `passphrase` is the key; any is where none is set. Takes about 0.1 s.
base::Result<bool> opensResearch(const StudyFile& file, const std::string& passphrase);

}  // namespace tactus::store
