// Random codes of two words, such as `velvet-otter`, that say nothing about the person.
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

// Gives a participant another code. Needed if two sites gave two persons one code and a merge brought them together.

class Connection;

/// From now on the person has `code` everywhere; the previous code stays in the file as history. `change`: id of this
/// record. Returns an error for an unknown person, an empty code, a code that any person has or had, or the code of a
/// participant who withdrew.
base::Result<void> recode(StudyFile& file, const study::RecordId& person, const std::string& code,
                          const study::RecordId& change, std::int64_t utc_ms);

/// The person for `name`: a code, or an id of 32 hexadecimal digits. Returns an error if two persons have the code
/// (with the ids and the remedy), if the participant withdrew (with the time), or if there is none.
base::Result<study::Person> personNamed(const StudyFile& file, const std::string& name);

/// Returns an error if two persons share a code, with the first such code and the command that changes one of them. For
/// callers that identify persons by code.
base::Result<void> requireDistinctCodes(const StudyFile& file);

/// A code of several persons, with their ids in ascending order.
struct DoubledCode {
  std::string code;
  std::vector<study::RecordId> persons;
};
std::vector<DoubledCode> doubledCodes(Connection& connection);

/// E.g. `2 persons with the code 'N01' (ids …, …)`. `verb`: replaces `with`.
std::string describe(const DoubledCode& doubled, std::string_view verb = "with");

/// `tactus study recode FILE ID CODE-2`, with an unused code. For core/store only.
std::string recodeCommand(Connection& connection, const DoubledCode& doubled);

/// `text` quoted as one word of a shell.
std::string shellWord(std::string_view text);

/// Finds the participant whose code a person typed.
struct TypedCode {
  std::optional<study::Person> person;
  /// Codes of the study that the typed one may have meant, the closest first, at most 3; empty if `person` is given.
  std::vector<std::string> meant;
};

/// Ignores case, spaces, dashes and leading zeros (study::codeKey), so `Velvet Otter` finds `velvet-otter`. Where
/// several codes differ in no more than that, only the exact one is found, and they are all in `meant`.
base::Result<TypedCode> findTyped(const StudyFile& file, const std::string& typed);

/// Combines the words of core/store/data/code_words.txt: any first word with any second word.
class PersonCodes {
 public:
  /// Seeded by the operating system; for real participants.
  PersonCodes();
  /// The same seed gives the same codes. For simulated studies and tests.
  explicit PersonCodes(std::uint64_t seed);

  std::string next();

  const std::vector<std::string_view>& firstWords() const { return first_; }
  const std::vector<std::string_view>& secondWords() const { return second_; }

 private:
  std::string_view draw(const std::vector<std::string_view>& words);

  std::vector<std::string_view> first_;
  std::vector<std::string_view> second_;
  std::mt19937_64 engine_;
};

}  // namespace tactus::store
