// The secret that a client of the live link must know, and the file that only its owner can read it from. Everybody who
// works on a computer can connect to its loopback; the token tells the user's programs from others.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::link {

/// Compares in a time that depends on the lengths alone.
bool isSameToken(std::string_view said, std::string_view token) noexcept;

/// A file with a token, one line, for its owner alone (0600).
class TokenFile {
 public:
  /// The file `path`: takes the token in it, or writes a new one of 128 random bits if there is no file. The file stays
  /// afterwards, so that a simulator has to be told only once. Refused: a file with something else in it, or one that
  /// others may read.
  static base::Result<TokenFile> at(const std::string& path);
  /// A new token in a new private folder of the user, which is removed by the destructor.
  static base::Result<TokenFile> inPrivateFolder();

  ~TokenFile();
  TokenFile(TokenFile&& other) noexcept;
  TokenFile& operator=(TokenFile&&) = delete;

  const std::string& path() const { return path_; }
  const std::string& token() const { return token_; }

 private:
  TokenFile(std::string path, std::string token, std::string folder);

  std::string path_;
  std::string token_;
  std::string folder_;  ///< to be removed; empty: none
};

}  // namespace tactus::link
