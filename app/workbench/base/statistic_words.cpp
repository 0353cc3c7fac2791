#include "app/workbench/base/statistic_words.h"

#include <QCoreApplication>

namespace tactus::workbench {
namespace {

struct StatisticWords {
  Q_DECLARE_TR_FUNCTIONS(StatisticWords)
};

}  // namespace

QString explained(Statistic statistic) {
  switch (statistic) {
    case Statistic::kNoticeable:
      return StatisticWords::tr(
          "JND: just-noticeable difference, √(0.04² + (0.12 F)²) N around a force F. A change below 1 JND is too small "
          "to feel.");
    case Statistic::kRms:
      return StatisticWords::tr(
          "RMS: the root of the mean squared difference. Large differences count more than in a mean.");
    case Statistic::kInterval:
      return StatisticWords::tr(
          "95 % interval: the data are drawn again many times, and 95 % of the draws give a value in this range. A "
          "wide "
          "one says that there are few data, or that they contradict each other.");
    case Statistic::kAlpha:
      return StatisticWords::tr(
          "Krippendorff's alpha: agreement beyond chance. 1 is full agreement, 0 what chance gives, less than 0 worse "
          "than chance. Ordinal: the order of the words counts; interval: their distances count too; nominal: two "
          "words "
          "are the same or not.");
    case Statistic::kKappa:
      return StatisticWords::tr(
          "Fleiss' kappa: agreement beyond chance, from 1 for full agreement to 0 for what chance gives. It takes no "
          "account of the order of the words: neighbors count as different as the ends.");
    case Statistic::kWeightedKappa:
      return StatisticWords::tr(
          "κ, kappa with quadratic weights: how well one person's answers to equal forces agree beyond chance. 1 is "
          "full "
          "agreement, 0 what chance gives; a word two steps away counts four times as much as a neighbor.");
    case Statistic::kKendallW:
      return StatisticWords::tr(
          "Kendall's W: how similarly the participants order the forces or items. 1 is one order of all, 0 no common "
          "order.");
    case Statistic::kConsensus:
      return StatisticWords::tr(
          "Consensus: 1 if all say the same word, 0 if half say the lowest and half the highest; the mean of the "
          "forces "
          "or items.");
  }
  return {};
}

}  // namespace tactus::workbench
