#include "app/report/markup.h"

#include <gtest/gtest.h>

namespace tactus::report {
namespace {

TEST(ReportMarkup, EscapesTheFiveCharactersOfMarkup) {
  EXPECT_EQ(escaped("a < b & c > \"d\" 'e'"), "a &lt; b &amp; c &gt; &quot;d&quot; &#39;e&#39;");
}

TEST(ReportMarkup, KeepsUtf8AndReplacesWhatIsNotText) {
  EXPECT_EQ(escaped("Ösophagus"), "Ösophagus");
  EXPECT_EQ(escaped("a\x01"
                    "b"),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(escaped("a\xFF"
                    "b"),
            "a\xEF\xBF\xBD"
            "b");
}

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
