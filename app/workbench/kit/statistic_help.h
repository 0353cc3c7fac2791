// A small "?" beside statistics, which says what they mean.
#pragma once

#include <QToolButton>
#include <initializer_list>

#include "app/workbench/base/statistic_words.h"

namespace tactus::workbench {

/// The sentences are its tool tip; a click or the keyboard shows them over the window until the next click or Esc.
class StatisticHelp : public QToolButton {
  Q_OBJECT

 public:
  StatisticHelp(std::initializer_list<Statistic> statistics, QWidget* parent = nullptr);

  QSize sizeHint() const override;
};

}  // namespace tactus::workbench
