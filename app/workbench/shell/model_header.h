// The line above everything: name of the model, the study that is open, a plain label where it holds simulated data,
// what there is to read about them, and whose terms are shown.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/base/messages.h"

class QComboBox;
class QHBoxLayout;
class QLabel;

namespace tactus::workbench {

class Card;
class ElidedLabel;
class NotesButton;
class SceneController;

class ModelHeader : public QWidget {
  Q_OBJECT

 public:
  explicit ModelHeader(SceneController& scene, QWidget* parent = nullptr);

  /// What is odd in the data of the study, and what the build from the answers says about the model.
  void showNotes(const BuildNotes& notes);
  /// What happened to the study.
  void showNotices(const StudyNotices& notices);
  /// Which study is open; empty: none. `read_only`: why it is open for reading alone; empty: it is not.
  void showStudy(const QString& name, const QString& read_only);

  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  // Where there is no room for all buttons beside the names, one stands for them.
  void fitButtons();
  int buttonsWidth() const;
  int widthOfOthers() const;
  bool hasSeveralKinds() const;
  void adoptModel();
  void countRules();
  void onTermsChosen(int index);

  SceneController& scene_;
  ElidedLabel* name_;
  QLabel* summary_;
  QLabel* lock_;  ///< beside a study that is open for reading alone
  ElidedLabel* study_;
  NotesButton* notices_;
  NotesButton* data_;
  NotesButton* notes_;
  NotesButton* all_;  ///< in the place of these three
  QHBoxLayout* buttons_;
  Card* simulated_;
  QLabel* terms_label_;
  QComboBox* terms_of_;
  std::vector<std::optional<std::size_t>> choices_;  ///< the expert of each entry of terms_of_
};

}  // namespace tactus::workbench
