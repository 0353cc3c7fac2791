// A study in the layout of BIDS 1.10: strokes as Motion-BIDS, judgements and rules in `beh`, answers in `phenotype`.
#pragma once

#include <string>
#include <vector>

#include "app/dataset/dataset.h"
#include "app/session/export_folder.h"

namespace tactus::dataset {

/// How an earlier data set of this layout is recognized.
session::ExportKind bidsExport();

/// Writes the files of the layout: the description, README, participants, and the parts below. Returns what is left
/// out, one sentence each.
std::vector<std::string> writeBids(const PublishedStudy& published, FileSet& files);

/// The strokes, one table with its description and channels each: `sub-P1/motion/…_motion.tsv`. A stroke of one sample
/// has no sampling frequency; it is left out, and a sentence says so.
std::vector<std::string> writeMotion(const PublishedStudy& published, FileSet& files);

/// `sub-P1/beh/…`: the judgements of every participant, also of one who judged nothing, so that each has a folder; and
/// the given rules.
void writeBehavior(const PublishedStudy& published, FileSet& files);

/// `sub-P1/beh/sub-P1_task-session_run-1_events.tsv`: the trials of each of the participant's sessions, in their order.
void writeEvents(const PublishedStudy& published, FileSet& files);

/// `phenotype/…`: of each form a table with a row for each participant, also without answers, and a column for each
/// item.
void writePhenotype(const PublishedStudy& published, FileSet& files);

/// `sub-P1` for the participant `P1`.
std::string subject(const std::string& code);

}  // namespace tactus::dataset
