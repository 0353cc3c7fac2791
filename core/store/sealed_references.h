// Sealed references in a study file: a force curve is encrypted before the elicitation and opened after the sign-off,
// so that nobody who answers or edits can know it (docs/evidence.md). Events of a usability session, so every function
// that moves or exports session records includes them. No withdrawal removes or changes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// Category in the profile of the person whose sessions hold the seal. That person takes part in nothing.
inline constexpr const char* kSealCategory = "seal";

/// The content is encrypted; who reads the file learns its SHA-256 and its length alone.
struct SealedReference {
  study::Entry entry;
  std::string note;                          ///< as the researcher wrote it; may be empty
  std::map<std::string, double> conditions;  ///< of the curve, by id of the model's input, in its unit
  bool late = false;                         ///< sealed after the first answer, judgement, stroke or rule
  std::string sha256;                        ///< of the content, 64 hexadecimal digits
  std::string cipher;                        ///< with its authentication tag; raw bytes, as salt and nonce
  std::string salt;
  std::string nonce;
  std::uint64_t operations = 0;    ///< of the key's derivation
  std::uint64_t memory_bytes = 0;  ///< of the key's derivation

  bool operator==(const SealedReference&) const = default;
};

/// One opening of a sealed reference.
struct SealOpening {
  study::Entry entry;
  study::RecordId reference;
  bool early = false;   ///< before a version of the model was signed off
  std::string content;  ///< as it was before it was sealed
  // What the study held at that moment. Anything else came later, whatever its clock says.
  std::vector<study::RecordId> versions;           ///< of the models
  std::map<study::RecordId, std::size_t> records;  ///< of the elicitation, in each session

  bool operator==(const SealOpening&) const = default;
};

/// A sealed reference with all that happened to it. With several openings, each of which may have been made in another
/// copy of the study, only what all of them found counts as made before.
struct SealedTrial {
  SealedReference reference;
  std::vector<SealOpening> openings;               ///< by their time
  std::optional<study::ModelVersion> signed_off;   ///< the last sign-off that they found, with its text
  std::vector<study::ModelVersion> changed_after;  ///< versions that one of them did not find, without their texts
  std::size_t records_after = 0;  ///< strokes, judgements, answers and rules that one of them did not find
};

/// The longest content that is sealed.
inline constexpr std::size_t kMostSealedBytes = std::size_t{1} << 18U;

/// Encrypts `content` into `record`, whose time, note, conditions and `late` must be set: a change of one of them
/// breaks the seal as a change of the cipher does. `passphrase`: 8 to 500 bytes. XChaCha20-Poly1305 of libsodium, with
/// a key by Argon2id of 3 passes over 64 MiB, as the second recommended option of RFC 9106, in one lane. Takes about
/// 0.2 s.
base::Result<void> sealContent(SealedReference& record, const std::string& content, const std::string& passphrase);

/// The content again. Returns an error for another passphrase and for a record that was changed (the two cannot be told
/// apart), and for content that does not match its SHA-256.
base::Result<std::string> openContent(const SealedReference& reference, const std::string& passphrase);

/// Whether the study has a stroke, judgement, answer or rule of a session other than usability, or had a participant
/// who withdrew, of whom nothing is left.
base::Result<bool> elicitationBegan(const StudyFile& file);

/// Adds a record. Returns an error for a session of another kind than usability, for a reference that is not marked as
/// late after the elicitation began, and for a note with the code of a person, which no withdrawal could take out.
base::Result<void> append(StudyFile& file, const SealedReference& record);
/// Adds a record with the versions and records that the study holds now; those of `record` are ignored. Also returns an
/// error for an unknown reference, for content that does not match its SHA-256, and for an opening that is not marked
/// as early while no version is signed off.
base::Result<void> append(StudyFile& file, const SealOpening& record);

/// All sealed references from the oldest to the newest. Returns an error if a record cannot be read, or if the content
/// of an opening does not match the SHA-256 of the reference.
base::Result<std::vector<SealedTrial>> sealedTrials(const StudyFile& file);

/// One sentence per problem: an unreadable record, an opening without its reference or with other content.
base::Result<std::vector<std::string>> checkSealedReferences(const StudyFile& file);

/// Whether `version` is a sign-off.
bool isSignOff(const study::ModelVersion& version);

}  // namespace tactus::store
