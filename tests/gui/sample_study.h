// Study files for the tests of the workbench.
#pragma once

#include <QString>
#include <functional>
#include <string>

#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::tests {

/// Makes the study file `path` without anything in it, and hands it to `fill` before it is closed.
void makeStudyFile(const QString& path, const std::function<void(store::StudyFile&, study::RecordIds&)>& fill = {});

/// Opens the study file `path`, which nobody else has open, for looking at.
store::StudyFile lookInto(const QString& path);

/// A person `code` with a session of the kind `kind`; returns the session's id.
study::RecordId addVisit(store::StudyFile& file, study::RecordIds& ids, const std::string& code, bool simulated,
                         study::SessionKind kind = study::SessionKind::kElicitation);

/// Lets events come until `condition` holds; returns whether it did within ten seconds.
bool comesTrue(const std::function<bool()>& condition);

}  // namespace tactus::tests
