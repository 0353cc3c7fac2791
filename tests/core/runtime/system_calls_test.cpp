// After a model is loaded, no call of a servo loop enters the kernel: a process in which every system call but the last
// one is deadly gives forces, batches and the steps of a tube, from their first call on.
#include <csignal>
#include <cstddef>
#include <gtest/gtest.h>
#include <iostream>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "core/base/random.h"

#include "tests/core/runtime/runtime_models.h"
#include "tests/support/random_model.h"

namespace tactus {
namespace {

constexpr int kNoFilter = 3;  // exit status of a child whose kernel takes no filter

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;  // the sanitizers' own run-time libraries call the system
#else
constexpr bool kSanitized = false;
#endif

/// From here on this process may only end.
bool forbidSystemCalls() {
  const sock_filter rules[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_exit_group, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
  };
  sock_fprog program = {};
  program.len = sizeof rules / sizeof rules[0];
  program.filter = const_cast<sock_filter*>(rules);
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0U, &program) == 0;
}

/// How a child process ended in which `work` ran without system calls.
template <typename Work>
int statusWithoutSystemCalls(Work&& work) {
  const pid_t child = fork();
  if (child == 0) {
    if (!forbidSystemCalls()) _exit(kNoFilter);
    work();
    _exit(0);
  }
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return status;
}

class RuntimeSystemCalls : public testing::Test {
 protected:
  void SetUp() override {
    if (kSanitized) {
      std::cout << "SKIPPED: sanitizers call the system themselves\n";
      GTEST_SKIP();
    }
    const int status = statusWithoutSystemCalls([] {});
    if (WIFEXITED(status) && WEXITSTATUS(status) == kNoFilter) {
      std::cout << "SKIPPED: this kernel takes no filter of system calls\n";
      GTEST_SKIP();
    }
    ASSERT_EQ(status, 0);
    // The filter works: any other call is the end.
    const int caught = statusWithoutSystemCalls([] { syscall(SYS_getppid); });
    ASSERT_TRUE(WIFSIGNALED(caught) && WTERMSIG(caught) == SIGSYS);
  }
};

TEST_F(RuntimeSystemCalls, ForcesBatchesAndScenesMakeNone) {
  base::Random random(8);
  for (int m = 0; m < 20; ++m) {
    const auto model = support::randomModel(random, {.gaussians = m % 2 == 0});
    const auto handle = support::handleOf(model);
    const size_t fixed[] = {0};
    const double value[] = {model.inputs[0].min};
    tactus_scene* made = nullptr;
    ASSERT_EQ(tactus_scene_make(handle.get(), fixed, value, 1, &made, nullptr, 0), TACTUS_OK);
    const support::SceneHandle scene(made);
    constexpr std::size_t kPoints = 1100;
    std::vector<double> points;
    for (std::size_t p = 0; p < kPoints; ++p) {
      const auto point = support::randomPoint(random, model);
      points.insert(points.end(), point.begin(), point.end());
    }
    std::vector<double> forces(kPoints);
    std::vector<unsigned char> told(kPoints);
    const int status = statusWithoutSystemCalls([&] {
      int fired = 0;
      for (std::size_t p = 0; p < kPoints; ++p) {
        const double* const point = points.data() + p * model.inputs.size();
        forces[p] = tactus_force(handle.get(), point, &fired) + tactus_expert_force(handle.get(), 0, point, &fired) +
                    tactus_scene_force(made, point, &fired) + tactus_clamped(handle.get(), point);
      }
      tactus_force_batch(handle.get(), points.data(), kPoints, forces.data(), told.data());
      tactus_scene_force_batch(made, points.data(), kPoints, forces.data(), told.data());
    });
    ASSERT_EQ(status, 0) << "model " << m;
  }
}

TEST_F(RuntimeSystemCalls, TheTubeMakesNone) {
  const auto handle = support::handleOf(support::s4Shifted());
  const auto first = support::ngtSceneHandle(handle.get(), 1, 10);
  const auto second = support::ngtSceneHandle(handle.get(), 0.2, 80);
  const auto tube = support::tubeOf(first.get());
  std::vector<unsigned char> state(tactus_tube_save(tube.get(), nullptr, 0));
  const int status = statusWithoutSystemCalls([&] {
    tactus_feel feel = {};
    feel.size = sizeof feel;
    for (int i = 0; i < 5000; ++i) {
      if (i % 500 == 0) tactus_tube_scene(tube.get(), i % 1000 == 0 ? second.get() : first.get(), 0.05);
      if (i == 3000) tactus_tube_place(tube.get(), 100);
      if (i % 250 == 100) tactus_tube_save(tube.get(), state.data(), state.size());
      if (i % 250 == 101) tactus_tube_load(tube.get(), state.data(), state.size());
      tactus_tube_step(tube.get(), 0.05 * i, i % 1500 > 20 ? 1 : 0, 0.001, &feel);
    }
    if (!(feel.depth_mm > 100)) _exit(1);
  });
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace tactus
