#include <QApplication>
#include <gtest/gtest.h>

#include "app/workbench/kit/labels.h"

namespace tactus::workbench {
namespace {

QString broken(const char* label, double width) {
  return brokenLabel(QString::fromLatin1(label), width, QFontMetricsF(QApplication::font()));
}

double widthOf(const char* text) {
  return QFontMetricsF(QApplication::font()).horizontalAdvance(QString::fromLatin1(text));
}

TEST(LabelBreak, ALabelWithRoomStaysWhole) {
  EXPECT_EQ(broken("Laryngopharynx", widthOf("Laryngopharynx") + 1), QStringLiteral("Laryngopharynx"));
}

TEST(LabelBreak, BreaksBehindTheVowelInTheMiddle) {
  EXPECT_EQ(broken("Laryngopharynx", widthOf("Laryngo-") + 1), QStringLiteral("Laryngo-\npharynx"));
  EXPECT_EQ(broken("Nasopharynx", widthOf("pharynx") + 1), QStringLiteral("Naso-\npharynx"));
}

TEST(LabelBreak, BreaksAtASpace) {
  EXPECT_EQ(broken("Upper esophagus", widthOf("esophagus") + 1), QStringLiteral("Upper\nesophagus"));
}

TEST(LabelBreak, WhatStillDoesNotFitIsCut) {
  const QString cut = broken("Laryngopharynx", widthOf("Lary…"));
  EXPECT_TRUE(cut.contains(QChar(0x2026)));
}

}  // namespace
}  // namespace tactus::workbench
