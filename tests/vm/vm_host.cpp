// vm_host DEVICE_PROGRAM: the project's HID back end against this kernel and each of the virtual devices. README.md
#include "tests/vm/visit.h"

namespace tactus::vm {
namespace {

// Made up, and different in everything.
constexpr TrueHandle kHandles[] = {
    {"board", 2, true, 6.0, 0.010, 0.010, {0, 3000}, {0, -3000}},
    {"sketch", 2, true, 2.5, 0.020, 0.015, {-2000, 1000}, {1000, -3000}},
    {"wheel", 1, false, 9.0, 0.005, 0.008, {-4000, 0}, {4000, 0}},
};

}  // namespace
}  // namespace tactus::vm

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  for (const auto& handle : tactus::vm::kHandles) {
    tactus::vm::Checks checks(handle.model);
    tactus::vm::Visit(checks, argv[1], handle).everything();
    checks.finish();
  }
  return 0;
}
