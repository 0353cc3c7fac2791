#include <cstdlib>
#include <gtest/gtest.h>

#include "core/haptics/openhaptics/openhaptics_device.h"

#include "tests/core/haptics/openhaptics/loaded_stand_in.h"

namespace tactus::haptics {
namespace {

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(HdLibrary, AnAbsentLibrarySaysWhatWasTriedAndWhatToInstall) {
  unsetenv("GTDD_HOME");
  const auto loaded = HdLibrary::load("/nowhere/libHD.so");
  ASSERT_FALSE(loaded);
  const std::string message = loaded.error().message();
  EXPECT_TRUE(message.starts_with("OpenHaptics library: found none that loads, tried /nowhere/libHD.so (")) << message;
  for (const char* part : {"cannot open shared object file", "OpenHaptics 3.4 runtime", "Touch driver",
                           "GTDD_HOME set to the folder", "/usr/share/3DSystems"})
    EXPECT_TRUE(says(message, part)) << part << ": " << message;
  EXPECT_FALSE(says(message, "\n"));
}

TEST(HdLibrary, AMissingLibraryOfTheDriverIsNamed) {
  const auto loaded = HdLibrary::load(TACTUS_STAND_IN_WITHOUT_DRIVER);
  ASSERT_FALSE(loaded);
  const std::string message = loaded.error().message();
  EXPECT_TRUE(says(message, "libPhantomIOLib42.so: cannot open shared object file")) << message;
}

TEST(HdLibrary, MissingFunctionsAreNamed) {
  const auto loaded = HdLibrary::load(TACTUS_STAND_IN_INCOMPLETE);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().message(), "OpenHaptics library: found " + std::string(TACTUS_STAND_IN_INCOMPLETE) +
                                          " without hdUpdateCalibration, hdUnschedule, wanted the HD library of "
                                          "OpenHaptics 3.4");
}

TEST(HdLibrary, TheFolderOfTheConfigurationIsAskedForOnlyWhereItIsNotThere) {
  setenv("GTDD_HOME", "/tmp", 1);
  EXPECT_EQ(hdEnvironmentAdvice(), "");
  setenv("GTDD_HOME", "/nowhere/at all", 1);
  EXPECT_TRUE(says(hdEnvironmentAdvice(), "/nowhere/at all")) << hdEnvironmentAdvice();
  EXPECT_TRUE(says(HdLibrary::load("/nowhere/libHD.so").error().message(), "/nowhere/at all"));
  unsetenv("GTDD_HOME");
  EXPECT_TRUE(says(hdEnvironmentAdvice(), "GTDD_HOME"));
}

TEST(HdLibrary, LoadingAgainGivesTheSameLibrary) {
  const auto first = HdLibrary::load(TACTUS_STAND_IN);
  const auto second = HdLibrary::load(TACTUS_STAND_IN);
  ASSERT_TRUE(first && second);
  EXPECT_EQ((*first)->api().init_device, (*second)->api().init_device);
  EXPECT_EQ((*first)->path(), TACTUS_STAND_IN);
}

/// The record comes back by value from code that was compiled with its own declaration of it.
TEST_F(WithStandIn, AnErrorRecordArrivesWhole) {
  const HdApi& api = library_->api();
  EXPECT_EQ(api.get_error().code, 0u);
  api.disable_device(99);
  HdErrorRecord record = api.get_error();
  EXPECT_EQ(record.code, 0x0104u);
  EXPECT_EQ(record.internal_code, 0);
  EXPECT_EQ(record.device, 7u);
  standIn().taken_elsewhere = true;
  EXPECT_EQ(api.init_device(nullptr), hd::kInvalidHandle);
  record = api.get_error();
  EXPECT_EQ(record.code, 0x0301u);
  EXPECT_EQ(record.internal_code, 3);
  EXPECT_EQ(record.device, 7u);
}

}  // namespace
}  // namespace tactus::haptics
