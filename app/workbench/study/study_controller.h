// The open study: its model with all edits as versions, and all other records to store. A separate thread owns the
// file. This class sends orders to it and receives answers; it never waits.
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
  /// While the open model belongs to the study, stores every edit of `edits`.
  StudyController(ModelController& models, EditController& edits, QObject* parent = nullptr);
  /// Waits until all orders are written, then closes the study.
  ~StudyController() override;

  bool isOpen() const { return !path_.isEmpty(); }
  /// A study is being opened, read or closed. Further orders of this kind are ignored.
  bool isOpening() const { return opening_; }
  /// Whether `order` may be called: a study is open and is not being closed.
  bool takesOrders() const { return isOpen() && !closing_; }
  const QString& path() const { return path_; }
  /// The file name for the screen.
  QString fileName() const;
  /// The open model belongs to the study: its edits become versions.
  bool keepsModel() const;
  /// The study has a model, whether it is the open model or not.
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

  /// Some orders are not written yet.
  bool isBusy() const { return orders_.isBusy(); }
  /// Why an order is not written; empty if all is well. A disk error is retried every few seconds; after any other
  /// error call `storeNow`.
  const QString& failure() const { return orders_.failure().isEmpty() ? refused_ : orders_.failure(); }
  /// `Stored in STUDY`, `Saving in STUDY…`, `Not stored in STUDY`; empty if the model does not belong to the study.
  QString savedText() const;

  /// Runs `work` after all earlier orders. If the disk fails, the order is retried later. For any other failure it
  /// calls `refused`; without `refused` it emits `failed`. `takesOrders` must be true.
  void order(StudyOrders::Work work, StudyOrders::Done done = {}, StudyOrders::Refused refused = {});

  /// The version of the model on the screen, also if it is not written yet; nothing if the study does not keep the
  /// model. For a model shown in place of the open one: its version, or the version from which it was made.
  std::optional<study::RecordId> modelVersion() const;

 public slots:
  /// Opens the study file `path` with its model. If it has answers but no model, builds one. Ends with `opened` or
  /// `failed`. The current study stays open until then.
  void open(const QString& path);
  /// Creates the study file `path` and opens it.
  void create(const QString& path);
  /// Closes the study. Its model stays open outside the study.
  void close();
  /// Shows the study's model again, as stored last.
  void openModel();
  /// Builds the averaged model from the answers again and adds it to the study as another model.
  void buildModel();
  /// Puts the open model with its whole history into the study as versions.
  void putModel();
  /// Erases what an interrupted erasure left, in the thread of the study; `said` or `failed` tells the end.
  void finishErasure();
  /// Tries again at once what could not be written.
  void storeNow();
  /// Reads the participants and recordings of the study again.
  void refresh();

 signals:
  /// The study is about to be closed. This is the last chance to call `order`.
  void leaving();
  void opened();
  void closed();
  /// One sentence: what failed for which file, and why.
  void failed(const QString& path, const QString& sentence);
  /// One or two sentences about a completed action.
  void said(const QString& sentence);
  /// `savedText`, `isBusy` or `failure` changed.
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
  bool closing_ = false;   ///< everything is written; the file is being closed
  bool adopting_ = false;  ///< a history is being handed over; its signals must not be stored
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
