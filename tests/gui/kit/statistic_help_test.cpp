#include <QApplication>
#include <QLabel>
#include <gtest/gtest.h>

#include "app/workbench/kit/buttons.h"

namespace tactus::workbench {
namespace {

TEST(StatisticHelpTest, EachStatisticIsExplainedByItsNameFirst) {
  const std::pair<Statistic, const char*> all[] = {
      {Statistic::kNoticeable, "JND: "},         {Statistic::kRms, "RMS: "},
      {Statistic::kInterval, "95 % interval: "}, {Statistic::kAlpha, "Krippendorff's alpha: "},
      {Statistic::kKappa, "Fleiss' kappa: "},    {Statistic::kWeightedKappa, "κ, kappa with quadratic weights: "},
      {Statistic::kKendallW, "Kendall's W: "},   {Statistic::kConsensus, "Consensus: "},
  };
  for (const auto& [statistic, name] : all) {
    EXPECT_TRUE(explained(statistic).startsWith(QString::fromUtf8(name))) << explained(statistic).toStdString();
    EXPECT_TRUE(explained(statistic).endsWith(QLatin1Char('.')));
  }
}

TEST(StatisticHelpTest, AClickSaysWhatTheNumbersMean) {
  QWidget window;
  StatisticHelp help({Statistic::kRms, Statistic::kKendallW}, &window);
  window.show();
  EXPECT_TRUE(help.toolTip().contains(explained(Statistic::kRms)));
  EXPECT_FALSE(help.accessibleName().isEmpty());
  help.click();
  QWidget* popup = QApplication::activePopupWidget();
  ASSERT_NE(popup, nullptr);
  QStringList said;
  for (const QLabel* label : popup->findChildren<QLabel*>()) said << label->text();
  EXPECT_TRUE(said.contains(explained(Statistic::kRms)));
  EXPECT_TRUE(said.contains(explained(Statistic::kKendallW)));
  popup->close();
}

}  // namespace
}  // namespace tactus::workbench
