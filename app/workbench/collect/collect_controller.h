// Stage Collect without widgets: who takes part in the open study and how far each has come, new participants, and
// withdrawals. It reads the study when it is opened and when something in it has changed, never during a session.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "app/session/simulated_study.h"
#include "app/workbench/base/messages.h"
#include "app/workbench/collect/study_overview.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/store/withdrawal.h"

namespace tactus::workbench {

/// Thread: gui.
class CollectController : public QObject {
  Q_OBJECT

 public:
  /// `study` outlives this.
  explicit CollectController(StudyConnection& study, QObject* parent = nullptr);

  const StudyOverview& overview() const { return overview_; }
  /// The latest check of the set-up, of the file or of this window, as long as it can hold; null: there is none.
  const session::SetupCertificate* setup() const;
  void setSetup(const session::SetupCertificate& setup);
  /// The overview is as the study is, or no study is open.
  bool isCurrent() const { return !stale_; }
  /// The row of `person`, or null.
  const ParticipantRow* row(const study::RecordId& person) const;
  StudyConnection& study() { return study_; }

  /// While a session runs, the thread of the study belongs to it: the overview waits until the end.
  void setSessionRunning(bool runs);
  bool isSessionRunning() const { return runs_; }

  /// Stores a new participant under a code that no participant has or had. Ends with `added` or `refused`.
  void addParticipant();

  /// Adds simulated nurses to the study, each with a whole session. Ends with `filled` or `refused`.
  void fillWithSimulated(const session::SimulatedGroup& group);
  bool isFilling() const { return filling_; }
  /// Adds the answers of files that the web form saved, all or nothing (webform/answers.h). Ends with `answersImported`
  /// or `refused`.
  void importAnswers(const QStringList& paths);

  /// Counts what a withdrawal of `person` would delete. Ends with `previewed` or `refused`.
  void previewWithdrawal(const study::RecordId& person);
  /// Deletes everything of `person`. Ends with `withdrawn` or `refused`.
  void withdraw(const study::RecordId& person);
  bool isWithdrawing() const { return withdrawing_; }

 public slots:
  /// Reads the study again.
  void refresh();

 signals:
  /// `overview`, `isCurrent`, `isSessionRunning` or `isWithdrawing` changed.
  void changed();
  void added(const tactus::study::RecordId& person, const QString& code);
  /// So many simulated nurses were added.
  void filled(int count);
  /// So many of the files had answers that were not in the study yet. `notes`: one sentence each.
  void answersImported(int files, int added, const QString& notes);
  void previewed(const tactus::study::RecordId& person, const tactus::store::WithdrawalPreview& preview);
  /// Everything of the participant who had `code` is deleted.
  void withdrawn(const QString& code);
  /// One sentence: what could not be done, and why.
  void refused(const QString& sentence, const tactus::workbench::MessageAct& act);
  /// One sentence: who was not withdrawn, and why.
  void withdrawalRefused(const tactus::study::RecordId& person, const QString& sentence);

 private:
  void setOverview(StudyOverview overview);

  StudyConnection& study_;
  std::optional<session::SetupCertificate> setup_;  ///< checked in this window
  StudyOverview overview_;
  bool stale_ = false;
  bool reading_ = false;
  bool runs_ = false;
  bool withdrawing_ = false;
  bool filling_ = false;
};

}  // namespace tactus::workbench
