// A study in the layout of Psych-DS: CSV tables below `data`, one description of the data set with all columns.
#pragma once

#include <string>

#include "app/dataset/published_study.h"
#include "app/session/export_folder.h"

namespace tactus::dataset {

/// How an earlier data set of this layout is recognized.
session::ExportKind psychDsExport();

/// Writes the files of the layout. `folder` is that of `files`. A table without rows is left out, except that of the
/// participants. Refuses what study::writeStudyFolder refuses.
base::Result<void> writePsychDs(const PublishedStudy& published, const std::string& folder, FileSet& files);

}  // namespace tactus::dataset
