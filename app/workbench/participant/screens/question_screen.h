// One of the questions: a plain sentence, the picture with the region lit and the pose as it is, small pictures of the
// other conditions, the words of the form and "I can't tell".
#pragma once

#include <QHBoxLayout>

#include "app/workbench/anatomy/body_view.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

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
