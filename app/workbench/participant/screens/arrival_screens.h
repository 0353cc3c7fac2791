// The screens of the arrival: welcome, consent, about you.
#pragma once

#include <QLineEdit>
#include <QWidget>

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

// Welcome: language, size of the text, and the participant's code, new or known.

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
  void refreshState();

  const Look& look_;
  QLineEdit* edit_;
};

class WelcomeScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit WelcomeScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;
  /// Asks for a code.
  void enterCode();

 signals:
  void languagePicked(const QString& language);
  void textSizePicked(int percent);
  void newHere();
  void teacherHere();
  void codeEntered(const QString& code);

 protected:
  /// From the first page to the one that asks for a code, and back. The course knows neither.
  bool turnPage(int by) override;
  bool hasPageBefore() const override { return asksForCode(); }

 private:
  void show();
  void showChoices();
  bool asksForCode() const { return has_code_ && state_.welcome.step == WelcomeState::Step::kStart; }

  ParticipantState state_;
  bool has_code_ = false;  ///< she says so, and may not have typed it yet
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

// Consent: what she agrees to, as pages. Without consent there is no session.

class ConsentScreen : public ScreenFrame {
  Q_OBJECT

 public:
  explicit ConsentScreen(const Look& look, QWidget* parent = nullptr);

  void setState(const ParticipantState& state) override;

 signals:
  void declined();

 protected:
  bool turnPage(int by) override;
  bool hasPageBefore() const override { return text_->page() > 0; }

 private:
  void showPage();

  PagedText* text_;
};

}  // namespace tactus::workbench::nurse
