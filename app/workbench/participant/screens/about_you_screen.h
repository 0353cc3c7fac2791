// About you: one question at a time, nothing chosen at the start, and no answer is forced.
#pragma once

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

enum class AboutQuestion { kYears, kHand, kGloves, kHaptic, kComfort };

/// The ids of the answers: years_1 to years_4; left, right, both; haptic_0 to haptic_2; yes, no; not_say.
std::vector<Answer> answersTo(AboutQuestion question);

struct AboutYouState {
  AboutQuestion question = AboutQuestion::kYears;
  QString chosen;
  bool simulated = false;
};

class AboutYouScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit AboutYouScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const AboutYouState& state);

 signals:
  void picked(const QString& answer);
  void confirmed(tactus::workbench::nurse::AboutQuestion question);

 private:
  AboutYouState state_;
  TextBlock* texts_;
  Label* lead_;
  Choices* choices_;
};

}  // namespace tactus::workbench::nurse
