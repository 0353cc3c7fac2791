#include <gtest/gtest.h>

#include "app/report/html.h"

namespace tactus::report {
namespace {

TEST(ReportMarkup, PlainTextIsEscapedOnceWhenJoined) {
  const Markup joined = strong("x < y") + " & " + badge(Badge::kSimulated);
  EXPECT_EQ(joined.html(), "<strong>x &lt; y</strong> &amp; <span class=\"badge simulated\">simulated</span>");
}

TEST(ReportMarkup, EveryBadgeHasItsWord) {
  EXPECT_EQ(name(Badge::kPublished), "published");
  EXPECT_EQ(name(Badge::kSimulated), "simulated");
  EXPECT_EQ(name(Badge::kComputed), "computed");
  EXPECT_EQ(name(Badge::kByConstruction), "by construction");
}

}  // namespace
}  // namespace tactus::report
