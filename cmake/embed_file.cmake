# Run by tactus_embed: writes a C++ source that holds the bytes of IN.
file(READ "${IN}" hex HEX)
# One string: an array of numbers takes the compiler many times as long.
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${hex}")
file(WRITE "${OUT}" "#include <string_view>

namespace ${NAMESPACE} {
std::string_view ${FUNCTION}();
std::string_view ${FUNCTION}() {
  static constexpr char kBytes[] = \"${bytes}\";
  return {kBytes, sizeof(kBytes) - 1};
}
}
")
