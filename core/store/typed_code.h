// Finds the participant whose code a person typed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

struct TypedCode {
  std::optional<study::Person> person;
  /// Codes of the study that the typed one may have meant, the closest first, at most 3; empty if `person` is given.
  std::vector<std::string> meant;
};

/// Ignores case, spaces, dashes and leading zeros (study::codeKey), so `Velvet Otter` finds `velvet-otter`. Where
/// several codes differ in no more than that, only the exact one is found, and they are all in `meant`.
base::Result<TypedCode> findTyped(const StudyFile& file, const std::string& typed);

}  // namespace tactus::store
