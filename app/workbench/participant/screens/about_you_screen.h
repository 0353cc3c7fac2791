// About you: one question at a time, nothing chosen at the start, and no answer is forced.
#pragma once

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

/// The cards of a question, with the ids of AboutYouState::chosen.
std::vector<Answer> answersTo(AboutYouState::Question question);

class AboutYouScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit AboutYouScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 private:
  TextBlock* texts_;
  Label* lead_;
  Label* unwell_;
  Choices* choices_;
};

}  // namespace tactus::workbench::nurse
