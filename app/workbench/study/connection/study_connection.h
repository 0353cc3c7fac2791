// The open study file: opened, created, closed, written and read. A separate thread owns the file. This class sends
// orders to it and receives answers; it never waits. It knows no model.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/workbench/base/worker.h"
#include "app/workbench/study/connection/study_contents.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"

namespace tactus::workbench {

/// The thread that owns the study file. It runs tasks in order. No other thread uses the file, so a slow or full disk
/// never blocks the window.
class StudyWorker {
 public:
  /// An order for the study, with a callback for its result.
  struct Work {
    std::function<base::Result<void>(store::StudyFile&, study::RecordIds&)> run;
    /// Runs in the worker's thread after each attempt. A disk error (ErrorCode::kIo) is retried.
    std::function<void(const base::Result<void>&)> answer;
  };
  /// The state that only the worker's thread uses.
  struct OpenStudy {
    std::optional<store::StudyFile> file;  ///< the open study
    std::optional<store::StudyFile> next;  ///< an opened study that replaces `file` on request
    std::deque<Work> works;                ///< not done yet, because the disk refused the first of them
    study::RecordIds ids;
    /// Run before `file` is closed or exchanged.
    std::vector<std::function<void()>> before_closing;

    /// Runs the orders in sequence until the disk refuses one. Returns whether all are done.
    bool catchUp();
    /// Closes `file`.
    base::Result<void> close();
    /// Puts `next` in the place of `file`.
    void exchange();

   private:
    void drop();
  };
  using Task = std::function<void(OpenStudy&)>;

  /// Runs `task` in the worker's thread after all tasks posted before.
  void post(Task task) {
    worker_.post([this, task = std::move(task)] { task(open_study_); });
  }

 private:
  OpenStudy open_study_;  ///< used by the worker's thread, except in the destructor
  Worker worker_;         ///< last member: all posted tasks are done before the study is closed
};

// The orders for the open study that are not written yet. The study's thread runs them in order; this class reports the
// results and retries after disk errors.

/// Thread: gui.
class StudyOrders : public QObject {
  Q_OBJECT

 public:
  /// `worker` and `answers` may come to life later, and must do so before the first order; `worker` ends before this.
  StudyOrders(StudyWorker& worker, CallQueue& answers, QObject* parent = nullptr);

  /// An order: `Work` runs in the study's thread, `Done` afterwards in this thread.
  using Work = std::function<base::Result<void>(store::StudyFile&, study::RecordIds&)>;
  using Done = std::function<void()>;
  /// Called for a permanent failure (anything but a disk error), with one sentence. The order is not retried.
  using Refused = std::function<void(const QString& sentence)>;
  /// The study must stay open until the order is done (`whenWritten`).
  void add(Work work, Done done, Refused refused);

  bool isBusy() const { return !waiting_.empty(); }
  /// An order has waited so long that the screen should say so.
  bool isSlow() const { return slow_; }
  /// The last disk error; empty if all is well. The order is retried every few seconds.
  const QString& failure() const { return failure_; }
  /// Retries now.
  void tryAgain();
  /// Calls `then` after all orders so far, with true if they are written and false if the disk fails.
  void whenWritten(std::function<void(bool)> then);

 signals:
  /// One of the above changed.
  void changed();
  /// The disk fails: one sentence, once for each reason.
  void failed(const QString& sentence);

 private:
  void onAnswer(const std::optional<base::Error>& error);
  void setFailure(const QString& sentence);

  struct Waiting {
    Done done;
    Refused refused;
  };
  StudyWorker& worker_;
  CallQueue& answers_;
  std::deque<Waiting> waiting_;  ///< what follows each order that is not written yet
  QString failure_;
  bool slow_ = false;
  QTimer slow_timer_;
  QTimer retry_;
};

/// Thread: gui.
class StudyConnection : public QObject {
  Q_OBJECT

 public:
  explicit StudyConnection(QObject* parent = nullptr);
  /// Waits until all orders are written, then closes the study.
  ~StudyConnection() override;

  bool isOpen() const { return !path_.isEmpty(); }
  /// A study is being opened, read alone or closed. Further calls of this kind are ignored.
  bool isOpening() const { return opening_; }
  /// Whether `order` may be called: a study is open for writing and is not being closed.
  bool takesOrders() const { return isOpen() && !closing_ && !isReadOnly(); }
  /// The study is open, but for reading alone; `readOnlyReason` says why, to stand behind "because".
  bool isReadOnly() const { return !read_only_.isEmpty(); }
  const QString& readOnlyReason() const { return read_only_; }
  const QString& path() const { return path_; }
  /// The file name for the screen.
  QString fileName() const;
  /// What the open study is about.
  const session::ProcedurePtr& procedure() const { return procedure_; }
  const std::vector<StudyPerson>& people() const { return people_; }
  const std::vector<store::FeelSummary>& recordings() const { return recordings_; }
  /// What happened to the study.
  const StudyNotices& notices() const { return notices_; }
  /// `finishErasure` runs.
  bool isErasing() const { return erasing_; }

  /// Some orders are not written yet.
  bool isBusy() const { return orders_.isBusy(); }
  /// An order has waited so long that the screen should say so.
  bool isSlow() const { return orders_.isSlow(); }
  /// Why an order is not written; empty if all is well. A disk error is retried every few seconds; after any other
  /// error call `storeNow`.
  QString failure() const;

  /// Runs `work` after all earlier orders. If the disk fails, the order is retried later. For any other failure it
  /// calls `refused`; without `refused` it emits `failed`. `takesOrders` must be true.
  void order(StudyOrders::Work work, StudyOrders::Done done = {}, StudyOrders::Refused refused = {});

  /// Runs in the window's thread, with the result of the reading; may be empty.
  using Deliver = std::function<void()>;
  /// Runs in the thread of the study. It must not touch the object that asked.
  using Read = std::function<Deliver(const store::StudyFile&)>;
  /// Reads after everything that was asked and ordered before, orders that the disk refuses excepted. Nothing is
  /// delivered to an `asker` that has ended. If no study is open then, `closed` runs in the window's thread: whoever
  /// waits for the answer must give it.
  void read(QObject& asker, Read read, Deliver closed = {});
  /// The same as soon as everything is written, and `isOpening` until it is delivered. `prepare` makes the reader at
  /// that moment. If something cannot be written, emits `failed` and reads nothing.
  void readAlone(QObject& asker, std::function<Read()> prepare);
  /// Deletes everything of `person` (store::withdraw); `done` or `refused` tells the end. Erasing what is left of it in
  /// the file is part of that; where it is interrupted, `notices` offer to finish it.
  void withdraw(const study::RecordId& person, StudyOrders::Done done, StudyOrders::Refused refused);
  /// `drop` runs in the thread of the study before the file that is open now is closed or exchanged: for what holds a
  /// reference to the file there.
  void beforeClosing(std::function<void()> drop);

  /// From now on `keeper` takes part in opening, writing and closing; at most one does. It ends before this.
  void attach(StudyKeeper& keeper);
  void detach();

 public slots:
  /// Opens the study file `path`; for reading alone where it cannot be written to. Ends with `opened` or `failed`. The
  /// current study stays open until then. If it is the one that is open: `openedAgain`.
  void open(const QString& path);
  /// Creates the study file `path` and opens it. `procedure`: what the study is about; null: the default one.
  void create(const QString& path, tactus::session::ProcedurePtr procedure = nullptr);
  void close();
  /// Erases what an interrupted erasure left, in the thread of the study; `said` or `failed` tells the end.
  void finishErasure();
  /// Copies what is stored to the new file `path`. Ends with `copied` or `copyFailed`.
  void saveCopy(const QString& path);
  /// Copies what is stored to the new file `path`, opens that in the place of the study, and writes there what the
  /// study refused: the way out where its file was replaced, deleted or written to by another program. Ends with
  /// `opened` or `copyFailed`, which leaves everything as it was.
  void moveTo(const QString& path);
  /// Tries again at once what could not be written.
  void storeNow();
  /// Reads the participants and recordings of the study again.
  void refresh();

 signals:
  /// The study is about to be closed. This is the last chance to call `order`.
  void leaving();
  void opened();
  void openedAgain();
  void copied(const QString& path);
  void copyFailed(const QString& sentence);
  void closed();
  /// One sentence: what failed for which file, and why.
  void failed(const QString& path, const QString& sentence);
  /// One or two sentences about a completed action.
  void said(const QString& sentence);
  /// `isOpening`, `isBusy` or `failure` changed.
  void changed();
  /// `procedure` changed; the model of the study is not open yet.
  void procedureChanged();
  void contentsChanged();
  /// What `notices` or `isErasing` say changed.
  void noticesChanged();
  /// Versions of models were changed by an erasure.
  void modelsErased();

 private:
  /// What was read of a study that is being opened.
  struct OpenedStudy {
    StudyContents contents;
    StudyKeeper::Take take;
    QString read_only;
  };
  struct ErasureEnd {
    QString failure;
    bool models_changed = false;
    std::optional<StudyNotices> notices;
  };
  void post(StudyWorker::Task task) { worker_.post(std::move(task)); }
  /// Hands `call` from the thread of the worker to this one.
  void answer(CallQueue::Call call) { answers_.post(std::move(call)); }
  bool mayLeave(const QString& path);
  void orderRest();
  void whenWritten(std::function<void(bool)> then);
  void begin(const QString& path, bool make, session::ProcedurePtr procedure = nullptr);
  void changeOver(std::shared_ptr<OpenedStudy> study);
  void adopt(OpenedStudy& study);
  void setNotices(StudyNotices notices);
  void onErased(ErasureEnd end);
  void releaseStudy();

  StudyKeeper* keeper_ = nullptr;
  QString path_;
  QString read_only_;
  bool opening_ = false;
  bool closing_ = false;  ///< everything is written; the file is being closed
  session::ProcedurePtr procedure_ = procedure::defaultProcedure();
  std::vector<StudyPerson> people_;
  std::vector<store::FeelSummary> recordings_;
  StudyNotices notices_;
  bool erasing_ = false;
  CallQueue answers_;
  StudyOrders orders_{worker_, answers_};
  StudyWorker worker_;  ///< last: its end waits for the thread, which answers to all above
};

}  // namespace tactus::workbench
