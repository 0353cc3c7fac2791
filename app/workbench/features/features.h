// The features of the window: each adds to the bench what it shows, and connects it.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

#include "app/session/study_procedure.h"
#include "app/workbench/base/worker.h"
#include "app/workbench/help/tour.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/origins/origin_finder.h"
#include "app/workbench/shell/command_search.h"

class QAction;

namespace tactus::workbench {

class GuideWindow;
class OriginWindow;
struct Bench;

/// The name of the layout for feeling alone.
inline QString feelLayout() { return QStringLiteral("feel"); }

/// Enables `action` while `may`, which is asked again with each change of the study or of stage Collect.
void followStudy(Bench& bench, QAction* action, const std::function<bool()>& may);

/// All of them, in the order in which they stand here: a later one uses views and panels of the earlier ones.
void addFeatures(Bench& bench);

/// Why the force is what it is at the place that is read: the terms and the rules there.
void addHere(Bench& bench);
/// The force curves, the forces at the place that is read, the ghost and reference curves from files.
void addCurves(Bench& bench);
/// "Pull the force": the card beside the curves with the edits that bring the force where the user wants it.
void addPull(Bench& bench);
/// The force over two inputs, as a map and as a surface, with pictures of them.
void addMap(Bench& bench);
/// The panel Feel, the menu Feel, and the state of the device in the strip.
void addFeel(Bench& bench);
/// "Serve to a simulator": the menu entry, its dialog, the sign in the strip, and what the hand feels.
void addLink(Bench& bench);
void addRules(Bench& bench);
/// The menu Edit, the membership function editor, the message after each edit, and the time from an edit to the screen.
void addEditing(Bench& bench);
/// The findings, and the links from a chosen finding to the other panels.
void addFindings(Bench& bench);
/// The menu Study, the state of storing, messages, and recordings in the panel Feel.
void addStudy(Bench& bench);
/// The contracts of the model and whether it keeps them.
void addContracts(Bench& bench);
/// The recorded strokes before and after each edit, and the ways to record some and to replay one.
void addStrokes(Bench& bench);
/// Stage Collect: the study's home, its protocol, and sessions on the participant's screens.
void addCollect(Bench& bench);
/// The start screen: the demo study, new studies and models, imports, and recent files.
void addStart(Bench& bench);
/// Stage Build: the labs, which lead from recordings to an agreed model.
void addLabs(Bench& bench);
/// "Where does this come from?" for the numbers of bench and labs.
void addOrigins(Bench& bench);
/// The report of the open study in the menu File.
void addReport(Bench& bench);
/// A reference curve under seal, and its opening: the entries in the menu Study.
void addSealing(Bench& bench);
/// The study as tables, whole or to share.
void addStudyExport(Bench& bench);
/// What happened to the study, what is odd in its data, and what the build says of its model.
void addNotes(Bench& bench);
/// The versions of the model: the panel, its entries in the menu Edit, and the strip that names the compared ones.
void addHistory(Bench& bench);
/// "Feel blind": the two versions of the comparison, on the device.
void addDuel(Bench& bench);
/// "Find the stroke that tells": the two versions of the comparison, and what is done with their stroke.
void addTell(Bench& bench);
/// "Mark this moment": the card in the panel Feel, its key, and the way back to the version that was felt.
void addMarks(Bench& bench);
/// What is pointed at comes to the front; a finding and an edit of the history select what they are about.
void addSelection(Bench& bench);
/// Stage Deliver: its two panels, and the way from each line of the readiness to the place or the act.
void addDeliver(Bench& bench);
/// The way back after a crash, and what helps where work is not restored or not kept.
void addRecovery(Bench& bench);
/// The copy of a picture of the plot in use, whichever panel it belongs to.
void addPictures(Bench& bench);
/// The stages that show the open model, and the places of their panels before the user moves them.
void addScreens(Bench& bench);
/// The guide and the tour: the first actions of the menu Help, and their buttons on the start screen.
void addHelp(Bench& bench);
/// The search (Ctrl+K).
void addSearch(Bench& bench);

// The features that others ask for something.

class StudyFeature : public QObject {
  Q_OBJECT

 public:
  explicit StudyFeature(Bench& bench);

  /// Asks for the procedure and the place of a new study and makes it.
  void chooseNew();
  /// Asks for a study, new or there already, opens it beside the open model and arms a recording.
  void recordIntoStudy();
  /// The open study was chosen to record into: the screen stays where the model is felt.
  bool isToRecord() const;

 private:
  void chooseProcedure();
  void makeStudy(session::ProcedurePtr procedure);
  QString studyName() const;
  void buildMenu();
  void addRecordings();
  void connectAll();
  void showState();
  /// What is said of a study beside that it is open for reading only.
  struct ReadOnlyReason {
    QString sentence;
    MessageAct act;
  };

  void onOpened();
  void showReadOnly(ReadOnlyReason beside);
  /// A model was built beside the one that was open: the way back, and its edits.
  void offerBack(const QString& sentence, const MessageAct& back);
  /// `go_on_there`: the copy is open afterwards, with what the study could not take.
  void chooseCopy(bool go_on_there = false);
  void buildModel();
  /// `act`: what helps; without text there is a way out by what is open.
  void onFailed(const QString& path, const QString& sentence, const MessageAct& act = {});
  /// Keeps the window open until everything is written, or until the user gives it up.
  bool mayEnd();

  Bench& bench_;
  QAction* make_ = nullptr;
  QAction* show_ = nullptr;
  QAction* put_ = nullptr;
  QAction* build_ = nullptr;
  QAction* copy_ = nullptr;
  QAction* close_ = nullptr;
  ReadOnlyReason beside_;
  QString recorded_path_;  ///< of the study that was chosen to record into
  bool ending_ = false;    ///< the window closes as soon as everything is written
};

class ReportFeature : public QObject {
  Q_OBJECT

 public:
  explicit ReportFeature(Bench& bench);

  /// Asks for a file, then writes the report.
  void choose();
  /// Writes the report to `path`, whole or not at all, with the settings of the labs. Ends with `written` or `failed`.
  /// Ignored while one is written.
  void write(const QString& path);
  bool isBusy() const { return busy_; }

 signals:
  void written(const QString& path);
  /// One sentence: what could not be written, and why.
  void failed(const QString& sentence);

 private:
  void showState();
  void end(const QString& path, const QString& failure);

  Bench& bench_;
  QAction* action_;
  bool busy_ = false;
  Background background_;  ///< last: its end waits for a report
};

class OriginsFeature : public QObject {
  Q_OBJECT

 public:
  explicit OriginsFeature(Bench& bench);
  /// Ends its window, which shows what ends here.
  ~OriginsFeature() override;

  /// The window; null before the first question.
  OriginWindow* view() { return view_; }

 private:
  void connectBench();
  void connectLabs();
  /// A number of the model on the bench, which may not be built from the open study.
  void askBench(OriginQuestion question);
  QString whyNotOfStudy() const;
  /// `not_of_study`: empty for a number of the model that the labs build.
  void show(OriginQuestion question, const QString& not_of_study = {});
  void lead(const OriginRecord& record);
  void showParticipant(const OriginRecord& record);

  Bench& bench_;
  OriginWindow* view_ = nullptr;
};

class StartFeature : public QObject {
  Q_OBJECT

 public:
  explicit StartFeature(Bench& bench);

  /// Asks for a folder of tables and makes a study of them.
  void chooseTables();

 signals:
  /// The model of the demo study, which was asked for, is on the screen.
  void demoShown();

 private:
  void connectAll();
  void addMenu();
  void makeModel();
  void chooseDemoFolder();
  void onDemoReady(const QString& study);
  void onStudyOpened();
  void onModelOpened();

  Bench& bench_;
  QString demo_study_;  ///< asked for, and not on the screen yet
};

class HelpFeature : public QObject {
  Q_OBJECT

 public:
  explicit HelpFeature(Bench& bench);

  GuideWindow& guide() { return *guide_; }
  Tour& tour() { return tour_; }
  /// Without a model the demo study is opened before.
  void startTour();

 private:
  std::vector<TourStep> steps();

  Bench& bench_;
  GuideWindow* guide_;
  Tour tour_;
  bool tour_waits_ = false;  ///< for the demo study
};

class SearchFeature : public QObject {
  Q_OBJECT

 public:
  explicit SearchFeature(Bench& bench);

  /// Menus, panels, tables and figures of the labs, and the experts, terms and findings of the open model.
  const std::vector<SearchSource>& sources() const { return sources_; }
  /// What is typed as a place leads to it, and to why the force is as it is there.
  QList<SearchEntry> placesIn(const QString& typed) const;
  /// Enters stage Build at a lab, by the name of its widget. `page`: empty: its first one; null: any will do.
  void showLab(const char* lab, const char* page) const;

 private:
  void open();
  QList<SearchEntry> labs() const;
  QList<SearchEntry> experts() const;
  QList<SearchEntry> terms() const;
  QList<SearchEntry> findings() const;
  void reveal(Panel& panel) const;

  Bench& bench_;
  std::vector<SearchSource> sources_;
};

}  // namespace tactus::workbench
