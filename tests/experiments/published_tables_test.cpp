#include "experiments/published_tables.h"

#include <gtest/gtest.h>
#include <numeric>

namespace tactus::experiments {
namespace {

// Table 1 as the paper lays it out: one row per level, one column per participant.
TEST(PublishedTables, Table1) {
  const struct {
    const char* level;
    double mean_sd[4][2];
  } rows[] = {{"slow", {{46.0, 17.1}, {121.1, 35.7}, {57.9, 18.1}, {31.1, 8.9}}},
              {"medium", {{129.2, 40.1}, {168.9, 61.6}, {106.0, 25.0}, {38.0, 13.8}}},
              {"fast", {{256.7, 102.1}, {180.3, 92.4}, {170.7, 55.0}, {44.4, 18.7}}}};
  const auto speeds = publishedSpeeds();
  ASSERT_EQ(speeds.size(), 12U);
  std::size_t cell = 0;
  for (int person = 0; person < 4; ++person) {
    for (const auto& row : rows) {
      EXPECT_EQ(speeds[cell].participant, "S" + std::to_string(person + 1));
      EXPECT_EQ(speeds[cell].level, row.level);
      EXPECT_EQ(speeds[cell].mean_mm_s, row.mean_sd[person][0]);
      EXPECT_EQ(speeds[cell].sd_mm_s, row.mean_sd[person][1]);
      ++cell;
    }
  }
}

TEST(PublishedTables, Table2) {
  const std::vector<std::vector<int>> counts = {{3, 1, 0, 0, 0}, {2, 1, 1, 0, 0}, {1, 1, 1, 1, 0}, {0, 2, 1, 0, 1},
                                                {0, 0, 2, 1, 1}, {0, 0, 2, 1, 1}, {0, 0, 1, 2, 1}, {0, 0, 1, 1, 2},
                                                {0, 0, 0, 2, 2}, {0, 0, 0, 1, 3}, {0, 0, 0, 0, 4}};
  const auto rows = publishedVotes();
  ASSERT_EQ(rows.size(), counts.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].force_n, static_cast<double>(i + 1) / 10);
    EXPECT_EQ(rows[i].votes, counts[i]);
    EXPECT_EQ(std::accumulate(rows[i].votes.begin(), rows[i].votes.end(), 0), 4);  // four nurses
  }
  EXPECT_EQ(publishedVoteTerms(), (std::vector<std::string>{"very_small", "small", "medium", "large", "very_large"}));
}

}  // namespace
}  // namespace tactus::experiments
