// One page of the glossary: a sentence and a picture of each level.
#pragma once

#include <QHBoxLayout>
#include <QWidget>

#include "app/workbench/anatomy/inset_view.h"
#include "app/workbench/anatomy/anatomy.h"
#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {

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

}  // namespace tactus::workbench::nurse
