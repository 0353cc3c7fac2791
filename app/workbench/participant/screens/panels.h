// Cards over a dimmed screen: a notice, a withdrawal, the choice after Force off.
#pragma once

#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/label.h"

namespace tactus::workbench {
struct ParticipantState;
}

namespace tactus::workbench::nurse {

/// A card in the middle of the dimmed window: what is said over a screen. Inside the window, so that no dialog can
/// stand above the button that stops the force.
class PanelCard : public QWidget {
  Q_OBJECT

 public:
  explicit PanelCard(const Look& look, QWidget* parent = nullptr);

 protected:
  const Look& look() const { return look_; }
  Label* addText(TextRole role, const Phrase& text);
  Button* addButton(ButtonKind kind, const Phrase& text);
  /// Below what was added before; belongs to the card from now on.
  void addWidget(QWidget* widget);

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void arrange();

  const Look& look_;
  QWidget* card_;
  QVBoxLayout* column_;
};

/// One sentence over a screen that waits for the researcher or the disk.
class NoticePanel : public PanelCard {
  Q_OBJECT

 public:
  NoticePanel(const Look& look, const Phrase& sentence, QWidget* parent = nullptr);
};

/// Withdrawal: what it deletes is said before it happens. Keeping the data is the primary button.
class WithdrawPanel : public PanelCard {
  Q_OBJECT

 public:
  explicit WithdrawPanel(const Look& look, QWidget* parent = nullptr);

 signals:
  void keep();
  void withdraw();
};

/// After "Force off" or "Pause": there is no force, and she chooses what happens next, also language and text size.
/// Nothing here needs the researcher.
class ForceOffPanel : public PanelCard {
  Q_OBJECT

 public:
  /// `languages`: those that are offered.
  ForceOffPanel(const Look& look, const std::vector<QString>& languages, QWidget* parent = nullptr);

  void setState(const ParticipantState& state);

 signals:
  void languagePicked(const QString& id);
  void textSizePicked(int percent);
  void goOn();
  void callResearcher();
  void stopForToday();
  void withdraw();

 private:
  /// Language and text size instead of what to do next, or back.
  void turnToReading(bool reading);

  Label* lead_;
  std::vector<Button*> acts_;
  Button* back_;
  bool reading_ = false;
  bool has_languages_;
  bool called_now_ = false;
  Choices* languages_;
  Choices* sizes_;
  Label* called_;
  Button* call_;
};

}  // namespace tactus::workbench::nurse
