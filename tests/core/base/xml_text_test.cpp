#include <gtest/gtest.h>

#include "core/base/text.h"

namespace tactus::base {
namespace {

TEST(XmlText, EscapesTheFiveCharactersOfMarkup) {
  EXPECT_EQ(xmlEscaped("a < b & c > \"d\" 'e'"), "a &lt; b &amp; c &gt; &quot;d&quot; &#39;e&#39;");
}

TEST(XmlText, KeepsUtf8AndReplacesWhatIsNotText) {
  EXPECT_EQ(xmlEscaped("Ösophagus"), "Ösophagus");
  EXPECT_EQ(xmlEscaped("a\x01"
                       "b"),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(xmlEscaped("a\xFF"
                       "b"),
            "a\xEF\xBF\xBD"
            "b");
}

}  // namespace
}  // namespace tactus::base
