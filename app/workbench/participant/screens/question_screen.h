// One of the 45 questions: a plain sentence, the picture with the region lit and the neck as it is, small pictures of
// lubrication and speed, five words and "I can't tell".
#pragma once

#include <QHBoxLayout>

#include "app/workbench/anatomy/anatomy_view.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

/// The picture of a term of lubrication or speed; nothing for the neck, which the anatomy shows.
Picture pictureOf(const QString& condition, const QString& term);
/// The posture of a term of neck flexion; upright for other conditions.
anatomy::Posture postureOf(const QString& condition, const QString& term);

class QuestionScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit QuestionScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 protected:
  /// 1 to 5 the words, 0 "I can't tell".
  QString idOfKey(int key) const override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show();
  void showUsual();

  QuestionState state_;
  TextBlock* texts_;
  Label* situation_;
  Label* usual_;
  Choices* choices_;
  anatomy::AnatomyView* picture_;
  PictureBox* condition_picture_;
  QHBoxLayout* corner_;
};

}  // namespace tactus::workbench::nurse
