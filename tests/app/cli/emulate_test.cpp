// `tactus emulate` as a process, met by `tactus devices`.
#include <array>
#include <cstdio>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/temp_folder.h"

namespace tactus::cli {
namespace {

using Json = nlohmann::json;

/// What `sh` says of `script`; $tactus in it is the program, $dir a folder.
std::string said(const std::string& script, const support::TempFolder& folder) {
  const std::string shell = "tactus=" TACTUS_PROGRAM "; dir=" + folder.file("") +
                            "; export TACTUS_LIBHD=/nowhere TACTUS_CALIBRATIONS=$dir/c.json; { " + script + "; } 2>&1";
  FILE* const pipe = ::popen(shell.c_str(), "r");
  std::string text;
  std::array<char, 4096> part{};
  for (std::size_t got = 0; (got = std::fread(part.data(), 1, part.size(), pipe)) > 0;) text.append(part.data(), got);
  ::pclose(pipe);
  return text;
}

/// Starts the double with `options`, waits until it listens, and sets the port.
std::string begun(const std::string& options) {
  return "$tactus emulate haply --port 0 " + options +
         " > $dir/said & pid=$!; until grep -q listening $dir/said || ! kill -0 $pid; do sleep 0.02; done; "
         "export TACTUS_HAPLY_PORT=$(sed -n 's/.*\"port\":\\([0-9]*\\).*/\\1/p' $dir/said); ";
}

const std::string kEnd = "; kill -TERM $pid; wait $pid; echo status $?";

TEST(Emulate, TheDoubleIsListedAndSaysInTheEndWhatWasCommanded) {
  const support::TempFolder folder;
  const std::string list = said(begun("--devices 2 --trace $dir/trace.csv") + "$tactus devices --json" + kEnd, folder);
  const Json devices = Json::parse(list.substr(0, list.rfind("status"))).at("devices");
  ASSERT_GE(devices.size(), 3u) << list;
  EXPECT_EQ(devices[0].at("id"), "simulated-haply:SIM-1");
  EXPECT_EQ(devices[0].at("simulated"), true);
  EXPECT_EQ(devices[0].at("backend"), "haply");
  EXPECT_GT(devices[0].at("round_trip_ms").get<double>(), 0);
  EXPECT_GT(devices[0].at("largest_stiffness_n_mm").get<double>(), 0);
  EXPECT_EQ(devices.back().at("round_trip_ms"), nullptr);
  EXPECT_TRUE(list.ends_with("status 0\n")) << list;

  const std::string lines = said("cat $dir/said", folder);
  const auto end = lines.find('\n');
  EXPECT_EQ(Json::parse(lines.substr(0, end)).at("simulated"), true);
  const Json summary = Json::parse(lines.substr(end)).at("summary");
  EXPECT_EQ(summary.at("simulated"), true);
  EXPECT_EQ(summary.at("clients"), 1);
  EXPECT_EQ(summary.at("devices").at(1).at("device_id"), "SIM-2");
  EXPECT_EQ(summary.at("devices").at(0).at("forces"), 0) << "looking asks for none";
  EXPECT_EQ(said("cat $dir/trace.csv", folder),
            "time_s,device,position_mm,speed_mm_s,force_x_n,force_y_n,force_z_n,simulated\n");
}

TEST(Emulate, TheListSaysWhatTheLatencyCosts) {
  const support::TempFolder folder;
  const std::string text = said(begun("--no-grip") + "$tactus devices" + kEnd, folder);
  EXPECT_NE(text.find("simulated-haply:SIM-1: Haply Inverse3 (simulated), serial number SIM-1, ready (simulated)\n"
                      "  measured: it replies within "),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("so a tube is rendered with at most "), std::string::npos) << text;
  EXPECT_NE(text.find("  do: switch its grip on, or hold the tube with a key or a pedal\n"), std::string::npos) << text;
}

TEST(Emulate, ItsAxisCanBeSetAndItsServiceCalibratesIt) {
  const support::TempFolder folder;
  const std::string text = said(begun("") +
                                    "$tactus devices calibrate simulated-haply:SIM-1 < /dev/null; "
                                    "$tactus devices calibrate haply --inwards=0,-1,0" +
                                    kEnd,
                                folder);
  EXPECT_NE(text.find("simulated-haply:SIM-1: calibrated by its driver\n"), std::string::npos) << text;
  EXPECT_NE(text.find("the tube goes along 0,-1,0"), std::string::npos) << text;
}

TEST(Emulate, ItDiesWhenItIsAskedTo) {
  const support::TempFolder folder;
  const std::string text = said(begun("--dead-after 0") + "$tactus devices; wait $pid; echo status $?", folder);
  EXPECT_NE(text.find("note: Haply is not in use: localhost:"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("status 0\n")) << text;
}

TEST(Emulate, WrongOptionsAndAPortInUseAreRefused) {
  const support::TempFolder folder;
  EXPECT_NE(said("$tactus emulate haply --devices 0", folder).find("wanted a whole number from 1 to 8"),
            std::string::npos);
  EXPECT_NE(said("$tactus emulate", folder).find("subcommand"), std::string::npos);
  const std::string text =
      said(begun("") + "$tactus emulate haply --port $TACTUS_HAPLY_PORT; echo second $?" + kEnd, folder);
  EXPECT_NE(text.find("wanted a free port: --port 0 finds one"), std::string::npos) << text;
  EXPECT_NE(text.find("second 1\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace tactus::cli
