// A session whose program is killed loses nothing that was acknowledged, and continues as it would have.
#include <gtest/gtest.h>
#include <iostream>

#include "tests/app/session/kill_rounds.h"

namespace tactus::session {
namespace {

TEST(NothingLost, WhereTheProgramIsKilled) {
  const auto outcome = sessionKillRounds(10, 20261121);
  std::cout << outcome.rounds << " kills, " << outcome.sessions << " sessions finished all the same, "
            << outcome.acknowledged << " records acknowledged, " << outcome.unacknowledged_kept
            << " kept beyond that\n";
  EXPECT_EQ(outcome.complaint, "");
  EXPECT_GE(outcome.rounds, 10);
  EXPECT_GT(outcome.sessions, 0);
  EXPECT_GT(outcome.acknowledged, 80);  // a session has about 85
}

}  // namespace
}  // namespace tactus::session
