#include "tests/bench/loaded_source.h"

#include <cstdlib>
#include <dlfcn.h>

#include "core/base/check.h"
#include "core/base/files/file.h"

#include "tests/support/temp_folder.h"

namespace tactus::bench {

std::optional<LoadedSource> loadSource(const exchange::CSource& source, const std::string& compiler) {
  const support::TempFolder folder;
  const auto write = [&](const char* name, const std::string& text) {
    TACTUS_CHECK(base::writeFileAtomically(folder.file(name), text).has_value());
  };
  write("force_model.h", source.header);
  write("force_model.c", source.source);
  const std::string library = folder.file("force_model.so");
  const std::string command = compiler + " -std=c99 -pedantic -Wall -Wextra -Werror -shared -fPIC " +
                              folder.file("force_model.c") + " -o " + library + " -lm";
  if (std::system(command.c_str()) != 0) return std::nullopt;
  void* const loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  TACTUS_CHECK(loaded != nullptr);
  LoadedSource out{};
  out.force = reinterpret_cast<decltype(out.force)>(dlsym(loaded, "force_model"));
  out.batch = reinterpret_cast<decltype(out.batch)>(dlsym(loaded, "force_model_batch"));
  TACTUS_CHECK(out.force != nullptr && out.batch != nullptr);
  return out;
}

}  // namespace tactus::bench
