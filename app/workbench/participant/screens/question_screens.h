// The screens that ask in words and pictures: the glossary and the questions.
#pragma once

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QWidget>
#include <vector>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

// The words of the questions, before the questions: what is asked, and the levels of each condition as pictures.

/// One page of the glossary: a sentence and a picture of each level.
class GlossaryPage : public QWidget {
  Q_OBJECT

 public:
  GlossaryPage(const Look& look, TextRole role, const Phrase& sentence, QWidget* parent = nullptr);

  void addPicture(const Phrase& word, Picture picture);
  /// The body as the condition has it.
  void addPose(const Phrase& word, const study::ItemCondition& condition);
  /// The regions, each with its name.
  void addRegions();
  /// The whole way, with the tool at its end.
  void addWay(const Phrase& word);
  /// The other views of the body that the pack has, beside the regions or beside the whole way.
  void addOtherViews(bool of_regions);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addColumn(const Phrase& word, QWidget* picture, bool grows);
  /// Pictures beside each other are equally high, however long their words are.
  void alignCaptions();
  anatomy::BodyView* newBody();

  const Look& look_;
  QHBoxLayout* row_;
  std::vector<Label*> captions_;  ///< of pictures that grow
};

class GlossaryScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit GlossaryScreen(const Look& look, QWidget* parent = nullptr);

  int pages() const { return pages_->count(); }
  void setPage(int page);

 protected:
  bool turnPage(int by) override;
  bool hasPageBefore() const override { return pages_->currentIndex() > 0; }

 private:
  GlossaryPage* addPage(const Phrase& sentence, TextRole role = TextRole::kLead);
  /// The words of a condition.
  void addWords(const fuzzy::Variable& input);

  QStackedWidget* pages_;
};

// One of the questions: a plain sentence, the picture with the region lit and the pose as it is, small pictures of the
// other conditions, the words of the form and "I can't tell".

class QuestionScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit QuestionScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 protected:
  /// From 1 the words, 0 "I can't tell".
  QString idOfKey(int key) const override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show();
  void showUsual();
  void showConditions();

  QuestionState state_;
  TextBlock* texts_;
  Label* situation_;
  Label* ask_;
  Label* usual_;
  Choices* choices_;
  anatomy::BodyView* picture_;
  QWidget* condition_pictures_;
  QHBoxLayout* corner_;
};

}  // namespace tactus::workbench::nurse
