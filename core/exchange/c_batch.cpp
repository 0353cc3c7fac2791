// A batch of points in C: blocks of points side by side without a branch, so that compilers compute several at once.
// The block is compiled for several processors, and the program takes the best one that it runs on.
#include <algorithm>

#include "core/exchange/c_writer.h"

namespace tactus::exchange {
namespace {

/// `lines` moved to the right by `by` spaces.
std::string indented(const std::string& lines, std::size_t by) {
  std::string out;
  for (std::size_t from = 0; from < lines.size();) {
    const std::size_t end = lines.find('\n', from) + 1;
    out += std::string(by, ' ') + lines.substr(from, end - from);
    from = end;
  }
  return out;
}

constexpr const char* kOneByOne =
    "static void one_by_one(const double *inputs, size_t points, double *force, unsigned char *fired) {\n"
    "  size_t p;\n"
    "  for (p = 0; p < points; ++p) {\n"
    "    int one;\n"
    "    force[p] = force_model(inputs + p * FORCE_MODEL_INPUTS, &one);\n"
    "    if (fired != NULL) fired[p] = (unsigned char)one;\n"
    "  }\n}\n\n";

// GCC chooses by minima and maxima only where it may leave NaN and the sign of 0 aside. In a block both are harmless.
constexpr const char* kBegin =
    "/* Where the compiler and the system know how, the block is compiled for several processors. */\n"
    "#if defined(__linux__) && defined(__x86_64__) && !defined(__AVX512F__) && \\\n"
    "    (defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 8))\n"
    "#define SEVERAL_PROCESSORS\n"
    "#endif\n\n"
    "enum { kBlock = 32 };\n\n"
    "#if defined(__GNUC__) && !defined(__clang__)\n"
    "#pragma GCC push_options\n"
    "#pragma GCC optimize(\"finite-math-only\", \"no-signed-zeros\")\n"
    "#endif\n";

constexpr const char* kEnd =
    "static int block_plain(const double *inputs, double *force, unsigned char *fired) {\n"
    "  return block(inputs, force, fired);\n}\n"
    "#ifdef SEVERAL_PROCESSORS\n"
    "__attribute__((target(\"avx2,fma\"))) static int block_avx2(const double *inputs, double *force, unsigned char "
    "*fired) {\n"
    "  return block(inputs, force, fired);\n}\n"
    "__attribute__((target(\"avx512f,avx512dq,avx512vl,fma\"))) static int block_avx512(const double *inputs, double "
    "*force,\n"
    "                                                                                 unsigned char *fired) {\n"
    "  return block(inputs, force, fired);\n}\n"
    "#endif\n"
    "#if defined(__GNUC__) && !defined(__clang__)\n"
    "#pragma GCC pop_options\n"
    "#endif\n\n"
    "void force_model_batch(const double *inputs, size_t points, double *force, unsigned char *fired) {\n"
    "  int (*block_here)(const double *, double *, unsigned char *) = block_plain;\n"
    "  size_t p = 0;\n"
    "#ifdef SEVERAL_PROCESSORS\n"
    "  if (__builtin_cpu_supports(\"avx512f\") && __builtin_cpu_supports(\"avx512dq\") && "
    "__builtin_cpu_supports(\"avx512vl\"))\n"
    "    block_here = block_avx512;\n"
    "  else if (__builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\"))\n"
    "    block_here = block_avx2;\n"
    "#endif\n"
    "  for (; p + kBlock <= points; p += kBlock) {\n"
    "    const double *const x = inputs + p * FORCE_MODEL_INPUTS;\n"
    "    unsigned char *const told = fired != NULL ? fired + p : NULL;\n"
    "    if (block_here(x, force + p, told)) one_by_one(x, kBlock, force + p, told);\n"
    "  }\n"
    "  one_by_one(inputs + p * FORCE_MODEL_INPUTS, points - p, force + p, fired != NULL ? fired + p : NULL);\n"
    "}\n\n";

}  // namespace

/// The strengths of all experts, each part that some of them share computed once: those of expert after expert, in the
/// order of the live terms of its group.
std::string SourceWriter::strengthsTogether(const std::vector<std::size_t>& experts) const {
  std::vector<TermRules> rules;
  for (const std::size_t e : experts) {
    auto next = ordered_[e]->strengths.begin();
    for (const std::size_t term : groups_[ordered_[e]->group].live) {
      const bool own = next != ordered_[e]->strengths.end() && next->term == term;
      rules.push_back(own ? next->rules : TermRules());
      if (own) ++next;
    }
  }
  const SharedStrengths shared = sharedStrengths(rules, membershipsOf(inputOfMostMemberships()));
  std::string out = "/* Of all experts. */\nPART void strengths_together(const double *m, double *s) {\n" +
                    indented(shared.statements, 2);
  for (std::size_t k = 0; k < shared.values.size(); ++k)
    out += "  s[" + std::to_string(k) + "] = " + shared.values[k] + ";\n";
  return out + "  (void)m;\n}\n\n";
}

/// A loop that puts the free inputs of a block into columns and finds what is not finite. `point`: receives the lines
/// that take one point out of them.
std::string SourceWriter::columnsText(std::string& point) const {
  std::string arrays;
  std::string copies;
  std::string odd;
  const auto free = static_cast<std::size_t>(std::count(fixed_.begin(), fixed_.end(), std::nullopt));
  for (std::size_t i = 0; i < free; ++i) {
    const std::string index = std::to_string(i);
    arrays += ", x" + index + "[kBlock]";
    copies += "    x" + index + "[j] = inputs[j * FORCE_MODEL_INPUTS + " + index + "];\n";
    odd += "    odd |= is_not_finite(x" + index + "[j]);\n";
    point += "    at[" + index + "] = x" + index + "[j];\n";
  }
  return "  double weights_of[kBlock]" + arrays +
         ";\n  unsigned long long odd = 0;\n  int j;\n  for (j = 0; j < kBlock; ++j) {\n" + copies + odd + "  }\n";
}

/// The function `block`: forces of a block, and whether one of its points is to be computed in another way.
std::string SourceWriter::blockText(const std::vector<std::size_t>& experts) const {
  std::string point;
  std::string out =
      "/* Other than 0 where a point is not finite, or its strengths are so small that their squares vanish. */\n"
      "PART int block(const double *inputs, double *force, unsigned char *fired) {\n";
  const bool can_be_tiny = memberships_.canBeTiny();
  if (can_be_tiny) out += "  double tiny_of[kBlock], any_tiny = 0.0;\n";
  out += columnsText(point);

  std::size_t count = 0;
  std::string forces;
  for (const std::size_t e : experts) {
    const std::size_t g = ordered_[e]->group;
    const std::size_t terms = groups_[g].live.size();
    if (can_be_tiny) {
      std::vector<std::string> all;
      for (std::size_t k = 0; k < terms; ++k) all.push_back("s[" + std::to_string(count + k) + "]");
      forces += "    largest = " + tree(all, "larger") + ";\n    tiny += largest < 1e-90 ? largest : 0.0;\n";
    }
    // Where no rule fires, area and moment are 0.
    forces += "    centroid_" + std::to_string(g) + "(s + " + std::to_string(count) + ", 1, &area, &moment);\n";
    forces += experts.size() == 1
                  ? "    sum = moment / larger(area, 1e-300);\n    weights = area > 0.0 ? 1.0 : 0.0;\n"
                  : "    sum += " + share(e) + " * (moment / larger(area, 1e-300));\n    weights += area > 0.0 ? " +
                        share(e) + " : 0.0;\n";
    count += terms;
  }
  const std::string quotient = experts.size() == 1 ? "sum" : "sum / (weights > 0.0 ? weights : 1.0)";
  out += "  for (j = 0; j < kBlock; ++j) {\n    double m[kMemberships], s[" + std::to_string(count) + "], at[" +
         std::to_string(std::count(fixed_.begin(), fixed_.end(), std::nullopt)) +
         "], area, moment, sum = 0.0, weights = 0.0" + (can_be_tiny ? ", largest, tiny = 0.0" : "") + ";\n" + point +
         "    (void)memberships(at, m);\n    strengths_together(m, s);\n" + forces +
         "    sum = " + number(model_.output.min) + " + " + quotient +
         ";\n    force[j] = weights > 0.0 ? sum : " + number(model_.default_force_n) +
         ";\n    weights_of[j] = weights;\n";
  if (can_be_tiny) out += "    tiny_of[j] = tiny;\n";
  out += "  }\n";
  if (can_be_tiny) out += "  for (j = 0; j < kBlock; ++j) any_tiny = larger(any_tiny, tiny_of[j]);\n";
  return out +
         "  if (fired != NULL) {\n    for (j = 0; j < kBlock; ++j) fired[j] = weights_of[j] > 0.0;\n  }\n  return odd "
         "!= "
         "0" +
         (can_be_tiny ? " || any_tiny > 0.0" : "") + ";\n}\n\n";
}

bool SourceWriter::goesInBlocks(const std::vector<std::size_t>& experts) const {
  return !isLarge() && !memberships_.isOdd() && !memberships_.usesExp() && !experts.empty() &&
         std::all_of(experts.begin(), experts.end(), [&](std::size_t e) { return ordered_[e].has_value(); });
}

std::string SourceWriter::batchText() const {
  const std::vector<std::size_t> experts = counting();
  if (goesInBlocks(experts)) return kOneByOne + strengthsTogether(experts) + kBegin + blockText(experts) + kEnd;
  return std::string(kOneByOne) +
         "void force_model_batch(const double *inputs, size_t points, double *force, unsigned char *fired) {\n"
         "  one_by_one(inputs, points, force, fired);\n}\n\n";
}

}  // namespace tactus::exchange
