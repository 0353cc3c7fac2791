// What a statistic on the screen means, in one or two sentences for the place where it stands.
#pragma once

#include <QString>

namespace tactus::workbench {

enum class Statistic {
  kNoticeable,     ///< JND
  kRms,            ///< root mean square
  kInterval,       ///< 95 % of the draws
  kAlpha,          ///< Krippendorff (2013), Content Analysis, ch. 12
  kKappa,          ///< Fleiss (1971)
  kWeightedKappa,  ///< Cohen (1968), quadratic weights
  kKendallW,       ///< Kendall and Babington Smith (1939)
  kConsensus,      ///< Tastle and Wierman (2007)
};

/// Begins with the name of the statistic: `RMS: the root of …`.
QString explained(Statistic statistic);

}  // namespace tactus::workbench
