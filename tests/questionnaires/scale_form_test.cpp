#include <gtest/gtest.h>

#include "questionnaires/form_file.h"

namespace tactus::questionnaires {
namespace {

TEST(UsabilityForm, HasTheSixStatementsOfThePaper) {
  const auto form = usabilityForm();
  EXPECT_EQ(form.id, "usability-v1");
  EXPECT_EQ(form.points, 7);
  ASSERT_EQ(form.items.size(), 6U);
  EXPECT_EQ(form.items[0].text, "The procedure of the simulator is clear.");
  EXPECT_EQ(form.items[5].text, "The simulator can be used in nursing curriculum to assist NGT insertion training.");
}

TEST(ScaleForm, BrokenFilesAreRefusedWithTheirPlace) {
  const auto refused = [](const std::string& points, const std::string& items, std::string_view what) {
    const auto form = parseScaleForm(R"({"format": "tactus-scale-form", "id": "f", "version": 1, "title": "t",
      "source": "s", "low": "no", "high": "yes", "points": )" +
                                         points + R"(, "items": )" + items + "}",
                                     "f.json");
    ASSERT_FALSE(form.has_value());
    EXPECT_NE(form.error().message().find(what), std::string::npos) << form.error().message();
  };
  refused("1", R"([{"number": 1, "text": "a"}])", "/points");
  refused("7", "[]", "no items");
  refused("7", R"([{"number": 0, "text": "a"}])", "/items/0/number");
  refused("7", R"([{"number": 1, "text": "a"}, {"number": 1, "text": "b"}])", "/items/1/number");
  refused("7", R"([{"number": 1, "text": "a"}, {"number": 2, "text": "a"}])", "/items/1/text");
  refused("7", R"([{"number": 1}])", "'text'");
  EXPECT_FALSE(parseScaleForm("[]", "f.json").has_value());
}

}  // namespace
}  // namespace tactus::questionnaires
