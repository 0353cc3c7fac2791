// What is felt and kept in the study: who feels, Record, and the recordings with Replay.
#pragma once

#include <cstddef>

#include "app/workbench/kit/card.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class FeelController;
class FeelStore;
class StudyController;

class RecordingsCard : public Card {
  Q_OBJECT

 public:
  RecordingsCard(FeelStore& store, StudyController& study, FeelController& feel, QWidget* parent = nullptr);

  /// Without room for it, the hint for who has no study open is left out.
  void setRoomy(bool roomy);

 private:
  void build();
  void listPeople();
  void showWho();
  void listRecordings();
  void showState();
  void choose(int person);
  void replay();

  FeelStore& store_;
  StudyController& study_;
  FeelController& feel_;
  QLabel* hint_;
  QLabel* where_;  ///< the study that is recorded into
  QWidget* content_;
  QComboBox* who_;
  QPushButton* record_;
  QComboBox* list_;
  QPushButton* replay_;
  bool roomy_ = true;
  std::size_t listed_ = 0;  ///< recordings in the list
};

}  // namespace tactus::workbench
