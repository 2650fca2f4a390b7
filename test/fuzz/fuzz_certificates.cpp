// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Certificates of joins: what is written about each join of a chain is read from its text, and its
// numbers prove the orders.

#include "fuzz_target.h"

#include "reports/certificate.h"

#include <CGAL/Geometric_continuity/IO/G2_span_reader.h>

#include <boost/property_tree/json_parser.hpp>

#include <map>
#include <utility>

namespace {

typedef CGAL::Exact_rational Q;
typedef std::vector<Q> Numbers; // a vector, or factors
constexpr int order = 3;

// The members of a line by their names: arrays of arrays of numbers, of which a flat array and an
// integer are one.
typedef std::map<std::string, std::vector<Numbers>> Members;

Members members_of(const std::string& line) {
  typedef boost::property_tree::ptree Tree;
  std::istringstream is('{' + line + '}');
  Tree tree;
  boost::property_tree::read_json(is, tree);
  const auto number = [](const Tree& x) { return GC::parse_number<Q>(x.data()); };
  Members members;
  for (const auto& [name, value] : tree) {
    std::vector<Numbers> rows(1);
    if (value.empty() && !value.data().empty()) rows[0].push_back(number(value));
    for (const auto& item : value) {
      if (item.second.empty())
        rows[0].push_back(number(item.second));
      else {
        rows.emplace_back();
        for (const auto& x : item.second) rows.back().push_back(number(x.second));
      }
    }
    if (rows.size() > 1) rows.erase(rows.begin());
    require(members.emplace(name, rows).second, "a member is written once");
  }
  return members;
}

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
void check(Members c) {
  const auto integer = [&](const char* name) { return static_cast<int>(CGAL::to_double(c[name].at(0).at(0))); };
  const std::vector<Numbers>&x = c["x"], &y = c["y"];
  const int dimension = static_cast<int>(x.at(0).size()), c_order = integer("c_order"), g = integer("g_order"),
            f = integer("f_order");
  require(x.size() == order + 1 && y.size() == order + 1, "there are derivatives up to the order");
  for (int j = 0; j <= c_order; ++j) require(x.at(j) == y[j], "C: derivatives are equal");
  if (c_order < order) {
    require(c["c_residual"].at(0) == sum(y.at(c_order + 1), Q(-1), x[c_order + 1]), "C: the residual");
    require(!is_zero(c["c_residual"][0]), "C: the next order does not hold");
  }
  if (c_order < 0 || is_zero(x[1]) || is_zero(y[1])) {
    require(g == (std::min)(c_order, 0) && f == g, "G and F are not defined");
    return;
  }
  const Numbers b = c["betas"].at(0);
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
    const Numbers a = c["f_factors"].at(j - 2);
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
    check(members_of(line));
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
