// The results printed in the paper: Table 1 (insertion speeds) and Table 2 (votes on forces).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactus::experiments {

/// One cell of Table 1.
struct PublishedSpeed {
  std::string participant;  ///< S1 to S4
  std::string level;        ///< slow, medium, fast
  double mean_mm_s = 0;
  double sd_mm_s = 0;
};

/// Table 1 by participant, each from slow to fast.
std::vector<PublishedSpeed> publishedSpeeds();

/// One row of Table 2: the number of nurses, of four, who chose each term at one force.
struct PublishedVotes {
  double force_n = 0;
  std::vector<int> votes;  ///< one per term of `publishedVoteTerms`
};

/// The terms of Table 2, from the smallest force to the largest.
std::vector<std::string> publishedVoteTerms();

/// Table 2: 0.1 to 1.1 N.
std::vector<PublishedVotes> publishedVotes();

std::string_view table1Csv();  ///< Table 1 as CSV text, data/table1.csv
std::string_view table2Csv();  ///< Table 2 as CSV text, data/table2.csv

}  // namespace tactus::experiments
