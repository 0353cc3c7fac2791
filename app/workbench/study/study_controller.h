// The open study: its model with all edits as versions, and whatever else is to be kept in it. The file belongs to a
// thread of its own; here orders are given and answers arrive, and nothing waits.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/base/build_note.h"
#include "app/workbench/base/call_queue.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/study/study_contents.h"
#include "app/workbench/study/study_orders.h"
#include "app/workbench/study/study_review.h"
#include "app/workbench/study/study_worker.h"
#include "app/workbench/study/version_texts.h"

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
  /// The study is opened, read or left, and other orders of this kind are not taken.
  bool isOpening() const { return opening_; }
  /// Something can be ordered for it: it is open, and not just being closed.
  bool takesOrders() const { return isOpen() && !closing_; }
  const QString& path() const { return path_; }
  /// The name of the file, for the screen.
  QString fileName() const;
  /// The open model is the study's: its edits become versions.
  bool keepsModel() const;
  /// The study has a model, open or not.
  bool hasModel() const { return has_model_; }
  const std::vector<StudyPerson>& people() const { return people_; }
  const std::vector<store::FeelSummary>& recordings() const { return recordings_; }
  /// What is odd in the data of the study, and what the build says of its model. Comes some time after the opening.
  const BuildNotes& notes() const { return review_.notes(); }
  /// Still being computed.
  bool isReviewing() const { return review_.isBusy(); }
  /// What happened to the study.
  const StudyNotices& notices() const { return notices_; }
  /// `finishErasure` runs.
  bool isErasing() const { return erasing_; }

  /// Something that was ordered is not written yet.
  bool isBusy() const { return orders_.isBusy(); }
  /// Why something is not written; empty while all is well. What the disk refused is tried again every few seconds,
  /// anything else with `storeNow`.
  const QString& failure() const { return orders_.failure().isEmpty() ? refused_ : orders_.failure(); }
  /// `Stored in STUDY`, `Saving in STUDY…`, `Not stored in STUDY`; empty where the model is not the study's.
  QString savedText() const;

  /// Works are done in the order in which they were ordered; one that the disk keeps from being done is done again
  /// later. Of anything else that is wrong with it `refused` is told, or without one everybody with `failed`. The study
  /// must take orders.
  void order(StudyOrders::Work work, StudyOrders::Done done = {}, StudyOrders::Refused refused = {});

  /// The version that the model on the screen is, or will be once it is written; nothing where the study does not keep
  /// the model. Of a model that is shown in its place, the version that it is or was made from.
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
  /// Erases what an interrupted erasure left, in the thread of the study; `said` or `failed` tells the end.
  void finishErasure();
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
  void notesChanged();
  /// What `notices` or `isErasing` say changed.
  void noticesChanged();

 private:
  void post(StudyWorker::Task task) { worker_.post(std::move(task)); }
  /// Hands `call` from the thread of the worker to this one.
  void answer(CallQueue::Call call) { answers_.post(std::move(call)); }
  bool mayLeave(const QString& path);
  void whenWritten(std::function<void(bool)> then);
  void begin(const QString& path, bool make);
  void changeOver(std::shared_ptr<StudyContents> contents);
  void adopt(StudyContents& contents);
  void show(editing::EditHistory history);
  void setNotices(StudyNotices notices);
  struct ErasureEnd {
    QString failure;
    bool models_changed = false;
    std::optional<StudyNotices> notices;
  };
  void onErased(ErasureEnd end);
  void storeEvents();
  void moveOut();
  void letGo();

  ModelController& models_;
  EditController& edits_;
  QString path_;
  bool opening_ = false;
  bool closing_ = false;   ///< everything is written, and the file is being closed
  bool adopting_ = false;  ///< a history is handed over: what it announces is not to be stored
  bool has_model_ = false;
  std::vector<StudyPerson> people_;
  std::vector<store::FeelSummary> recordings_;
  StudyNotices notices_;
  bool erasing_ = false;
  std::size_t events_ordered_ = 0;  ///< events of the history that are stored or ordered to be
  QString refused_;                 ///< why a version was refused for another reason than the disk
  CallQueue answers_;
  StudyOrders orders_{worker_, answers_};
  VersionTexts texts_{worker_, answers_};
  StudyReview review_{worker_, answers_};
  StudyWorker worker_;  ///< last: its end waits for the thread, which answers to all above
};

}  // namespace tactus::workbench
