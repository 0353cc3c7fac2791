// The words of the questions, before the questions: what is asked, and the levels of each condition as pictures.
#pragma once

#include <QHBoxLayout>
#include <QStackedWidget>
#include <QWidget>

#include "app/workbench/anatomy/anatomy.h"
#include "app/workbench/anatomy/inset_view.h"
#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

/// One page of the glossary: a sentence and a picture of each level.
class GlossaryPage : public QWidget {
  Q_OBJECT

 public:
  GlossaryPage(const Look& look, TextRole role, const Phrase& sentence, QWidget* parent = nullptr);

  void addPicture(const Phrase& word, Picture picture);
  void addPosture(const Phrase& word, anatomy::Posture posture);
  /// The five regions, each with its name.
  void addRegions();
  /// The whole way from the side, with the tube in the stomach.
  void addWay(const Phrase& word);
  void addInset(const Phrase& word, anatomy::Inset inset);

 private:
  void addColumn(const Phrase& word, QWidget* picture, bool grows);

  const Look& look_;
  QHBoxLayout* row_;
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
  QStackedWidget* pages_;
};

}  // namespace tactus::workbench::nurse
