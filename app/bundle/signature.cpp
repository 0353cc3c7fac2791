// Signatures of a bundle: those of OpenSSH (`ssh-keygen -Y`), so that no cryptography is our own.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/bundle/bundle.h"
#include "app/bundle/file_errors.h"
#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
#include "core/base/text.h"

namespace tactus::bundle {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostKeyBytes = std::size_t{64} << 10U;
constexpr std::string_view kNamespace = "tactus-bundle";
constexpr std::string_view kSigner = "signer";  // as the list of those who may sign names the key
constexpr std::string_view kArmor = "-----BEGIN SSH SIGNATURE-----";

/// A private folder in which ssh-keygen finds what it reads.
class SigningFolder {
 public:
  SigningFolder() {
    std::error_code ignored;
    const fs::path place = fs::temp_directory_path(ignored) / "tactus-sign";
    made_ = base::makeUnfinishedFolder(place.string(), base::kUnfinishedEnding);
  }
  ~SigningFolder() {
    std::error_code ignored;
    if (made_.descriptor.isOpen()) fs::remove_all(made_.path, ignored);
  }
  SigningFolder(const SigningFolder&) = delete;
  SigningFolder& operator=(const SigningFolder&) = delete;

  std::string file(const std::string& name) const { return made_.path + "/" + name; }

  base::Result<void> write(const std::string& name, std::string_view bytes) const {
    if (!made_.descriptor.isOpen())
      return base::fail(base::ErrorCode::kIo, made_.path, "no place to sign", "a folder for temporary files");
    return base::writeFileAtomically(file(name), bytes);
  }

  /// Runs `ssh-keygen -Y` with these words; what it writes. Nothing: it ended with an error, which `why` gives.
  base::Result<std::optional<std::string>> run(std::vector<std::string> words) {
    words.insert(words.begin(), {"ssh-keygen", "-Y"});
    const Ran ran = runProgram(words, made_.path);
    if (ran == Ran::kNotThere) {
      return base::fail(base::ErrorCode::kIo, "ssh-keygen", "no program of this name",
                        "that of OpenSSH 8.2 or newer (package openssh-client), which signs and checks signatures");
    }
    if (ran == Ran::kEnded)
      return base::fail(base::ErrorCode::kIo, "ssh-keygen", "no answer within a minute", "one within a minute");
    if (ran == Ran::kFailed) return std::nullopt;
    TACTUS_TRY(auto said, base::readFile(file("out"), kMostKeyBytes));
    return said;
  }

  /// What the program said last before it failed.
  std::string why() const {
    const auto said = base::readFile(file("err"), kMostKeyBytes);
    std::string_view last = said ? base::trimmed(*said) : std::string_view();
    while (!last.empty() && (last.back() == '\n' || last.back() == '\r')) last.remove_suffix(1);
    last = last.substr(last.find_last_of("\r\n") + 1);
    return last.empty() ? "an error without a word" : base::oneLine(last);
  }

 private:
  base::Unfinished made_;
};

/// `Good "tactus-bundle" signature for signer with ED25519 key SHA256:47DE…`: the last word.
std::string keyIn(std::string_view said) {
  const std::size_t begin = said.find("SHA256:");
  if (begin == std::string_view::npos) return "an unnamed key";
  return base::oneLine(said.substr(begin, said.find_first_of(" \r\n", begin) - begin));
}

/// The one line that says whose signatures count, from the file of a public key: `ssh-ed25519 AAAA… comment`.
base::Result<std::string> signersWith(const std::string& path) {
  TACTUS_TRY(const auto text, base::readFile(path, kMostKeyBytes));
  const auto refused = [&](std::string found) {
    return tl::unexpected(base::Error{base::ErrorCode::kSyntax,
                                      path,
                                      {},
                                      std::move(found),
                                      "a public key of OpenSSH in one line, as in the files *.pub"});
  };
  if (text.find("PRIVATE KEY") != std::string::npos) return refused("a private key");
  const std::string_view line = base::trimmed(std::string_view(text).substr(0, text.find_first_of("\r\n")));
  const std::size_t space = line.find(' ');
  const std::string_view kind = line.substr(0, space);
  const bool known = kind.starts_with("ssh-") || kind.starts_with("ecdsa-") || kind.starts_with("sk-");
  if (!known || space == std::string_view::npos || !base::isUtf8(line)) return refused("another text");
  const std::string_view rest = base::trimmed(line.substr(space));
  const std::string_view key = rest.substr(0, rest.find(' '));
  return std::string(kSigner) + " namespaces=\"" + std::string(kNamespace) + "\" " + std::string(kind) + " " +
         std::string(key) + "\n";
}

}  // namespace

base::Result<std::string> signatureOf(std::string_view manifest, const std::string& private_key) {
  SigningFolder folder;
  if (const auto written = folder.write("in", manifest); !written) return tl::unexpected(written.error());
  TACTUS_TRY(const auto signature, folder.run({"sign", "-f", private_key, "-n", std::string(kNamespace)}));
  if (signature && signature->starts_with(kArmor)) return *signature;
  return tl::unexpected(base::Error{base::ErrorCode::kIo,
                                    private_key,
                                    {},
                                    "a key that ssh-keygen does not sign with (" + folder.why() + ")",
                                    "a private key of OpenSSH, as ssh-keygen -t ed25519 makes it"});
}

base::Result<std::string> signerOf(std::string_view manifest, std::string_view signature,
                                   const std::string& public_key) {
  TACTUS_TRY(const auto signers, signersWith(public_key));
  SigningFolder folder;
  for (const auto& [name, bytes] :
       {std::pair{"in", manifest}, {"sig", signature}, {"signers", std::string_view(signers)}}) {
    if (const auto written = folder.write(name, bytes); !written) return tl::unexpected(written.error());
  }
  const std::vector<std::string> about = {"-n", std::string(kNamespace), "-s", folder.file("sig")};
  const auto words = [&about](std::vector<std::string> first) {
    first.insert(first.end(), about.begin(), about.end());
    return first;
  };
  TACTUS_TRY(const auto good, folder.run(words({"verify", "-f", folder.file("signers"), "-I", std::string(kSigner)})));
  if (good) return keyIn(*good);
  const auto refused = [&](std::string found) {
    return base::fail(base::ErrorCode::kMismatch, std::string(model_io::kSignatureName), std::move(found),
                      "one of this manifest by the key in " + base::oneLine(public_key));
  };
  const std::string why = folder.why();
  TACTUS_TRY(const auto another, folder.run(words({"check-novalidate"})));
  if (another) return refused("a signature by another key, " + keyIn(*another));
  return refused("a signature that does not fit (" + why + ")");
}

}  // namespace tactus::bundle
