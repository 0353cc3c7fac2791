// What can be taken back in the labs: corrections of a study's records, and changes of the settings. A correction is a
// new record that supersedes the old one; the old one stays in the file. Undo is one more record, with the values of
// the old one.
#pragma once

#include <QDate>
#include <QElapsedTimer>
#include <QString>
#include <functional>
#include <map>
#include <optional>
#include <variant>
#include <vector>

#include "app/workbench/base/messages.h"
#include "app/workbench/labs/data/lab_data.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/session_records.h"
#include "elicitation/model/record_influence.h"

namespace tactus::workbench {

// What a record moves, in a sentence or for a table.

/// `S1 at 0.4 N: without it the averaged force moves by at most 0.025 N (0.3 just-noticeable differences), at
/// lubrication 0.5, depth 120 mm; 0.004 N rms.` `which`: the record. `model`: whose inputs have the place.
QString influenceText(const QString& which, const base::Result<elicitation::RecordInfluence>& moved,
                      const fuzzy::ForceModel& model);

/// The same for a cell of a table: `0.025 N (0.3 JND)`; what is more than nothing never reads `0`.
QString movedText(const elicitation::RecordInfluence& moved);

/// Thread: gui.
class Corrections : public UndoSource {
  Q_OBJECT

 public:
  /// A record of which elicitation makes use. Strokes without recordings: a correction keeps the samples.
  using Record = std::variant<study::StrokeRecord, study::JudgementRecord, study::AnswerRecord, study::RuleRecord>;

  /// `data` outlives this, and is read again after each correction.
  explicit Corrections(LabData& data, QObject* parent = nullptr);

  /// Stores `wanted` as the correction of `before`, which is the current record (LabStudy has it). Its id, time and the
  /// one who entered it (the researcher) are set here; the session stays. `what`: the correction for the screen, e.g.
  /// `marks of stroke 2 of S1, fast`. Does nothing if the values are equal.
  void correct(Record before, Record wanted, const QString& what, const QString& reason = {});

  /// Who corrects the data of real participants today, and why: asked once a day and stored with each correction.
  /// Simulated data need none. A correction that waits for it is stored then.
  void sign(const QString& name, const QString& why);
  /// The correction that waits is dropped.
  void dropUnsigned() { unsigned_ = {}; }

  bool canUndo() const override { return !busy_ && done_ > 0; }
  bool canRedo() const override { return !busy_ && done_ < steps_.size(); }
  QString undoText() const override { return done_ > 0 ? steps_[done_ - 1].what : QString(); }
  QString redoText() const override { return done_ < steps_.size() ? steps_[done_].what : QString(); }
  /// A correction is being written.
  bool isBusy() const { return busy_; }

 public slots:
  void undo() override;
  void redo() override;

 signals:
  /// A correction, an undo or a redo is written.
  void stored(const QString& what);
  /// A correction waits for a name and a reason. `what`: the correction.
  void signatureAsked(const QString& what);
  /// One sentence: what was not written, and why.
  void refused(const QString& sentence, const tactus::workbench::MessageAct& act);

 private:
  /// A change of the settings from one state to another; those of a slider are one.
  struct SettingsStep {
    elicitation::BuildSettings before;
    elicitation::BuildSettings after;
    QElapsedTimer since;
  };
  struct Step {
    study::RecordId chain;  ///< the first record that a correction of this run of the program superseded
    Record before;
    Record after;
    QString what;
    QString reason;
    std::optional<SettingsStep> settings = {};  ///< then nothing of the above but `what` is set
  };
  /// The current record of each chain.
  using Newest = std::map<study::RecordId, study::RecordId>;

  /// `again`: does the same once more, where it failed.
  void write(const study::RecordId& chain, Record record, const QString& what, const QString& reason,
             std::size_t done_after, std::function<void()> again);
  void takeSettings(const elicitation::BuildSettings& before, const elicitation::BuildSettings& after);
  void restore(const elicitation::BuildSettings& settings, std::size_t done_after);
  bool needsSignature(const Record& record) const;
  QString signedReason(const QString& reason) const;
  void forget();

  LabData& data_;
  std::vector<Step> steps_;
  std::size_t done_ = 0;
  bool busy_ = false;
  bool restoring_ = false;  ///< settings are being put back: no new step
  Newest newest_;
  QDate signed_on_;
  QString signature_;               ///< `Ann Lee: heard the recording`
  std::function<void()> unsigned_;  ///< does the correction that waits once more
};

}  // namespace tactus::workbench
