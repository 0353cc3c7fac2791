// Where there is no memory, each call says so, makes nothing and leaks nothing.
#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>
#include <string>
#include <vector>

#include "core/fuzzy/compiled_model.h"

#include "tests/core/runtime/runtime_models.h"

namespace {

// The allocations that are still granted; below 0: all.
std::atomic<long> granted{-1};
std::atomic<long> live{0};

void* allocate(std::size_t size) {
  if (granted >= 0 && granted-- <= 0) {
    granted = 0;
    return nullptr;
  }
  void* const memory = std::malloc(size);
  if (memory != nullptr) ++live;
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  void* const memory = allocate(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void operator delete(void* memory) noexcept {
  if (memory != nullptr) --live;
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { operator delete(memory); }

namespace tactus {
namespace {

/// Runs `make` with more and more memory until it is enough; returns how often it was not.
template <typename Handle, typename Make>
long refusals(Make&& make) {
  long refused = 0;
  for (long grant = 0;; ++grant) {
    Handle* handle = nullptr;
    char message[200];
    const long before = live;
    granted = grant;
    const tactus_status status = make(&handle, message, sizeof message);
    granted = -1;
    if (status == TACTUS_OK) {
      support::FreeHandle()(handle);
      EXPECT_EQ(live, before);
      return refused;
    }
    EXPECT_EQ(status, TACTUS_NO_MEMORY);
    EXPECT_EQ(handle, nullptr);
    EXPECT_STREQ(message, "there is not enough memory");
    EXPECT_EQ(live, before) << "after " << grant << " allocations";
    if (status != TACTUS_NO_MEMORY || testing::Test::HasFailure()) return -1;
    ++refused;
  }
}

TEST(RuntimeNoMemory, EachCallSaysSo) {
  // Few rules, because the model is read once for each of its allocations.
  auto small = support::s4Shifted();
  small.experts[0].rules.resize(4);
  const std::vector<double> point = {1, 45, 30, 30};
  const auto compiled = fuzzy::compile(small);
  ASSERT_TRUE(compiled);
  const auto force = compiled->evaluate(point);
  small.checks.push_back({point, force.force_n, force.fired});
  const std::string text = model_io::formatModel(small);
  EXPECT_GT(refusals<tactus_model>([&](tactus_model** model, char* message, size_t size) {
              return tactus_model_read(text.data(), text.size(), model, message, size);
            }),
            50);
  const auto handle = support::handleOf(small);
  const size_t fixed[] = {0, 1};
  const double values[] = {1, 45};
  EXPECT_GT(refusals<tactus_scene>([&](tactus_scene** scene, char* message, size_t size) {
              return tactus_scene_make(handle.get(), fixed, values, 2, scene, message, size);
            }),
            3);
  const auto scene = support::ngtSceneHandle(handle.get(), 1, 45);
  EXPECT_EQ(refusals<tactus_tube>([&](tactus_tube** tube, char* message, size_t size) {
              return tactus_tube_make(scene.get(), tube, message, size);
            }),
            1);
}

}  // namespace
}  // namespace tactus
