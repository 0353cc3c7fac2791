#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <optional>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/files/file.h"
#include "core/haptics/hid/hid_pid_device.h"
#include "core/haptics/hid/hidapi_transport.h"

#include "tests/support/temp_folder.h"

namespace tactus::haptics {
namespace {

/// A program that takes the lock of a file and keeps it until it is killed.
class OtherProgram {
 public:
  explicit OtherProgram(const std::string& path) {
    int ready[2] = {};
    EXPECT_EQ(pipe(ready), 0);
    process_ = fork();
    if (process_ == 0) {
      const auto lock = NodeLock::take(path);
      const char held = lock.has_value() ? 1 : 0;
      if (write(ready[1], &held, 1) != 1) _exit(1);
      for (;;) pause();
    }
    char held = 0;
    EXPECT_EQ(read(ready[0], &held, 1), 1);
    EXPECT_EQ(held, 1);
    close(ready[0]);
    close(ready[1]);
  }
  ~OtherProgram() { end(); }
  void end() {
    if (process_ > 0) kill(process_, SIGKILL);
    if (process_ > 0) waitpid(process_, nullptr, 0);
    process_ = 0;
  }
  int process() const { return process_; }

 private:
  pid_t process_ = 0;
};

class NodeLockTest : public testing::Test {
 protected:
  NodeLockTest() : path_(folder_.file("hidraw0")) { std::ofstream(path_) << "a node"; }

  support::TempFolder folder_;
  std::string path_;
};

TEST_F(NodeLockTest, OneProgramHoldsANodeUntilItDies) {
  OtherProgram other(path_);
  const auto refused = NodeLock::take(path_);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().file, path_);
  EXPECT_TRUE(refused.error().found.starts_with("a device in use by ")) << refused.error().message();
  other.end();
  EXPECT_TRUE(NodeLock::take(path_)) << "the system gave it back";
}

TEST_F(NodeLockTest, ItIsHeldForTheLifeOfTheLock) {
  {
    auto lock = NodeLock::take(path_);
    ASSERT_TRUE(lock);
    NodeLock moved = *std::move(lock);
    const auto again = NodeLock::take(path_);
    ASSERT_FALSE(again);
    // A file system without a place in /proc/locks leaves the name out.
    EXPECT_NE(again.error().found.find(holderOf(path_) ? "this program has open already" : "in use by"),
              std::string::npos);
  }
  EXPECT_TRUE(NodeLock::take(path_));
}

TEST_F(NodeLockTest, ANodeThatIsNotThereIsRefused) {
  const auto refused = NodeLock::take(folder_.file("hidraw1"));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message().find("No such file"), std::string::npos);
}

/// The table of the kernel, made up for this file.
TEST_F(NodeLockTest, TheHolderIsFoundInTheTableOfLocks) {
  struct stat node {};
  ASSERT_EQ(stat(path_.c_str(), &node), 0);
  char place[64];
  std::snprintf(place, sizeof place, "%02x:%02x:%llu", major(node.st_dev), minor(node.st_dev),
                static_cast<unsigned long long>(node.st_ino));
  const std::string here(place);
  const std::string locks = folder_.file("locks");
  const auto holder = [&](const std::string& lines) {
    std::ofstream(locks, std::ios::trunc) << lines;
    return holderOf(path_, locks, folder_.file(""));
  };
  EXPECT_FALSE(holder(""));
  EXPECT_FALSE(holder("1: POSIX  ADVISORY  WRITE 77 " + here + " 0 EOF\n")) << "a lock of another kind";
  EXPECT_FALSE(holder("1: FLOCK  ADVISORY  READ 77 " + here + " 0 EOF\n"));
  EXPECT_FALSE(holder("1: FLOCK  ADVISORY  WRITE 77 " + here + "1 0 EOF\n")) << "another file";
  EXPECT_FALSE(holder("1: -> FLOCK  ADVISORY  WRITE 77 " + here + " 0 EOF\n")) << "it waits";
  EXPECT_FALSE(holder("1: FLOCK  ADVISORY  WRITE 0 " + here + " 0 EOF\n")) << "a process that is not seen from here";
  EXPECT_FALSE(holder("1: FLOCK\n\nFLOCK : :\n2: FLOCK ADVISORY WRITE x ::\n"));
  const std::string line =
      "1: FLOCK  ADVISORY  WRITE 78 00:00:1 0 EOF\n2: FLOCK  ADVISORY  WRITE 77 " + here + " 0 EOF\n";
  ASSERT_TRUE(holder(line));
  EXPECT_EQ(holder(line)->text(), "another program (process 77)");
  EXPECT_FALSE(holder(line)->isThisProgram());

  ASSERT_EQ(mkdir(folder_.file("77").c_str(), 0700), 0);
  std::ofstream(folder_.file("77/comm")) << "tactus-workbenc\n";
  EXPECT_EQ(holder(line)->text(), "tactus-workbenc (process 77)");
  std::ofstream(folder_.file("77/cmdline")) << "/opt/tactus/bin/tactus-workbench" << '\0' << "a.tactus" << '\0';
  EXPECT_EQ(holder(line)->text(), "tactus-workbench (process 77)");
  std::ofstream(folder_.file("77/comm"), std::ios::trunc) << "\x1b[31mred\n";
  std::ofstream(folder_.file("77/cmdline"), std::ios::trunc) << "something else";
  EXPECT_EQ(holder(line)->text(), "[31mred (process 77)") << "nothing that moves a terminal";
}

TEST(HidDevices, ADeviceInUseIsListedWithWhoUsesIt) {
  HidDevice device;
  device.kind = HidDeviceKind::kPid;
  noteHolder(device, std::nullopt);
  noteHolder(device, NodeHolder{getpid(), "this"});
  EXPECT_TRUE(device.problem.empty());
  EXPECT_TRUE(device.used_by.empty());
  noteHolder(device, NodeHolder{1, "init"});
  EXPECT_EQ(device.problem, "in use by init (process 1)");
  EXPECT_EQ(device.used_by, "init (process 1)");
  EXPECT_EQ(device.advice, "Close that program, or stop its device there.");
}

}  // namespace
}  // namespace tactus::haptics
