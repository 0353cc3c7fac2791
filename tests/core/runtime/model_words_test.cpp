// What a model says of itself: its checksum, the words of its inputs, memberships, the parameters of its tube.
#include <cmath>
#include <cstddef>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "core/base/files/checksums.h"

#include "tests/core/runtime/runtime_models.h"
#include "tests/support/temp_folder.h"

namespace tactus {
namespace {

TEST(RuntimeWords, TheChecksumIsOfTheBytes) {
  // FIPS 180-4 by the implementation that its own test compares with the standard's examples; white space counts.
  const std::string text = model_io::formatModel(support::s4Shifted()) + "\n\n";
  const support::TempFolder folder;
  std::ofstream(folder.file("m.tactus.json"), std::ios::binary) << text;
  tactus_model* opened = nullptr;
  tactus_model* read = nullptr;
  char message[200];
  ASSERT_EQ(tactus_model_open(folder.file("m.tactus.json").c_str(), &opened, message, sizeof message), TACTUS_OK);
  ASSERT_EQ(tactus_model_read(text.data(), text.size(), &read, message, sizeof message), TACTUS_OK);
  EXPECT_EQ(tactus_model_sha256(opened), base::sha256(text));
  EXPECT_STREQ(tactus_model_sha256(read), tactus_model_sha256(opened));
  EXPECT_NE(base::sha256(text), base::sha256(model_io::formatModel(support::s4Shifted())));
  tactus_model_free(opened);
  tactus_model_free(read);
}

TEST(RuntimeWords, OfInputsTermsAndExperts) {
  auto model = support::s4Shifted();
  model.inputs[0].label.clear();
  model.inputs[2].label = "Tiefe \u00e4";
  model.inputs[2].terms[1].label = "Nasenrachen";
  model.inputs[2].terms[2].label.clear();
  model.experts[0].label = "Nurse 4";
  const auto handle = support::handleOf(model);
  EXPECT_STREQ(tactus_model_input_label(handle.get(), 0), "lubrication");
  EXPECT_STREQ(tactus_model_input_label(handle.get(), 2), "Tiefe \u00e4");
  ASSERT_EQ(tactus_model_input_terms(handle.get(), 2), model.inputs[2].terms.size());
  for (std::size_t t = 0; t < model.inputs[2].terms.size(); ++t)
    EXPECT_EQ(tactus_model_term_id(handle.get(), 2, t), model.inputs[2].terms[t].id);
  EXPECT_STREQ(tactus_model_term_label(handle.get(), 2, 1), "Nasenrachen");
  EXPECT_EQ(tactus_model_term_label(handle.get(), 2, 2), model.inputs[2].terms[2].id);
  EXPECT_STREQ(tactus_model_expert_label(handle.get(), 0), "Nurse 4");
  EXPECT_EQ(tactus_model_term_id(handle.get(), 2, 99), nullptr);
  EXPECT_EQ(tactus_model_term_label(handle.get(), 9, 0), nullptr);
  EXPECT_EQ(tactus_model_input_label(handle.get(), 4), nullptr);
  EXPECT_EQ(tactus_model_expert_label(handle.get(), 1), nullptr);
  EXPECT_EQ(tactus_model_input_terms(handle.get(), SIZE_MAX), 0U);
}

TEST(RuntimeWords, TheRoleIsThatOfTheModelFileOrOfTheId) {
  auto model = support::s4Shifted();
  const char* roles[] = {"condition", "condition", "way", "rate"};
  const auto usual = support::handleOf(model);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_STREQ(tactus_model_input_role(usual.get(), i), roles[i]);
  EXPECT_EQ(tactus_model_input_role(usual.get(), 4), nullptr);
  model.inputs[0].role = fuzzy::Role::kRate;
  model.inputs[3].role = fuzzy::Role::kCondition;
  const auto said = support::handleOf(model);
  EXPECT_STREQ(tactus_model_input_role(said.get(), 0), "rate");
  EXPECT_STREQ(tactus_model_input_role(said.get(), 3), "condition");
}

TEST(RuntimeWords, MembershipsAreThoseOfTheExpert) {
  auto model = support::ngtVariables();
  auto& depth = model.inputs[2];
  depth.terms = {{"near", "", fuzzy::Shape::kTrapezoid, {0, 0, 100, 200}},
                 {"far", "", fuzzy::Shape::kTrapezoid, {100, 200, 600, 600}}};
  for (const char* id : {"A", "B"}) {
    fuzzy::Expert expert;
    expert.id = id;
    expert.rules.push_back({{{"depth", "near"}}, "medium"});
    model.experts.push_back(expert);
  }
  // B has these words in another order, with other points, and no `far`.
  model.experts[1].overrides.push_back({"depth",
                                        {{"middle", "", fuzzy::Shape::kTriangle, {100, 200, 300}},
                                         {"near", "", fuzzy::Shape::kTrapezoid, {0, 0, 50, 250}}}});
  const auto handle = support::handleOf(model);
  const auto* const m = handle.get();
  // By hand: falling edges from 100 to 200, and from 50 to 250.
  EXPECT_EQ(tactus_model_membership(m, 0, 2, 0, 125), 0.75);
  EXPECT_EQ(tactus_model_membership(m, 0, 2, 1, 125), 0.25);
  EXPECT_EQ(tactus_model_membership(m, 1, 2, 0, 125), 0.625);
  EXPECT_EQ(tactus_model_membership(m, 1, 2, 1, 600), 0);
  // Outside of the universe as at its end, as a force takes it.
  EXPECT_EQ(tactus_model_membership(m, 0, 2, 1, 1e9), 1);
  EXPECT_EQ(tactus_model_membership(m, 0, 2, 0, -5), 1);
  EXPECT_TRUE(std::isnan(tactus_model_membership(m, 0, 2, 0, std::nan(""))));
  EXPECT_TRUE(std::isnan(tactus_model_membership(m, 0, 2, 0, INFINITY)));
  EXPECT_EQ(tactus_model_membership(m, 2, 2, 0, 125), 0);
  EXPECT_EQ(tactus_model_membership(m, 0, 4, 0, 125), 0);
  EXPECT_EQ(tactus_model_membership(m, 0, 2, 2, 125), 0);
}

TEST(RuntimeWords, TheRendererOfTheFile) {
  auto model = support::s4Shifted();
  model.renderer.reset();
  tactus_renderer found{};
  found.size = sizeof found;
  tactus_model_renderer(support::handleOf(model).get(), &found);
  const fuzzy::RendererParameters usual;
  EXPECT_EQ(found.stiffness_n_mm, usual.stiffness_n_mm);
  EXPECT_EQ(found.slew_n_s, usual.slew_n_s);

  model.renderer.emplace();
  double next = 0.0001;
  for (const auto& field : fuzzy::kRendererFields) (*model.renderer).*field.member = next += 0.0001;
  const auto handle = support::handleOf(model);
  tactus_model_renderer(handle.get(), &found);
  const auto& wanted = *model.renderer;
  EXPECT_EQ(found.stiffness_n_mm, wanted.stiffness_n_mm);
  EXPECT_EQ(found.damping_n_s_mm, wanted.damping_n_s_mm);
  EXPECT_EQ(found.breakaway_ratio, wanted.breakaway_ratio);
  EXPECT_EQ(found.restick_mm, wanted.restick_mm);
  EXPECT_EQ(found.withdrawal_ratio, wanted.withdrawal_ratio);
  EXPECT_EQ(found.relaxation_s, wanted.relaxation_s);
  EXPECT_EQ(found.ageing_s, wanted.ageing_s);
  EXPECT_EQ(found.stick_speed_mm_s, wanted.stick_speed_mm_s);
  EXPECT_EQ(found.stick_time_s, wanted.stick_time_s);
  EXPECT_EQ(found.velocity_filter_hz, wanted.velocity_filter_hz);
  EXPECT_EQ(found.slew_n_s, wanted.slew_n_s);
  EXPECT_EQ(found.depth_offset_mm, wanted.depth_offset_mm);

  // A caller that knows less gets less.
  tactus_renderer small{};
  small.size = offsetof(tactus_renderer, breakaway_ratio);
  small.breakaway_ratio = 5;
  tactus_model_renderer(handle.get(), &small);
  EXPECT_EQ(small.damping_n_s_mm, wanted.damping_n_s_mm);
  EXPECT_EQ(small.breakaway_ratio, 5);
}

}  // namespace
}  // namespace tactus
