// Text of the nurse's screens: follows language and text size by itself, takes as many lines as it needs, is never cut.
#pragma once

#include <QLabel>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

enum class TextRole {
  kBody,
  kLead,   ///< the one sentence of the screen: larger and bold
  kTitle,  ///< where she is: bold, muted
  kMuted,
};

class Label : public QLabel {
  Q_OBJECT

 public:
  Label(const Look& look, TextRole role, QWidget* parent = nullptr);
  Label(const Look& look, TextRole role, const Phrase& text, QWidget* parent = nullptr);

  void setPhrase(const Phrase& text);

 private:
  void follow();

  const Look& look_;
  TextRole role_;
  Phrase text_;
};

}  // namespace tactus::workbench::nurse
