// Gives a participant another code. Needed if two sites gave two persons one code and a merge brought them together.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

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

}  // namespace tactus::store
