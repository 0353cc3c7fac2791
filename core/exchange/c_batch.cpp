// A batch of points in C: blocks of points side by side without a branch, so that compilers compute several at once.
// The block is compiled for several processors, and the program takes the best one that it runs on.
#include <algorithm>
#include <set>

#include "core/exchange/c_parts.h"

namespace tactus::exchange {
namespace {

using NameSet = std::set<std::string>;

std::string membershipName(std::size_t index) { return "m[" + std::to_string(index) + "]"; }

/// Declares the values t0, t1, … of one block of code.
class Statements {
 public:
  std::string declare(const std::string& value) {
    const std::string name = "t" + std::to_string(count_++);
    text_ += "const double " + name + " = " + value + ";\n";
    return name;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

/// Sets of names joined by one function of two: what several sets have in common is computed once.
class Family {
 public:
  explicit Family(std::string function) : function_(std::move(function)) {}

  void want(const NameSet& set) { left_[set] = set; }
  void declare(Statements& statements) {
    while (joinACommonPair(statements)) {
    }
    for (const auto& [set, rest] : left_) {
      const std::vector<std::string> parts(rest.begin(), rest.end());
      names_[set] = parts.size() == 1 ? parts.front() : statements.declare(tree(parts, function_));
    }
  }
  /// `set` was wanted.
  const std::string& operator[](const NameSet& set) const { return names_.at(set); }

 private:
  /// The pair of names that most sets have becomes one name; false where no two sets have one in common.
  bool joinACommonPair(Statements& statements) {
    std::map<std::pair<std::string, std::string>, int> uses;
    for (const auto& [set, rest] : left_) {
      for (auto one = rest.begin(); one != rest.end(); ++one) {
        for (auto other = std::next(one); other != rest.end(); ++other) ++uses[{*one, *other}];
      }
    }
    const auto most =
        std::max_element(uses.begin(), uses.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == uses.end() || most->second < 2) return false;
    const auto& [one, other] = most->first;
    const std::string joined = statements.declare(function_ + "(" + one + ", " + other + ")");
    for (auto& [set, rest] : left_) {
      if (!rest.contains(one) || !rest.contains(other)) continue;
      rest.erase(one);
      rest.erase(other);
      rest.insert(joined);
    }
    return true;
  }

  std::string function_;
  std::map<NameSet, NameSet> left_;  ///< each wanted set, and what of it is not joined yet
  std::map<NameSet, std::string> names_;
};

/// min(max(pivots), max(rests)); without a pivot max(rests), without a rest max(pivots).
struct Product {
  NameSet pivots, rests;
};

/// A premise that another one contains adds nothing to a maximum: it is the lower of both.
std::vector<Premise> withoutLower(const std::vector<Premise>& premises) {
  std::vector<Premise> out;
  for (std::size_t i = 0; i < premises.size(); ++i) {
    const auto outdoes = [&](std::size_t k) {
      const bool inside = std::includes(premises[i].begin(), premises[i].end(), premises[k].begin(), premises[k].end());
      return inside && (premises[k].size() < premises[i].size() || k < i);
    };
    bool lower = false;
    for (std::size_t k = 0; k < premises.size() && !lower; ++k) lower = k != i && outdoes(k);
    if (!lower) out.push_back(premises[i]);
  }
  return out;
}

class Sharing {
 public:
  explicit Sharing(std::span<const std::size_t> pivots) : pivots_(pivots) {}

  /// First all rules are read, so that it is known what they share.
  void read(const TermRules& rules) {
    auto& products = all_.emplace_back();
    for (const auto& [weight, premises] : rules) {
      const std::vector<Premise> highest = withoutLower(premises);
      if (highest.empty()) continue;
      if (highest.front().empty()) {
        products.push_back({weight, {}});  // always 1
      } else {
        products.push_back({weight, productsOf(highest)});
      }
    }
  }

  SharedStrengths write() {
    least_.declare(statements_);
    for (auto& of_one : all_) {
      for (auto& [weight, products] : of_one) {
        for (Product& product : products) {
          product.rests = named(product.rests);
          for (const NameSet& names : {product.pivots, product.rests}) {
            if (!names.empty()) largest_.want(names);
          }
        }
      }
    }
    largest_.declare(statements_);
    SharedStrengths out;
    for (const auto& of_one : all_) out.values.push_back(value(of_one));
    out.statements = statements_.text();
    return out;
  }

 private:
  using Weighted = std::vector<std::pair<double, std::vector<Product>>>;

  /// The rules of equal rests are joined by their pivots.
  std::vector<Product> productsOf(const std::vector<Premise>& premises) {
    std::map<std::string, NameSet> rests_of;  // of each pivot, "" where there is none
    for (const Premise& premise : premises) {
      std::string pivot;
      NameSet rest;
      for (const std::size_t index : premise) {
        const bool is_pivot = std::find(pivots_.begin(), pivots_.end(), index) != pivots_.end();
        if (is_pivot) {
          pivot = membershipName(index);
        } else {
          rest.insert(membershipName(index));
        }
      }
      rests_of[pivot].insert(keyOf(rest));
    }
    std::map<NameSet, NameSet> pivots_of;
    for (const auto& [pivot, rests] : rests_of) pivots_of[rests].insert(pivot);
    std::vector<Product> out;
    for (const auto& [rests, pivots] : pivots_of) {
      // A rest that stands without a pivot too is no lower with one; withoutLower has left such rules out.
      NameSet real = pivots;
      if (real.erase("") != 0) out.push_back({{}, rests});
      if (!real.empty()) out.push_back({real, rests});
    }
    return out;
  }

  /// The name under which the least of `rest` is looked up once it is declared; "" stands for nothing but a pivot.
  std::string keyOf(const NameSet& rest) {
    if (rest.empty()) return {};
    std::string key;
    for (const std::string& name : rest) key += key.empty() ? name : "&" + name;
    if (keys_.emplace(key, rest).second) least_.want(rest);
    return key;
  }
  NameSet named(const NameSet& keys) const {
    NameSet out;
    for (const std::string& key : keys) {
      if (!key.empty()) out.insert(least_[keys_.at(key)]);
    }
    return out;
  }

  std::string value(const Weighted& of_one) {
    std::vector<std::string> alternatives;
    for (const auto& [weight, products] : of_one) {
      std::vector<std::string> parts;
      for (const Product& product : products) parts.push_back(productName(product));
      const std::string held = parts.empty() ? "1.0" : tree(parts, "larger");
      alternatives.push_back(weight == 1 ? held : number(weight) + " * " + held);
    }
    return alternatives.empty() ? "0.0" : tree(alternatives, "larger");
  }

  std::string productName(const Product& product) {
    if (product.pivots.empty()) return largest_[product.rests];
    if (product.rests.empty()) return largest_[product.pivots];
    const auto sides = std::minmax(largest_[product.pivots], largest_[product.rests]);
    std::string& name = products_[{sides.first, sides.second}];
    if (name.empty()) name = statements_.declare("lower(" + sides.first + ", " + sides.second + ")");
    return name;
  }

  std::span<const std::size_t> pivots_;
  Statements statements_;
  Family least_{"lower"};
  Family largest_{"larger"};
  std::map<std::string, NameSet> keys_;
  std::map<std::pair<std::string, std::string>, std::string> products_;
  std::vector<Weighted> all_;  ///< of each strength
};

}  // namespace

SharedStrengths sharedStrengths(std::span<const TermRules> rules, std::span<const std::size_t> pivots) {
  Sharing sharing(pivots);
  for (const TermRules& one : rules) sharing.read(one);
  return sharing.write();
}

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
    forces += "    " + centroidOf(e) + "(s + " + std::to_string(count) + ", 1, &area, &moment);\n";
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
