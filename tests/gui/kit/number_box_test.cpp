// What is typed into a field is that number or nothing: a decimal comma, a number out of range, a word.
#include "app/workbench/kit/number_box.h"

#include <QLineEdit>
#include <QLocale>
#include <QTest>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "app/workbench/base/display_text.h"

#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

struct Typed {
  const char* text;
  double value;
};

const fuzzy::Variable kDepthInput{"depth", "Insertion depth", "mm", 0, 600, {}};

/// In the locale of the C library and in one with a decimal comma.
class InLocale : public testing::TestWithParam<QLocale::Language> {
 protected:
  InLocale() : before_(QLocale()) {
    QLocale::setDefault(GetParam() == QLocale::C ? QLocale::c() : QLocale(GetParam(), QLocale::Germany));
  }
  ~InLocale() override { QLocale::setDefault(before_); }

 private:
  QLocale before_;
};

void type(NumberBox& box, const QString& text) {
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, text);
}

void enter(NumberBox& box, const QString& text) {
  type(box, text);
  QTest::keyClick(&box, Qt::Key_Return);
}

TEST_P(InLocale, WhatIsTypedIsTheNumber) {
  NumberBox box(kDepthInput, 1);
  box.show();
  const Typed numbers[] = {{"13,5", 13.5}, {"13.5", 13.5},   {"1e2", 100},         {"1E2", 100}, {"1,35e1", 13.5},
                           {"+4", 4},      {"0,001", 0.001}, {"13.5678", 13.5678}, {" 7 ", 7},   {"12 mm", 12},
                           {"12mm", 12},   {"1e-7", 1e-7},   {".5", 0.5},          {",5", 0.5},  {"600", 600}};
  for (const Typed& number : numbers) {
    enter(box, QString::fromUtf8(number.text));
    EXPECT_EQ(box.value(), number.value) << number.text;
    EXPECT_EQ(box.exact(), number.value) << number.text;
    EXPECT_TRUE(box.refusal().isEmpty()) << number.text;
    // What is shown reads back as that number too.
    EXPECT_EQ(box.valueFromText(box.text()), number.value) << box.text().toStdString();
  }
}

TEST_P(InLocale, WhatIsNoNumberStaysAndChangesNothing) {
  NumberBox box(kDepthInput, 1);
  box.show();
  std::vector<double> changes;
  QObject::connect(&box, &NumberBox::valueChanged, [&](double value) { changes.push_back(value); });
  enter(box, QStringLiteral("50"));
  ASSERT_EQ(changes, std::vector<double>{50});
  for (const char* typed : {"9999", "-1", "1.234,5", "1,2,3", "deep", "13;5", "inf", "nan", "1e999", "13 cm", "1 3"}) {
    enter(box, QString::fromUtf8(typed));
    EXPECT_EQ(box.value(), 50) << typed;
    EXPECT_TRUE(box.findChild<QLineEdit*>()->text().contains(QString::fromUtf8(typed)))
        << typed << " " << box.text().toStdString();
    EXPECT_TRUE(box.refusal().endsWith(QLatin1Char('.'))) << typed;
    EXPECT_EQ(box.toolTip(), box.refusal());
    // A refresh with the number as it is takes nothing away; one with another number does.
    box.setValue(50);
    EXPECT_FALSE(box.refusal().isEmpty()) << typed;
    enter(box, QStringLiteral("51"));
    EXPECT_TRUE(box.refusal().isEmpty());
    box.setValue(50);
    changes.clear();
  }
  EXPECT_TRUE(changes.empty());
}

INSTANTIATE_TEST_SUITE_P(NumberBox, InLocale, testing::Values(QLocale::C, QLocale::German));

TEST(NumberBox, LeavingTheFieldChecksItToo) {
  QWidget window;
  NumberBox box(kDepthInput, 1, &window);
  QLineEdit other(&window);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  type(box, QStringLiteral("9999"));
  other.setFocus();
  EXPECT_EQ(box.value(), 0);
  EXPECT_EQ(box.refusal().toStdString(), "9999 mm is outside 0 to 600 mm.");
  type(box, QStringLiteral("13,5"));
  EXPECT_TRUE(box.refusal().isEmpty());  // it is being mended
  other.setFocus();
  EXPECT_EQ(box.value(), 13.5);
}

TEST(NumberBox, EscAndTheEndOfThePageBringTheValueBack) {
  NumberBox box(kDepthInput, 1);
  box.show();
  enter(box, QStringLiteral("50"));
  const QString shown = box.text();
  enter(box, QStringLiteral("9999"));
  ASSERT_FALSE(box.refusal().isEmpty());
  QTest::keyClick(&box, Qt::Key_Escape);
  EXPECT_TRUE(box.refusal().isEmpty());
  EXPECT_EQ(box.text(), shown);
  enter(box, QStringLiteral("9999"));
  box.hide();
  box.show();
  EXPECT_TRUE(box.refusal().isEmpty());
  EXPECT_EQ(box.text(), shown);
  EXPECT_EQ(box.value(), 50);
}

TEST(NumberBox, WholeNumbersOnly) {
  NumberBox box({"parts", {}, "1", 2, 8, {}}, 1);
  box.setWhole();
  box.show();
  enter(box, QStringLiteral("2,5"));
  EXPECT_EQ(box.value(), 2);
  EXPECT_EQ(box.refusal().toStdString(), "2.5 is no whole number.");
  enter(box, QStringLiteral("5"));
  EXPECT_EQ(box.value(), 5);
}

TEST(TypedNumbers, ListsNeverTurnOneNumberIntoTwo) {
  using Numbers = std::vector<double>;
  const auto numbers = [](const char* typed) { return typedNumbers(QString::fromUtf8(typed), QStringLiteral("mm")); };
  EXPECT_EQ(numbers("290; 365").value(), (Numbers{290, 365}));
  EXPECT_EQ(numbers("290, 365").value(), (Numbers{290, 365}));
  EXPECT_EQ(numbers("290,5; 365").value(), (Numbers{290.5, 365}));
  EXPECT_EQ(numbers("290.5,365.5").value(), (Numbers{290.5, 365.5}));
  EXPECT_EQ(numbers("290 mm").value(), Numbers{290});
  EXPECT_EQ(numbers("290,365").error().toStdString(), "“290,365” can be one number or two: type 290.365 or 290; 365.");
  for (const char* typed : {"", "290;", "290; x", "290 365"}) EXPECT_FALSE(numbers(typed).has_value()) << typed;
}

/// The fields of the whole window, in the stages where a model is tuned and felt.
class NumberFields : public tests::ShownBench {
 protected:
  NumberFields() : ShownBench(Stage::kTune) {}
};

TEST_F(NumberFields, NoFieldOfTheWindowMisreads) {
  int fields = 0;
  for (const Stage stage : {Stage::kUnderstand, Stage::kTune}) {
    bench.window.enter(stage);
    settle();
    for (auto* plain : bench.window.findChildren<QAbstractSpinBox*>()) {
      if (!plain->isVisible() || !plain->isEnabled()) continue;
      auto* box = qobject_cast<NumberBox*>(plain);
      ASSERT_NE(box, nullptr) << plain->accessibleName().toStdString();
      ++fields;
      const double before = box->value();
      box->setFocus();
      box->selectAll();
      QTest::keyClicks(box, QStringLiteral("99999"));
      QTest::keyClick(box, Qt::Key_Return);
      EXPECT_EQ(box->value(), before) << box->accessibleName().toStdString();
      EXPECT_FALSE(box->refusal().isEmpty()) << box->accessibleName().toStdString();
    }
  }
  EXPECT_GT(fields, 5);
}

}  // namespace
}  // namespace tactus::workbench
