// Every dialog that asks for a file is one of app/workbench/base/file_dialog.h.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

namespace tactus {
namespace {

namespace fs = std::filesystem;

TEST(FileDialogs, AreOfOneKind) {
  int looked_at = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TACTUS_SOURCE_DIR) / "app")) {
    const std::string path = entry.path().generic_string();
    if (!path.ends_with(".cpp") || path.ends_with("base/file_dialog.cpp")) continue;
    ++looked_at;
    std::ifstream in(path);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    for (const char* own : {"QFileDialog::get", "QFileDialog dialog", "new QFileDialog", "QFileIconProvider"})
      EXPECT_EQ(text.find(own), std::string::npos) << path << ": " << own;
  }
  EXPECT_GT(looked_at, 100);
}

}  // namespace
}  // namespace tactus
