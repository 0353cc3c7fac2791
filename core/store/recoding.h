// Another code for a participant: two sites may give two persons one code, which a merge brings together.
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

/// From now on the person has `code` everywhere; the earlier one stays in the file as history. `change` is the id of
/// this record. Refused: a person who is not there, an empty code, one that any person has or had, one of a participant
/// who withdrew.
base::Result<void> recode(StudyFile& file, const study::RecordId& person, const std::string& code,
                          const study::RecordId& change, std::int64_t utc_ms);

/// The person that `name` means: a code, or an id of 32 hexadecimal digits. An error, with the ids and what to do,
/// where two persons have the code; where the participant withdrew, since when; where there is none.
base::Result<study::Person> personNamed(const StudyFile& file, const std::string& name);

/// An error that names the first code of two persons and the command that gives one of them another; for whoever goes
/// by codes from here on.
base::Result<void> requireDistinctCodes(const StudyFile& file);

/// Codes that more than one person has, with the persons' ids by id. Throws as Query does. For core/store only.
struct DoubledCode {
  std::string code;
  std::vector<study::RecordId> persons;
};
std::vector<DoubledCode> doubledCodes(Connection& connection);

/// `2 persons with the code 'N01' (ids …, …)`, or with another verb.
std::string describe(const DoubledCode& doubled, std::string_view verb = "with");

/// `tactus study recode FILE ID CODE-2`, with a code that nobody has or had. For core/store only.
std::string recodeCommand(Connection& connection, const DoubledCode& doubled);

/// `text` as one word of a shell.
std::string shellWord(std::string_view text);

}  // namespace tactus::store
