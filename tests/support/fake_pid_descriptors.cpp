#include "tests/support/fake_pid_device.h"
#include "tests/support/hid_descriptor_builder.h"

namespace tactus::support {
namespace {

using Builder = HidDescriptorBuilder;
constexpr int kVar = Builder::kVariable;
constexpr int kArr = Builder::kArray;
constexpr int kPad = Builder::kConstant | Builder::kVariable;
constexpr std::uint32_t kSeconds = 0x1003;
constexpr std::uint32_t kDegrees = 0x14;

enum class Way { kOut, kFeature };

Builder& main(Builder& b, Way way, int flags) { return way == Way::kOut ? b.output(flags) : b.feature(flags); }

Builder& block(Builder& b, Way way, int effects) {
  return main(b.usage(0x22).logical(1, effects).size(8).count(1), way, kVar);
}

Builder& choice(Builder& b, Way way, std::uint32_t collection, std::initializer_list<std::uint32_t> options,
                int first) {
  b.usage(collection).collection().usages(options);
  b.logical(first, first + static_cast<int>(options.size()) - 1).size(8).count(1);
  return main(b, way, kArr).end();
}

void times(Builder& b, std::initializer_list<std::uint32_t> usages) {
  b.logical(0, 32767).physical(0, 32767).unit(kSeconds).exponent(-3).size(16);
  b.usages(usages).count(static_cast<std::uint32_t>(usages.size())).output(kVar);
  b.physical(0, 0).unit(0).exponent(0);
}

constexpr std::initializer_list<std::uint32_t> kElevenTypes = {0x26, 0x27, 0x30, 0x31, 0x32, 0x33,
                                                               0x34, 0x40, 0x41, 0x42, 0x43};

void operation(Builder& b, int id, int effects) {
  b.usage(0x77).collection().id(id);
  block(b, Way::kOut, effects);
  choice(b, Way::kOut, 0x78, {0x79, 0x7A, 0x7B}, 1);
  b.usage(0x7C).logical(0, 255).size(8).count(1).output(kVar).end();
}

void blockFree(Builder& b, int id, int effects) {
  b.usage(0x90).collection().id(id);
  block(b, Way::kOut, effects).end();
}

void gain(Builder& b, int id) {
  b.usage(0x7D).collection().id(id).usage(0x7E);
  b.logical(0, 255).physical(0, 10000).size(8).count(1).output(kVar).physical(0, 0).end();
}

void blockLoad(Builder& b, int id, int effects) {
  b.usage(0x89).collection().id(id);
  block(b, Way::kFeature, effects);
  choice(b, Way::kFeature, 0x8B, {0x8C, 0x8D, 0x8E}, 1);
  b.usage(0xAC).logical(0, 65535).size(16).count(1).feature(kVar).end();
}

void pool(Builder& b, int id) {
  b.usage(0x7F).collection().id(id);
  b.usage(0x80).logical(0, 65535).size(16).count(1).feature(kVar);
  b.usage(0x83).logical(0, 255).size(8).count(1).feature(kVar);
  b.usages({0xA9, 0xAA}).logical(0, 1).size(1).count(2).feature(kVar).size(6).count(1).feature(kPad).end();
}

/// A report with a Magnitude that is not that of a constant force.
void periodic(Builder& b, int id, int effects) {
  b.usage(0x6E).collection().id(id);
  block(b, Way::kOut, effects);
  b.usage(0x70).logical(0, 32767).size(16).count(1).output(kVar);
  b.usage(0x6F).logical(-32767, 32767).output(kVar);
  b.usage(0x71).logical(0, 35999).output(kVar);
  b.usage(0x72).logical(0, 0x7FFFFFFF).size(32).output(kVar).end();
}

void axisBits(Builder& b, bool two) {
  b.usage(0x55).collection().page(0x01).usage(0x30);
  if (two) b.usage(0x31);
  b.logical(0, 1).size(1).count(two ? 2 : 1).output(kVar).end().page(0x0F);
  b.usage(0x56).count(1).output(kVar).size(two ? 5 : 6).output(kPad);
}

std::vector<std::uint8_t> board() {
  constexpr int kEffects = 40;
  Builder b;
  b.page(0x01).usage(0x04).application().id(1);
  b.page(0x09).usageRange(1, 64).logical(0, 1).size(1).count(64).input(kVar);
  b.page(0x01).usages({0x30, 0x31, 0x32, 0x33, 0x34, 0x35, 0x37, 0x36});
  b.logical(-32767, 32767).size(16).count(8).input(kVar);

  b.page(0x0F).usage(0x92).collection().id(2).usages({0x9F, 0xA0, 0xA4, 0xA6, 0x94});
  b.logical(0, 1).size(1).count(5).input(kVar).size(3).count(1).input(kPad).end();

  b.usage(0x21).collection().id(1);
  block(b, Way::kOut, kEffects);
  choice(b, Way::kOut, 0x25, kElevenTypes, 1);
  times(b, {0x50, 0x54, 0x51, 0xA7});
  b.usage(0x52).logical(0, 255).physical(0, 10000).size(8).count(1).output(kVar).physical(0, 0);
  b.usage(0x53).logical(1, 8).output(kVar);
  axisBits(b, true);
  b.usage(0x57).collection().page(0x0A).usages({1, 2}).logical(0, 36000).physical(0, 36000).unit(kDegrees);
  b.exponent(-2).size(16).count(2).output(kVar).unit(0).exponent(0).physical(0, 0).end().page(0x0F);
  b.usage(0x58).collection().page(0x0A).usages({1, 2}).logical(0, 32765).size(16).count(2).output(kVar).end();
  b.page(0x0F).end();

  periodic(b, 4, kEffects);
  b.usage(0x73).collection().id(5);
  block(b, Way::kOut, kEffects);
  b.usage(0x70).logical(-32767, 32767).size(16).count(1).output(kVar).end();
  operation(b, 0x0A, kEffects);
  blockFree(b, 0x0B, kEffects);
  b.usage(0x96).collection().id(0x0C).usages({0x97, 0x98, 0x99, 0x9A, 0x9B, 0x9C});
  b.logical(0, 1).size(1).count(6).output(kVar).size(2).count(1).output(kPad).end();
  gain(b, 0x0D);

  b.usage(0xAB).collection().id(0x11);
  choice(b, Way::kFeature, 0x25, kElevenTypes, 1);
  b.page(0x01).usage(0x3B).logical(0, 511).size(10).count(1).feature(kVar).size(6).feature(kPad).page(0x0F).end();
  blockLoad(b, 0x12, kEffects);
  pool(b, 0x13);
  return b.end().take();
}

std::vector<std::uint8_t> sketch() {
  constexpr int kEffects = 14;
  static constexpr std::initializer_list<std::uint32_t> kTypes = {0x26, 0x27, 0x30, 0x31, 0x32, 0x33,
                                                                  0x34, 0x40, 0x41, 0x42, 0x43, 0x28};
  Builder b;
  b.page(0x01).usage(0x04).application().id(3);
  b.page(0x09).usageRange(1, 8).logical(0, 1).size(1).count(8).input(kVar);
  // Two reports' worth of globals kept aside, as a generated descriptor would.
  b.page(0x01).push().usage(0x01).collection().usages({0x30, 0x31});
  b.logical(-32767, 32767).size(16).count(2).input(kVar).end().pop();

  b.page(0x0F).usage(0x92).collection().id(2).usages({0x9F, 0xA0, 0xA4, 0xA5, 0xA6});
  b.logical(0, 1).size(1).count(5).input(kVar).size(3).count(1).input(kPad);
  b.usage(0x94).logical(0, 1).size(1).input(kVar).usage(0x22).logical(1, kEffects).size(7).input(kVar).end();

  b.usage(0x21).collection().id(1);
  block(b, Way::kOut, kEffects);
  choice(b, Way::kOut, 0x25, kTypes, 1);
  times(b, {0x50, 0x54, 0x51});
  b.usage(0x52).logical(0, 255).size(8).count(1).output(kVar);
  b.usage(0x53).logical(1, 8).output(kVar);
  axisBits(b, true);
  b.usage(0x57).collection().page(0x0A).usages({1, 2}).logical(0, 255).physical(0, 360).unit(kDegrees);
  b.size(8).count(2).output(kVar).unit(0).physical(0, 0).end().page(0x0F);
  b.usage(0x58).collection().page(0x0A).usages({1, 2}).logical(0, 32765).size(16).count(2).output(kVar).end();
  b.page(0x0F).end();

  periodic(b, 4, kEffects);
  b.usage(0x73).collection().id(5);
  block(b, Way::kOut, kEffects);
  b.usage(0x70).logical(-10000, 10000).size(16).count(1).output(kVar).end();
  operation(b, 10, kEffects);
  blockFree(b, 11, kEffects);
  b.usage(0x95).collection().id(12).usages({0x97, 0x98, 0x99, 0x9A, 0x9B, 0x9C});
  b.logical(1, 6).size(8).count(1).output(kArr).end();
  gain(b, 13);

  b.usage(0xAB).collection().id(5);
  choice(b, Way::kFeature, 0x25, kTypes, 1);
  b.page(0x01).usage(0x3B).logical(0, 511).size(10).count(1).feature(kVar).size(6).feature(kPad).page(0x0F).end();
  blockLoad(b, 6, kEffects);
  pool(b, 7);
  return b.end().take();
}

std::vector<std::uint8_t> wheel() {
  constexpr int kEffects = 16;
  static constexpr std::initializer_list<std::uint32_t> kTypes = {0x40, 0x41, 0x26, 0x31};
  Builder b;
  b.page(0x01).usage(0x05).application().id(0x44);
  b.longUsage(0x01, 0x30).logical(0, 65535).size(16).count(1).input(kVar);
  b.page(0x09).usageRange(1, 12).logical(0, 1).size(1).count(12).input(kVar).size(4).count(1).input(kPad);

  // 4-byte usages carry the page; the page in force is still that of the buttons.
  b.longUsage(0x0F, 0x21).collection().id(0x41).page(0x0F);
  block(b, Way::kOut, kEffects);
  choice(b, Way::kOut, 0x25, kTypes, 1);
  times(b, {0x50});
  b.usage(0x52).logical(0, 10000).size(16).count(1).output(kVar);
  b.usage(0x53).logical(0, 255).size(8).output(kVar);
  axisBits(b, false);
  b.usage(0x57).collection().page(0x0A).usage(1).logical(0, 35999).physical(0, 35999).unit(kDegrees).exponent(-2);
  b.size(16).count(1).output(kVar).unit(0).exponent(0).physical(0, 0).end().page(0x0F).end();

  b.usage(0x73).collection().id(0x45);
  block(b, Way::kOut, kEffects);
  b.usage(0x70).logical(0, 10000).size(16).count(1).output(kVar).end();
  operation(b, 0x4A, kEffects);
  blockFree(b, 0x4B, kEffects);
  // The lowest value should be 1; firmwares with 0 exist and still mean 1 by the first usage. Disable comes first.
  b.usage(0x96).collection().id(0x4C).usages({0x98, 0x97, 0x99, 0x9A});
  b.logical(0, 4).size(8).count(1).output(kArr).end();
  gain(b, 0x4D);

  b.usage(0xAB).collection().id(0x51);
  choice(b, Way::kFeature, 0x25, kTypes, 1).end();
  blockLoad(b, 0x52, kEffects);
  return b.end().take();
}

}  // namespace

const char* name(PidModel model) {
  constexpr std::array kNames = {"board", "sketch", "wheel"};
  return kNames[static_cast<std::size_t>(model)];
}

std::vector<std::uint8_t> reportDescriptor(PidModel model) {
  if (model == PidModel::kBoard) return board();
  return model == PidModel::kSketch ? sketch() : wheel();
}

}  // namespace tactus::support
