// The records of feeling in the study: the person, the button Record, and the recordings with Replay; marked moments.
#pragma once

#include <cstddef>

#include "app/workbench/kit/cards.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class FeelController;
class FeelMarks;
class FeelStore;
class StudyConnection;

class RecordingsCard : public Card {
  Q_OBJECT

 public:
  RecordingsCard(FeelStore& store, StudyConnection& study, FeelController& feel, QWidget* parent = nullptr);

  /// False: leaves out what is offered without an open study, to save space.
  void setRoomy(bool roomy);
  /// Opens the list of recordings for the keyboard.
  void chooseRecording();

 signals:
  /// Without a study: one to record into is wanted.
  void studyRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void build();
  void arrange();
  int widthInOneRow() const;
  void listPeople();
  void showWho();
  void listRecordings();
  void showState();
  void choose(int person);
  void replay();

  FeelStore& store_;
  StudyConnection& study_;
  FeelController& feel_;
  QLabel* hint_;
  QPushButton* into_;  ///< beside the hint
  QLabel* where_;      ///< the study that gets the recordings
  QWidget* content_;
  QGridLayout* grid_;
  QLabel* who_label_;
  QLabel* list_label_;
  QComboBox* who_;
  QPushButton* record_;
  QComboBox* list_;
  QPushButton* replay_;
  bool roomy_ = true;
  bool in_one_row_ = false;
  std::size_t listed_ = 0;  ///< number of recordings in the list
};

/// The button that marks a moment, and the marked moments to return to.
class MarksCard : public Card {
  Q_OBJECT

 public:
  MarksCard(FeelMarks& marks, FeelController& feel, QWidget* parent = nullptr);

 private:
  void list();

  FeelMarks& marks_;
  FeelController& feel_;
  QPushButton* mark_;
  QComboBox* list_;
};

}  // namespace tactus::workbench
