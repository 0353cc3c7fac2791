#include <QCoreApplication>
#include <QLabel>
#include <QTest>
#include <QVBoxLayout>
#include <gtest/gtest.h>

#include "app/workbench/kit/layout.h"

namespace tactus::workbench {
namespace {

/// A wrapped text that counts how often it is measured.
class MeasuredText : public QLabel {
 public:
  explicit MeasuredText(int& measured) : measured_(measured) {
    setWordWrap(true);
    setText(QStringLiteral("as many lines as there is room for"));
  }
  int heightForWidth(int width) const override {
    ++measured_;
    return QLabel::heightForWidth(width);
  }

 private:
  int& measured_;
};

TEST(PageStack, ATextOfThePageInSightMeasuresNoOtherPage) {
  int measured = 0;
  QWidget window;
  auto* const stack = new PageStack(&window);
  auto* const seen = new QWidget;
  auto* const line = new QLabel(QStringLiteral("one"));
  (new QVBoxLayout(seen))->addWidget(line);
  auto* const hidden = new QWidget;
  (new QVBoxLayout(hidden))->addWidget(new MeasuredText(measured));
  stack->addWidget(seen);
  stack->addWidget(hidden);
  (new QVBoxLayout(&window))->addWidget(stack);
  window.resize(400, 300);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  QCoreApplication::processEvents();
  measured = 0;
  line->setText(QStringLiteral("another one"));
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(measured, 0);
  EXPECT_EQ(line->text(), QStringLiteral("another one"));
}

}  // namespace
}  // namespace tactus::workbench
