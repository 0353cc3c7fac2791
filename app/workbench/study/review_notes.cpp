#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "app/session/data_checks.h"
#include "app/session/study_source.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/study/study_models.h"
#include "core/model_io/model_file.h"

namespace tactus::workbench {
namespace {

using Kind = study::DataFinding::Kind;

struct ReviewNotes {
  Q_DECLARE_TR_FUNCTIONS(ReviewNotes)
};

// The variable whose terms come from what the finding is about; answers and participants are about all of the model.
std::string subjectOf(Kind kind, const procedure::Procedure& about) {
  const bool strokes = kind == Kind::kWithoutStrokes || (kind >= Kind::kUnknownLevel && kind <= Kind::kLevelsSwapped);
  if (strokes) return about.rateInput() != nullptr ? about.rateInput()->id : std::string();
  const bool judgements =
      kind == Kind::kWithoutJudgements || (kind >= Kind::kUnknownForceTerm && kind <= Kind::kJudgementsCopied);
  return judgements ? about.output.id : std::string();
}

// Whether a build gave this model, whenever and by whichever program it was made.
bool isOf(const fuzzy::ForceModel& model, const fuzzy::ForceModel& built) {
  return model.inputs == built.inputs && model.output == built.output && model.experts == built.experts &&
         model.implication == built.implication;
}

std::vector<BuildNote> rebuiltNotes(const ReadStudy& read, const std::string& model) {
  const auto parsed = model_io::parseModel(model, "model");
  const auto built = elicitation::buildModel(read.study, session::knownForms(procedure::of(read.study)), {});
  if (!parsed || !built) return {};
  std::vector<BuildNote> notes = notesOf(read.notes, *built);
  if (!isOf(parsed->model, built->model)) {
    notes.insert(notes.begin(),
                 {ReviewNotes::tr("These notes are of a build from the answers as they are now. The model of the study "
                                  "began as another one: built with other settings, from other answers, or put in "
                                  "from a file."),
                  {}});
  }
  return notes;
}

}  // namespace

std::vector<BuildNote> dataNotes(const std::vector<study::DataFinding>& findings, const procedure::Procedure& about) {
  std::vector<BuildNote> notes;
  for (const study::DataFinding& finding : findings) {
    const QString sentence = text(study::text(finding));
    const bool refused = finding.severity == study::DataFinding::Severity::kRefused;
    notes.push_back({refused ? ReviewNotes::tr("No model is built of this: %1").arg(sentence) : sentence,
                     subjectOf(finding.kind, about)});
  }
  return notes;
}

std::vector<BuildNote> notesOf(const std::vector<std::string>& reading, const elicitation::BuiltModel& built) {
  std::vector<BuildNote> notes;
  for (const std::string& note : reading) notes.push_back({text(note), {}});
  for (std::size_t i = 0; i < built.notes.size(); ++i) {
    notes.push_back({text(built.notes[i]), built.note_subjects[i]});
  }
  return notes;
}

BuildNotes reviewed(const ReadStudy& read, const std::optional<std::string>& model) {
  return {dataNotes(session::dataFindings(read.study), procedure::of(read.study)),
          model ? rebuiltNotes(read, *model) : std::vector<BuildNote>{}};
}

}  // namespace tactus::workbench
