// Shared parts of the subcommands of `tactus study`: new files, the time, merges as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/store/merge.h"
#include "core/store/study_file.h"

namespace tactus::cli {

/// Wall clock, milliseconds since 1970-01-01 UTC.
std::int64_t utcNowMs();
/// As `2026-11-21T08:00:00Z`.
std::string utcText(std::int64_t utc_ms);

/// Opens a study for writing and keeps a copy of it (core/store/copies.h). Where no copy could be kept, a
/// warning says why.
base::Result<store::StudyFile> openToWrite(const std::string& path, std::vector<std::string>& warnings);

/// Creates the study file `path` and opens it.
base::Result<store::StudyFile> newStudy(const std::string& path, const std::string& name);

/// `file: ` and each of what a person should know of the opening of a study (StudyFile::notices), as warnings.
std::vector<std::string> noticesOf(const store::StudyFile& file);
/// The same once nothing is left to be erased.
std::vector<std::string> noticesButErasure(const store::StudyFile& file);

/// Closes a study in which everything is saved. A failure of this last step is a warning: no record is lost.
std::vector<std::string> closeSaved(store::StudyFile& file);

/// `{"person": 3, …}` on one line.
void writeCounts(const std::vector<store::TableCount>& counts, base::JsonWriter& json);

/// The records that a merge added, one line, and its conflicts, one line each.
std::string mergeAsText(const store::Merge& merge);
/// Writes the keys `added`, `withdrawn` and `conflicts` into the open object.
void writeMerge(const store::Merge& merge, base::JsonWriter& json);

}  // namespace tactus::cli
