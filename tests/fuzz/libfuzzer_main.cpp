// The entry of libFuzzer for one target, which CMake names.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include TACTUS_FUZZ_HEADER

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tactus::fuzz::TACTUS_FUZZ_FUNCTION(std::string_view(reinterpret_cast<const char*>(data), size));
  return 0;
}
