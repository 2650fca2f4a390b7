// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Certificates of joins: what is written about each join of a chain is read from its text, and its
// numbers prove the orders.

#include "fuzz_target.h"

#include "reports/certificate.h"

#include <CGAL/Geometric_continuity/IO/G2_span_reader.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_rational Q;
typedef std::vector<Q> Numbers; // a vector, or factors
constexpr int order = 3;

// The members of a line: integers, and arrays of arrays of numbers; a flat array is one of these.
struct Certificate_reader {
  const std::string text;
  std::size_t at = 0;
  std::map<std::string, std::vector<Numbers>> members;

  explicit Certificate_reader(std::string line) : text(std::move(line)) {
    do {
      const std::string name = word();
      expect(':');
      require(members.emplace(name, value()).second, "a member is written once");
    } while (has_more());
  }

  bool has_more() {
    if (at == text.size()) return false;
    expect(',');
    return true;
  }
  void expect(char c) { require(at < text.size() && text[at++] == c, "a certificate is a list of members"); }
  std::string word() {
    expect('"');
    const std::size_t begin = at, end = text.find('"', at);
    require(end != std::string::npos, "a text has an end");
    at = end + 1;
    return text.substr(begin, end - begin);
  }
  bool next_is(char c) const { return at < text.size() && text[at] == c; }

  template <class Item> void list(Item item) {
    expect('[');
    if (!next_is(']'))
      for (item(); !next_is(']'); item()) expect(',');
    expect(']');
  }
  Numbers numbers() {
    Numbers x;
    list([&] { x.push_back(GC::parse_number<Q>(word())); });
    return x;
  }
  std::vector<Numbers> value() {
    if (!next_is('[')) { // an order
      const std::size_t begin = at;
      while (at < text.size() && (text[at] == '-' || std::isdigit(static_cast<unsigned char>(text[at])))) ++at;
      return {{GC::parse_number<Q>(text.substr(begin, at - begin))}};
    }
    if (text.compare(at, 2, "[[") != 0) return {numbers()};
    std::vector<Numbers> rows;
    list([&] { rows.push_back(numbers()); });
    return rows;
  }

  int integer(const std::string& name) { return static_cast<int>(CGAL::to_double(members[name].at(0).at(0))); }
};

Q product(const Numbers& x, const Numbers& y) {
  Q sum(0);
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}
bool is_zero(const Numbers& x) { return product(x, x) == 0; }
// x + s y
Numbers sum(Numbers x, const Q& s, const Numbers& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += s * y[i];
  return x;
}

// Checks that the numbers of a certificate prove its orders, by the equations of the class
// Join_certificate.
void check(Certificate_reader c) {
  const std::vector<Numbers>&x = c.members["x"], &y = c.members["y"];
  const int dimension = static_cast<int>(x.at(0).size()), c_order = c.integer("c_order"), g = c.integer("g_order"),
            f = c.integer("f_order");
  require(x.size() == order + 1 && y.size() == order + 1, "there are derivatives up to the order");
  for (int j = 0; j <= c_order; ++j) require(x.at(j) == y[j], "C: derivatives are equal");
  if (c_order < order) {
    require(c.members["c_residual"].at(0) == sum(y.at(c_order + 1), Q(-1), x[c_order + 1]), "C: the residual");
    require(!is_zero(c.members["c_residual"][0]), "C: the next order does not hold");
  }
  if (c_order < 0 || is_zero(x[1]) || is_zero(y[1])) {
    require(g == (std::min)(c_order, 0) && f == g, "G and F are not defined");
    return;
  }
  const Numbers b = c.members["betas"].at(0);
  require(static_cast<int>(b.size()) == (std::min)(g + 1, order) && (g == 0 || b[0] > 0), "G: the shape parameters");
  for (int j = 1; j <= static_cast<int>(b.size()); ++j) {
    Numbers residual = sum(y[j], Q(-b[j - 1]), x[1]); // the chain rule
    if (j == 2) residual = sum(residual, Q(-b[0] * b[0]), x[2]);
    if (j == 3) residual = sum(sum(residual, Q(-3 * b[0] * b[1]), x[2]), Q(-b[0] * b[0] * b[0]), x[3]);
    if (j <= g)
      require(is_zero(residual), "G: derivatives agree");
    else
      require(product(residual, x[1]) == 0 && (!is_zero(residual) || (j == 1 && b[0] <= 0)),
              "G: the next order does not hold");
  }
  require((f >= 1) == (g >= 1) && f <= (std::min)(order, dimension), "F: at least a tangent");
  if (f < 1) return;
  for (int j = 2; j <= (std::min)(f + 1, (std::min)(order, dimension)); ++j) {
    Q power(1);
    for (int i = 0; i < j; ++i) power *= b[0];
    Numbers residual = sum(y[j], Q(-power), x[j]);
    const Numbers a = c.members["f_factors"].at(j - 2);
    for (int i = 1; i < j; ++i) residual = sum(residual, Q(-a.at(i - 1)), x[i]);
    require(is_zero(residual) == (j <= f), "F: the order");
    for (int i = 1; i < j; ++i) require(product(residual, x[i]) == 0, "F: the residual is orthogonal");
  }
}

template <int N> void check_chain(std::string_view text) {
  typedef std::conditional_t<N == 2, GC::Traits_2<CGAL::Simple_cartesian<Q>>, GC::Traits_3<CGAL::Simple_cartesian<Q>>>
      Traits;
  typedef GC::G2_span<Traits> Span;
  std::istringstream is{std::string(text)};
  GC::G2_span_reader<Traits> reader(is, "fuzz.g2", order);
  Span left, right;
  for (int spans = 0; spans < 30 && reader.next(right); ++spans, std::swap(left, right)) {
    if (spans == 0 || right.degree() > 6 || left.degree() > 6) continue;
    const auto join = continuity(left, right);
    for (const int most : {2, order}) {
      const auto orders = continuity_orders(left, right, most);
      require(orders.c_order == (std::min)(join.c_order, most) && orders.g_order == (std::min)(join.g_order, most) &&
                  orders.f_order == (std::min)(join.f_order, most),
              "all roads lead to the same orders");
    }
    const std::string line = certificate_members(GC::join_certificate(
        left.jets().template end_jet_over<Q>(order), right.jets().template start_jet_over<Q>(order), join, order));
    if (line.size() > 20000) continue; // long numbers are not read again
    check(Certificate_reader(line));
  }
}

// Returns whether a number has an exponent of three digits or more. Long numbers are a matter of
// fuzz_curves; here they would take most of the time.
bool has_large_exponent(std::string_view text) {
  const char* const digits = "0123456789";
  for (std::size_t e = text.find_first_of("eE"); e != std::string_view::npos; e = text.find_first_of("eE", e + 1)) {
    const std::string_view exponent = text.substr((std::min)(text.find_first_of(digits, e), text.size()));
    if (text.size() - exponent.size() <= e + 2 && (std::min)(exponent.find_first_not_of(digits), exponent.size()) > 2)
      return true;
  }
  return false;
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz_text(data, size);
  if (has_large_exponent(text)) return 0;
  const GC::Work_scope all(GC::Work_limit(200000000), "a fuzz input");
  accepts([&] { check_chain<2>(text); });
  accepts([&] { check_chain<3>(text); });
  return 0;
}
