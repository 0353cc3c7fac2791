// Pages on each other, of which one is in sight.
#pragma once

#include <QStackedWidget>

namespace tactus::workbench {

/// A stack whose height does not follow from its width. Otherwise each label that gets another text anywhere in the
/// window has every wrapped text of every page measured again, also of the pages out of sight.
class PageStack : public QStackedWidget {
 public:
  using QStackedWidget::QStackedWidget;
  bool hasHeightForWidth() const override { return false; }
};

}  // namespace tactus::workbench
