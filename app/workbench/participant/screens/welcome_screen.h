// Welcome: language, size of the text, and the participant's code, new or known.
#pragma once

#include <QLineEdit>
#include <QWidget>

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/text_block.h"

namespace tactus::workbench::nurse {

/// Where a participant types her code.
class CodeField : public QWidget {
  Q_OBJECT

 public:
  explicit CodeField(const Look& look, QWidget* parent = nullptr);

  QString code() const { return edit_->text().simplified(); }
  void takeFocus() { edit_->setFocus(); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void edited();
  void entered();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void follow();

  const Look& look_;
  QLineEdit* edit_;
};

enum class WelcomeStep {
  kStart,      ///< language, size, new or known
  kNewCode,    ///< shows the new code
  kEnterCode,  ///< asks for a code
  kWelcomeBack,
};

struct WelcomeState {
  WelcomeStep step = WelcomeStep::kStart;
  std::vector<Language> languages = {kLanguages.begin(), kLanguages.end()};  ///< with one alone nothing is to be chosen
  QString code;
  int minutes = 30;  ///< that a session takes, about
  int kept_answers = 0;
  bool code_unknown = false;
  QString meant;  ///< a code that she may have meant; may be empty
  bool simulated = false;
};

class WelcomeScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit WelcomeScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const WelcomeState& state);

 signals:
  void languagePicked(tactus::workbench::nurse::Language language);
  void textSizePicked(int percent);
  void newHere();
  void teacherHere();
  void haveCode();
  void codeEntered(const QString& code);
  void goOn();  ///< from the new code, or from Welcome back

 private:
  void showChoices();
  void press();

  WelcomeState state_;
  TextBlock* texts_;
  Label* line_;
  Label* language_title_;
  Choices* languages_;
  Label* size_title_;
  Choices* sizes_;
  Label* lead_;
  CodeField* field_;
  Label* unknown_;
  Button* meant_;
  Button* have_code_;
  Button* teach_;
};

}  // namespace tactus::workbench::nurse
