// What happened to the open study over the screen: the first sentence, and the others on request, a line each with the
// way out where there is one, and a button that closes the line. Closed lines can be shown again.
#pragma once

#include <QStringList>

#include "app/workbench/base/messages.h"
#include "app/workbench/kit/cards.h"

class QVBoxLayout;

namespace tactus::workbench {

class StudyConnection;

class StudyNoticeStrip : public Card {
  Q_OBJECT

 public:
  explicit StudyNoticeStrip(StudyConnection& study, QWidget* parent = nullptr);

  /// All of them again, those that were closed too.
  void showAll();
  /// The lines that are shown.
  const QStringList& sentences() const { return shown_; }

 private:
  void fill();
  /// `more`: of the lines that are not shown, behind a button.
  void addLine(const StudyNotice& notice, int more);

  StudyConnection& study_;
  QVBoxLayout* lines_;
  QStringList shown_;
  QStringList closed_;
  bool unfolded_ = false;  ///< all lines are shown
};

}  // namespace tactus::workbench
