// The states of the force models of a study: added, never changed. Undo, snapshots and sign-off are further versions.
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// Adds a version and stores the SHA-256 of its text; `version.sha256` may be empty, or must fit. Refused: an id that
/// is there already, a parent that is not, a model with an expert who withdrew from the study.
base::Result<void> append(StudyFile& file, const study::ModelVersion& version);

/// All versions from the oldest to the latest, without their texts.
base::Result<std::vector<study::ModelVersion>> modelVersions(const StudyFile& file);

/// One version with its text; an error where there is none, or where the text does not fit its SHA-256.
base::Result<study::ModelVersion> modelVersion(const StudyFile& file, const study::RecordId& id);

/// The version that was added last, with its text, or nothing.
base::Result<std::optional<study::ModelVersion>> latestModelVersion(const StudyFile& file);

/// The parent of `id`, its parent, and so on to the first, without their texts.
base::Result<std::vector<study::ModelVersion>> modelAncestors(const StudyFile& file, const study::RecordId& id);

}  // namespace tactus::store
