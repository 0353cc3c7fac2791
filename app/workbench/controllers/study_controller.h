// The open study: its model with all edits as versions, and whatever else is to be kept in it. The file belongs to a
// thread of its own; here orders are given and answers arrive, and nothing waits.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/controllers/edit_controller.h"
#include "app/workbench/controllers/mailbox.h"
#include "app/workbench/controllers/model_controller.h"
#include "app/workbench/controllers/study_contents.h"
#include "app/workbench/controllers/study_worker.h"

namespace tactus::workbench {

/// Thread: gui.
class StudyController : public QObject {
  Q_OBJECT

 public:
  /// Stores the edits of `edits` while the model is the study's.
  StudyController(ModelController& models, EditController& edits, QObject* parent = nullptr);
  /// Waits until everything that was ordered is written, then closes the study.
  ~StudyController() override;

  bool isOpen() const { return !path_.isEmpty(); }
  bool isOpening() const { return opening_; }
  const QString& path() const { return path_; }
  /// The name of the file, for the screen.
  QString fileName() const;
  /// The open model is the study's: its edits become versions.
  bool keepsModel() const;
  /// The study has a model, open or not.
  bool hasModel() const { return has_model_; }
  const std::vector<StudyPerson>& people() const { return people_; }
  const std::vector<store::FeelSummary>& recordings() const { return recordings_; }

  /// Something that was ordered is not written yet.
  bool isBusy() const { return !waiting_.empty(); }
  /// Why something is not written; empty while all is well. What the disk refused is tried again every few seconds,
  /// anything else with `storeNow`.
  const QString& failure() const { return failure_.isEmpty() ? refused_ : failure_; }
  /// `Stored in STUDY`, `Saving in STUDY…`, `Not stored in STUDY`; empty where the model is not the study's.
  QString savedText() const;

  /// What to do with the study, in its thread; and what then, here. A work that the disk keeps from being done is done
  /// again later, anything else that is wrong with it is announced with `failed`.
  using Work = std::function<base::Result<void>(store::StudyFile&, study::RecordIds&)>;
  using Done = std::function<void()>;
  /// Works are done in the order in which they were ordered. A study must be open.
  void order(Work work, Done done = {});

  /// The version that the model on the screen is, or will be once it is written; nothing where the study does not keep
  /// the model, and while another version is shown in its place.
  std::optional<study::RecordId> modelVersion() const;

 public slots:
  /// Opens the study file `path` with its model, or builds one where it has answers and none; ends with `opened` or
  /// `failed`. The study that is open stays until then.
  void open(const QString& path);
  /// Makes the study file `path` and opens it.
  void create(const QString& path);
  /// Lets go of the study. Its model stays open beside it.
  void close();
  /// Shows the model of the study again, as it was stored last.
  void openModel();
  /// Builds the averaged model anew from the answers. It becomes a further model in the study.
  void buildModel();
  /// The open model and everything that was done to it become versions in the study.
  void putModel();
  /// Tries again at once what could not be written.
  void storeNow();
  /// Reads again who is in the study and what was recorded.
  void refresh();

 signals:
  /// The study will be let go of: the last moment to order something for it.
  void leaving();
  void opened();
  void closed();
  /// One sentence: what could not be done with which file, and why.
  void failed(const QString& path, const QString& sentence);
  /// One or two sentences about what was done.
  void said(const QString& sentence);
  /// What `savedText` says, `isBusy` or `failure` changed.
  void savedChanged();
  void contentsChanged();

 private:
  using TextCache = std::map<study::RecordId, study::ModelVersion>;
  void post(StudyWorker::Task task) { worker_.post(std::move(task)); }
  /// Hands `call` from the thread of the worker to this one.
  void answer(Mailbox::Call call) { answers_.post(std::move(call)); }
  bool mayLeave(const QString& path);
  void begin(const QString& path, bool make);
  void changeOver(std::shared_ptr<StudyContents> contents);
  void adopt(StudyContents& contents);
  void show(editing::EditHistory history);
  void storeEvents();
  void orderAs(bool is_version, Work work, Done done);
  void onAnswer(const std::optional<base::Error>& error);
  void setFailure(const QString& sentence);
  void letGo();
  void readTexts(std::size_t next);
  editing::Stamp stamp() const;

  ModelController& models_;
  EditController& edits_;
  QString path_;
  bool opening_ = false;
  bool adopting_ = false;  ///< a history is handed over: what it announces is not to be stored
  bool has_model_ = false;
  std::vector<StudyPerson> people_;
  std::vector<store::FeelSummary> recordings_;
  std::vector<study::ModelVersion> versions_;  ///< of the study when it was opened, without their texts
  std::shared_ptr<TextCache> texts_;           ///< those that were read, for going back to an old state
  std::size_t events_ordered_ = 0;             ///< events of the history that are stored or ordered to be
  struct Waiting {
    Done done;
    bool is_version = false;
  };
  std::deque<Waiting> waiting_;  ///< what follows each order that is not written yet
  QString failure_;
  QString refused_;    ///< why a version was refused for another reason than the disk
  bool slow_ = false;  ///< an order has been waiting so long that the screen says so
  QTimer slow_timer_;
  QTimer retry_;
  Mailbox answers_;
  StudyWorker worker_;  ///< last: its end waits for the thread, which answers to all above
};

}  // namespace tactus::workbench
