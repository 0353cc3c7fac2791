// The participants of a study file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/person_codes.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// Adds a person. Returns an error for an existing code or id, or the id or a code of a person who withdrew.
base::Result<void> append(StudyFile& file, const study::Person& person);

/// A code from `codes` that no person of the file has or had, including persons who withdrew, however it is written
/// (study::codeKey).
base::Result<std::string> unusedCode(const StudyFile& file, PersonCodes& codes);

/// All persons, by code.
base::Result<std::vector<study::Person>> persons(const StudyFile& file);

/// The person with this code, or nothing. Returns an error if two persons have the code after a merge.
base::Result<std::optional<study::Person>> findPerson(const StudyFile& file, const std::string& code);

}  // namespace tactus::store
