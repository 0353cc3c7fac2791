// Whatever the caller passes: a status, a force of 0, or nothing.
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "tests/core/runtime/c99_program.h"
#include "tests/core/runtime/runtime_models.h"
#include "tests/support/temp_folder.h"

namespace tactus {
namespace {

const double kNaN = std::nan("");
const double kInfinity = std::numeric_limits<double>::infinity();

TEST(RuntimeArguments, NullIsNoCrash) {
  char message[200];
  tactus_model* model = nullptr;
  tactus_scene* scene = nullptr;
  tactus_tube* tube = nullptr;
  tactus_feel feel = {};
  feel.size = sizeof feel;
  double force_n = 5;
  unsigned char told = 5;
  int fired = 5;
  const double point[4] = {};

  EXPECT_EQ(tactus_model_open(nullptr, &model, message, sizeof message), TACTUS_BAD_ARGUMENT);
  EXPECT_STREQ(message, "path: found a null pointer, wanted the name of a file");
  EXPECT_EQ(tactus_model_open("x", nullptr, message, sizeof message), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_model_read(nullptr, 5, &model, message, sizeof message), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_model_read("{}", 2, nullptr, nullptr, 0), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_scene_make(nullptr, nullptr, nullptr, 0, &scene, message, sizeof message), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_scene_make(nullptr, nullptr, nullptr, 0, nullptr, message, sizeof message), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_tube_make(nullptr, &tube, message, sizeof message), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_tube_make(nullptr, nullptr, message, sizeof message), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_tube_step(nullptr, 0, 1, 0.001, &feel), TACTUS_BAD_ARGUMENT);

  EXPECT_EQ(tactus_model_name(nullptr), nullptr);
  EXPECT_EQ(tactus_model_input_id(nullptr, 0), nullptr);
  EXPECT_EQ(tactus_model_input_unit(nullptr, 0), nullptr);
  EXPECT_EQ(tactus_model_expert_id(nullptr, 0), nullptr);
  EXPECT_EQ(tactus_model_inputs(nullptr) + tactus_model_experts(nullptr) + tactus_scene_inputs(nullptr), 0U);
  EXPECT_EQ(tactus_model_input_min(nullptr, 0) + tactus_model_input_max(nullptr, 0), 0);
  EXPECT_EQ(tactus_model_output_min(nullptr) + tactus_model_output_max(nullptr), 0);
  EXPECT_EQ(tactus_model_expert_weight(nullptr, 0), 0);
  EXPECT_EQ(tactus_clamped(nullptr, point), 0);
  EXPECT_EQ(tactus_clamped_inputs(nullptr, point), 0U);
  EXPECT_EQ(tactus_model_sha256(nullptr), nullptr);
  EXPECT_EQ(tactus_model_input_label(nullptr, 0), nullptr);
  EXPECT_EQ(tactus_model_term_id(nullptr, 0, 0), nullptr);
  EXPECT_EQ(tactus_model_term_label(nullptr, 0, 0), nullptr);
  EXPECT_EQ(tactus_model_expert_label(nullptr, 0), nullptr);
  EXPECT_EQ(tactus_model_input_role(nullptr, 0), nullptr);
  EXPECT_EQ(tactus_model_input_terms(nullptr, 0), 0U);
  EXPECT_EQ(tactus_model_membership(nullptr, 0, 0, 0, 1), 0);
  tactus_renderer renderer = {};
  renderer.size = sizeof renderer;
  tactus_model_renderer(nullptr, &renderer);
  EXPECT_EQ(renderer.stiffness_n_mm, 0);

  EXPECT_EQ(tactus_force(nullptr, point, &fired), 0);
  EXPECT_EQ(fired, 0);
  EXPECT_EQ(tactus_expert_force(nullptr, 0, point, &(fired = 5)), 0);
  EXPECT_EQ(fired, 0);
  EXPECT_EQ(tactus_scene_force(nullptr, point, &(fired = 5)), 0);
  EXPECT_EQ(fired, 0);
  tactus_force_batch(nullptr, point, 1, &force_n, &told);
  EXPECT_EQ(force_n + told, 0);
  tactus_scene_force_batch(nullptr, point, 1, &(force_n = 5), &(told = 5));
  EXPECT_EQ(force_n + told, 0);
  tactus_force_batch(nullptr, nullptr, 1, nullptr, nullptr);
  tactus_scene_force_batch(nullptr, nullptr, 1, nullptr, nullptr);
  tactus_tube_place(nullptr, 1);
  tactus_tube_scene(nullptr, nullptr, 1);
  tactus_model_free(nullptr);
  tactus_scene_free(nullptr);
  tactus_tube_free(nullptr);
  EXPECT_TRUE(model == nullptr && scene == nullptr && tube == nullptr);
}

TEST(RuntimeArguments, APointThatIsNotThereGivesNoForce) {
  const auto handle = support::handleOf(support::s4Shifted());
  const auto scene = support::ngtSceneHandle(handle.get(), 1, 45);
  double forces[3] = {5, 5, 5};
  unsigned char told[3] = {5, 5, 5};
  int fired = 5;
  EXPECT_EQ(tactus_force(handle.get(), nullptr, &fired), 0);
  EXPECT_EQ(fired, 0);
  EXPECT_EQ(tactus_scene_force(scene.get(), nullptr, &(fired = 5)), 0);
  EXPECT_EQ(fired, 0);
  EXPECT_EQ(tactus_expert_force(handle.get(), 0, nullptr, &(fired = 5)), 0);
  EXPECT_EQ(fired, 0);
  EXPECT_EQ(tactus_clamped(handle.get(), nullptr), 0);
  tactus_model_renderer(handle.get(), nullptr);
  const double point[] = {1, 45, 30, 30};
  EXPECT_EQ(tactus_expert_force(handle.get(), 1, point, &(fired = 5)), 0);
  EXPECT_EQ(fired, 0);
  tactus_force_batch(handle.get(), nullptr, 3, forces, told);
  EXPECT_EQ(forces[2] + told[2], 0);
  tactus_force_batch(handle.get(), point, 1, nullptr, told);
  tactus_force_batch(handle.get(), point, 0, forces, told);
  EXPECT_EQ(tactus_model_input_id(handle.get(), 4), nullptr);
  EXPECT_EQ(tactus_model_expert_id(handle.get(), 1), nullptr);
  EXPECT_EQ(tactus_model_input_max(handle.get(), SIZE_MAX), 0);
}

TEST(RuntimeArguments, AnInputThatIsNotFiniteGivesNoNumber) {
  const auto handle = support::handleOf(support::s4Shifted());
  for (const double odd : {kNaN, kInfinity, -kInfinity}) {
    const double point[] = {1, odd, 30, 30};
    int fired = 5;
    EXPECT_TRUE(std::isnan(tactus_force(handle.get(), point, &fired)));
    EXPECT_EQ(fired, 0);
    EXPECT_TRUE(std::isnan(tactus_expert_force(handle.get(), 0, point, nullptr)));
  }
}

TEST(RuntimeArguments, AModelThatIsNoneSaysWhere) {
  const support::TempFolder folder;
  tactus_model* model = nullptr;
  char message[400];
  EXPECT_EQ(tactus_model_open(folder.file("none.json").c_str(), &model, message, sizeof message), TACTUS_BAD_FILE);
  EXPECT_NE(std::string(message).find("none.json"), std::string::npos);
  EXPECT_EQ(model, nullptr);
  auto wrong = support::s4Shifted();
  wrong.experts[0].rules[3].then = "tiny";
  const std::string text = model_io::formatModel(wrong);
  EXPECT_EQ(tactus_model_read(text.data(), text.size(), &model, message, sizeof message), TACTUS_BAD_FILE);
  EXPECT_EQ(std::string(message).rfind("model: /experts/0/rules/3/then: found 'tiny', wanted", 0), 0U) << message;
  EXPECT_EQ(tactus_model_read("", 0, &model, message, sizeof message), TACTUS_BAD_FILE);
}

TEST(RuntimeArguments, AWarningIsNoFailure) {
  std::string text = model_io::formatModel(support::s4Shifted());
  text.replace(text.find("\"unit\""), 0, "\"colour\": 1, ");
  tactus_model* model = nullptr;
  char message[400];
  ASSERT_EQ(tactus_model_read(text.data(), text.size(), &model, message, sizeof message), TACTUS_OK);
  EXPECT_STREQ(message, "model: /inputs/0/colour: unknown key, dropped");
  tactus_model_free(model);
}

TEST(RuntimeArguments, AMessageIsCutBetweenCharacters) {
  tactus_model* model = nullptr;
  const std::string path = "/no/\u00e4\u20ac/x";
  std::string whole(400, '\0');
  tactus_model_open(path.c_str(), &model, whole.data(), whole.size());
  whole.resize(std::strlen(whole.c_str()));
  ASSERT_NE(whole.find("\u20ac"), std::string::npos);
  for (std::size_t size = 1; size <= whole.size() + 2; ++size) {
    std::string room(size + 1, '#');
    EXPECT_EQ(tactus_model_open(path.c_str(), &model, room.data(), size), TACTUS_BAD_FILE);
    EXPECT_EQ(room.back(), '#');
    const std::string found = room.c_str();
    ASSERT_LT(found.size(), size);
    EXPECT_EQ(whole.rfind(found, 0), 0U);
    // Not more is lost than the bytes of one character.
    EXPECT_GE(found.size() + 3, std::min(size, whole.size()));
    EXPECT_TRUE(found.size() == whole.size() || (static_cast<unsigned char>(whole[found.size()]) & 0xC0) != 0x80);
  }
  char untouched = '#';
  tactus_model_open(path.c_str(), &model, &untouched, 0);
  EXPECT_EQ(untouched, '#');
}

struct WrongScene {
  std::vector<size_t> fixed;
  std::vector<double> values;
  std::string sentence;
};

TEST(RuntimeArguments, AWrongSceneSaysWhy) {
  const auto handle = support::handleOf(support::s4Shifted());
  const std::vector<WrongScene> wrong = {
      {{4}, {1}, "fixed input 0: found the index 4, wanted 0 to 3"},
      {{1, 1}, {1, 1}, "fixed input 1: found 'neck_flexion' again, wanted each input once"},
      {{0}, {kNaN}, "fixed input 0: found nan for 'lubrication', wanted a finite number"},
      {{0, 1, 2, 3, 0}, {1, 1, 1, 1, 1}, "fixed: found more fixed inputs than the model has inputs"},
  };
  for (const WrongScene& one : wrong) {
    tactus_scene* scene = nullptr;
    char message[300];
    EXPECT_EQ(tactus_scene_make(handle.get(), one.fixed.data(), one.values.data(), one.fixed.size(), &scene, message,
                                sizeof message),
              TACTUS_BAD_ARGUMENT);
    EXPECT_EQ(message, one.sentence);
    EXPECT_EQ(scene, nullptr);
  }
  tactus_scene* scene = nullptr;
  EXPECT_EQ(tactus_scene_make(handle.get(), nullptr, nullptr, 1, &scene, nullptr, 0), TACTUS_BAD_ARGUMENT);
  const size_t first[] = {0};
  const double high[] = {1.25};
  char message[300];
  ASSERT_EQ(tactus_scene_make(handle.get(), first, high, 1, &scene, message, sizeof message), TACTUS_OK);
  EXPECT_STREQ(message, "'lubrication': found 1.25, taken as 1");
  tactus_scene_free(scene);
}

TEST(RuntimeArguments, ASceneThatCannotBeFeltSaysWhy) {
  auto model = support::s4Shifted();
  const auto handle = support::handleOf(model);
  const size_t fixed[] = {0};
  const double values[] = {1};
  tactus_scene* made = nullptr;
  ASSERT_EQ(tactus_scene_make(handle.get(), fixed, values, 1, &made, nullptr, 0), TACTUS_OK);
  const support::SceneHandle three(made);
  tactus_tube* tube = nullptr;
  char message[300];
  EXPECT_EQ(tactus_tube_make(three.get(), &tube, message, sizeof message), TACTUS_BAD_ARGUMENT);
  EXPECT_STREQ(message,
               "inputs of the scene: found 'neck_flexion', 'depth', 'speed', wanted 'depth' and 'speed' and no other");
  model.inputs[2].unit = "cm";
  const auto centimetres = support::handleOf(model);
  const auto scene = support::ngtSceneHandle(centimetres.get(), 1, 45);
  EXPECT_EQ(tactus_tube_make(scene.get(), &tube, message, sizeof message), TACTUS_BAD_ARGUMENT);
  EXPECT_STREQ(message, "unit of 'depth': found 'cm', wanted mm, which is what the insertion works in");
  EXPECT_EQ(tube, nullptr);
}

TEST(RuntimeArguments, AProgramInC99RunsTheSame) {
  fuzzy::ForceModel model = support::ngtVariables();
  model.inputs.erase(model.inputs.begin(), model.inputs.begin() + 2);
  fuzzy::Expert expert;
  expert.id = "E";
  expert.rules.push_back({{{"speed", "slow"}}, "medium"});
  model.experts.push_back(expert);
  const std::string text = model_io::formatModel(model);
  double force_n = 0;
  double feel_n = 0;
  EXPECT_EQ(runC99Program(text.data(), text.size(), &force_n, &feel_n), 0);
  const double point[] = {100, 50};
  EXPECT_EQ(force_n, tactus_force(support::handleOf(model).get(), point, nullptr));
  EXPECT_GT(feel_n, 0);
}

}  // namespace
}  // namespace tactus
