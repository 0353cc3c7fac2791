// Strengths in C with their common parts computed once: minima and maxima of the same memberships appear in many rules.
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

}  // namespace tactus::exchange
