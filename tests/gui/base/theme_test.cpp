#include "app/workbench/base/theme.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <cstdint>
#include <gtest/gtest.h>

#include "app/figures/colors.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/plot/term_marks.h"
#include "app/workbench/understand/curves/curve_legend.h"

namespace tactus::workbench {
namespace {

double contrast(const QColor& one, const QColor& other) {
  const auto rgb = [](const QColor& c) {
    return figures::Rgb{static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()),
                        static_cast<std::uint8_t>(c.blue())};
  };
  return figures::contrast(rgb(one), rgb(other));
}

struct Wanted {
  const char* what;
  QColor color;
  QColor ground;
  double least;
};

class Theme : public testing::TestWithParam<theme::Look> {
 protected:
  void SetUp() override { theme::changeLook(*qApp, GetParam()); }
  void TearDown() override { theme::changeLook(*qApp, theme::Look::kLight); }
};

// WCAG 2.1: 4.5 for text, 3 for edges and lines that carry a meaning.
TEST_P(Theme, EveryPairReachesItsContrast) {
  using QP = QPalette;
  const QPalette colors = QApplication::palette();
  std::vector<Wanted> pairs;
  for (const QColor& ground : {theme::card(), theme::window(), colors.color(QP::Button)}) {
    pairs.push_back({"text", theme::ink(), ground, 4.5});
    pairs.push_back({"secondary text", theme::mutedInk(), ground, 4.5});
    pairs.push_back({"error", theme::errorInk(), ground, 4.5});
    pairs.push_back({"warning", theme::warningInk(), ground, 4.5});
    pairs.push_back({"disabled text", colors.color(QP::Disabled, QP::Text), ground, 4.5});
    pairs.push_back({"edge of a field", theme::fieldEdge(), ground, 3});
    pairs.push_back({"accent", theme::accent(), ground, 3});
  }
  pairs.push_back({"warning on its fill", theme::warningInk(), theme::warningFill(), 4.5});
  pairs.push_back({"error on its fill", theme::errorInk(), theme::errorFill(), 4.5});
  pairs.push_back({"selected text", colors.color(QP::HighlightedText), colors.color(QP::Highlight), 4.5});
  pairs.push_back({"tool tip", colors.color(QP::ToolTipText), colors.color(QP::ToolTipBase), 4.5});
  pairs.push_back({"accent as text", theme::readableText(theme::accent()), theme::card(), 4.5});
  pairs.push_back({"mean", theme::mean(), theme::card(), 3});
  pairs.push_back({"friction", theme::friction(), theme::card(), 3});
  for (std::size_t expert = 0; expert < 6; ++expert) {
    pairs.push_back({"expert", theme::expert(expert), theme::card(), 3});
    pairs.push_back({"expert as text", theme::readableText(theme::expert(expert)), theme::card(), 4.5});
    for (std::size_t other = 0; other < expert; ++other) EXPECT_NE(theme::expert(expert), theme::expert(other));
  }
  for (std::size_t term = 0; term < 5; ++term) {
    const QColor fill = theme::force(term, 5);
    pairs.push_back({"line of a force term", theme::readableLine(fill), theme::card(), 3});
    pairs.push_back({"word of a force term", theme::readableText(fill), theme::card(), 4.5});
    pairs.push_back({"ink on a force term", theme::inkOn(fill), fill, 4.5});
  }
  for (const Wanted& pair : pairs) {
    EXPECT_GE(contrast(pair.color, pair.ground), pair.least)
        << pair.what << ": " << pair.color.name().toStdString() << " on " << pair.ground.name().toStdString();
  }
}

// What is painted, not only what is meant.
TEST_P(Theme, AFieldIsSeenOnItsCard) {
  QWidget card;
  QPalette ground = card.palette();
  ground.setColor(QPalette::Window, theme::card());
  card.setPalette(ground);
  card.resize(240, 120);
  QLineEdit typed(&card);
  typed.setGeometry(20, 20, 200, 28);
  QComboBox chosen(&card);
  chosen.setGeometry(20, 70, 200, 28);
  const QImage picture = card.grab().toImage();
  for (const QWidget* field : {static_cast<QWidget*>(&typed), static_cast<QWidget*>(&chosen)}) {
    double most = 0;
    // Down the left edge, at the middle of the height.
    for (int x = -1; x <= 2; ++x) {
      most =
          std::max(most, contrast(picture.pixelColor(field->x() + x, field->geometry().center().y()), theme::card()));
    }
    EXPECT_GE(most, 2.9);
  }
}

// An expert's line is thin, and lies on the band of a region (13 % of its color) and on the range of the experts.
TEST_P(Theme, TheLineOfAnExpertIsSeenWhereverItRuns) {
  const QColor range = rangeLook({}).fill.color();
  // Nasal cavity to stomach: app/figures/colors.cpp.
  for (const QRgb region : {0x8C6D46, 0x6B7F3F, 0x3E8273, 0x4A78A6, 0x7C6BAA, 0xA3617F}) {
    const QColor band = mixedColor(theme::card(), QColor::fromRgb(region), 0.13);
    const QColor ground = mixedColor(band, range, range.alphaF());
    for (std::size_t expert = 0; expert < 6; ++expert) {
      EXPECT_GE(contrast(expertPen(expert, 6).color(), ground), 2.95)
          << expert << " on " << ground.name().toStdString();
    }
  }
  // Of hundreds each alone is pale, and seen on the card.
  for (std::size_t expert = 0; expert < 6; ++expert) {
    EXPECT_GE(contrast(expertPen(expert, 256).color(), theme::card()), 2.95) << expert;
  }
}

// A plot keeps its pens when the look changes.
TEST_P(Theme, TheColorOfAnExpertFollowsTheLook) {
  const QColor here = theme::expert(0);
  const bool dark = GetParam() == theme::Look::kDark;
  theme::changeLook(*qApp, dark ? theme::Look::kLight : theme::Look::kDark);
  EXPECT_EQ(theme::inLook(here), theme::expert(0));
  EXPECT_NE(here, theme::expert(dark ? 1 : 0));
}

INSTANTIATE_TEST_SUITE_P(Looks, Theme, testing::Values(theme::Look::kLight, theme::Look::kDark));

}  // namespace
}  // namespace tactus::workbench
