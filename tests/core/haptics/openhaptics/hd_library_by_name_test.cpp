// This program's run path holds the stand-in, as the system's loader path holds the real library.
#include <gtest/gtest.h>

#include "core/haptics/openhaptics/openhaptics_device.h"

namespace tactus::haptics {
namespace {

TEST(HdLibraryByName, IsFoundWhereTheLoaderLooks) {
  const auto loaded = HdLibrary::load();
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_EQ((*loaded)->path(), "libHD.so");
  EXPECT_EQ((*loaded)->api().get_error().code, 0u);
}

}  // namespace
}  // namespace tactus::haptics
