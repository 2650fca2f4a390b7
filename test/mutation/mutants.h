// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <type_traits>
#include <utility>

/// \file mutants.h
/// Alterations of single tokens that a program chooses when it runs, by the environment variable
/// MUTANT; none without it. mutate.py writes them into a copy of the headers: `a + b` becomes
/// `a + mutants::at<17> + b`, which is `a - b` if 17 is chosen, because both operators have one
/// precedence and associate to the left. What is altered in constant expressions stays what it was,
/// and so does what would not compile. A program appends the numbers of the alterations that it has
/// come across to the file that MUTANTS_REACHED names, those that would not compile as ~17.

template <class T, class U> class __gmp_expr;
namespace boost {
namespace multiprecision {
namespace detail {
template <class Tag, class A1, class A2, class A3, class A4> struct expression;
}
} // namespace multiprecision
} // namespace boost

namespace mutants {

struct Reached {
  static const int size = 1 << 14;
  bool is_reached[size], is_impossible[size];
  ~Reached() {
    const char* name = std::getenv("MUTANTS_REACHED");
    std::FILE* file = name ? std::fopen(name, "a") : nullptr;
    if (!file) return;
    for (int i = 0; i < size; ++i)
      if (is_reached[i] || is_impossible[i]) std::fprintf(file, "%d\n", is_reached[i] ? i : ~i);
    std::fclose(file);
  }
};

inline Reached& reached() {
  static Reached all = {};
  return all;
}

inline bool is_chosen_now(int i) {
  static const char* const name = std::getenv("MUTANT");
  static const int chosen = name ? std::atoi(name) : -1;
  reached().is_reached[i] = true;
  return i == chosen;
}

inline void is_not_possible_now(int i) { reached().is_impossible[i] = true; }
constexpr void is_not_possible(int i) {
  if (!__builtin_is_constant_evaluated()) is_not_possible_now(i);
}

constexpr bool is_chosen(int i) { return !__builtin_is_constant_evaluated() && is_chosen_now(i); }

// Gives the type of an expression that is kept: expressions of GMP and Boost are evaluated.
template <class T> struct Value { typedef T type; };
template <class T, class U> struct Value<__gmp_expr<T, U>> { typedef __gmp_expr<T, T> type; };
template <class Tag, class A1, class A2, class A3, class A4>
struct Value<boost::multiprecision::detail::expression<Tag, A1, A2, A3, A4>> {
  typedef typename boost::multiprecision::detail::expression<Tag, A1, A2, A3, A4>::result_type type;
};
template <class T> using Value_of = typename Value<std::decay_t<T>>::type;

template <int i> struct At {};
template <int i> constexpr At<i> at = {};

#define CGAL_GC_MUTANT(name, op, other)                                                                                \
  template <int i, class A> struct name { A&& a; };                                                                    \
  template <int i, class A> constexpr name<i, A> operator op(A&& a, const At<i>&) { return {std::forward<A>(a)}; }     \
  template <                                                                                                           \
      int i, class A, class B, class R = Value_of<decltype(std::declval<A>() op std::declval<B>())>,                   \
      class = std::enable_if_t<std::is_constructible<R, decltype(std::declval<A>() other std::declval<B>())>::value>>  \
  constexpr R either(name<i, A>& x, B&& b, int) {                                                                      \
    if (is_chosen(i)) return R(std::forward<A>(x.a) other std::forward<B>(b));                                         \
    return R(std::forward<A>(x.a) op std::forward<B>(b));                                                              \
  }                                                                                                                    \
  template <int i, class A, class B, class R = Value_of<decltype(std::declval<A>() op std::declval<B>())>>             \
  constexpr R either(name<i, A>& x, B&& b, long) {                                                                     \
    is_not_possible(i);                                                                                                \
    return R(std::forward<A>(x.a) op std::forward<B>(b));                                                              \
  }                                                                                                                    \
  template <int i, class A, class B>                                                                                   \
  constexpr auto operator op(name<i, A>&& x, B&& b)->decltype(either(x, std::forward<B>(b), 0)) {                      \
    return either(x, std::forward<B>(b), 0);                                                                           \
  }
CGAL_GC_MUTANT(Plus, +, -)
CGAL_GC_MUTANT(Minus, -, +)
CGAL_GC_MUTANT(Times, *, +)
CGAL_GC_MUTANT(Divided, /, *)
CGAL_GC_MUTANT(Less, <, <=)
CGAL_GC_MUTANT(Less_or_equal, <=, <)
CGAL_GC_MUTANT(Greater, >, >=)
CGAL_GC_MUTANT(Greater_or_equal, >=, >)
CGAL_GC_MUTANT(Equal, ==, !=)
CGAL_GC_MUTANT(Not_equal, !=, ==)
#undef CGAL_GC_MUTANT

// Assignments associate to the right.
#define CGAL_GC_MUTANT(name, op, other)                                                                                \
  template <int i, class B> struct name { B&& b; };                                                                    \
  template <int i, class B> constexpr name<i, B> operator op(const At<i>&, B&& b) { return {std::forward<B>(b)}; }     \
  template <int i, class A, class B, class = decltype(std::declval<A&>() other std::declval<B>())>                     \
  constexpr A& either(A& a, name<i, B>& x, int) {                                                                      \
    if (is_chosen(i))                                                                                                  \
      a other std::forward<B>(x.b);                                                                                    \
    else                                                                                                               \
      a op std::forward<B>(x.b);                                                                                       \
    return a;                                                                                                          \
  }                                                                                                                    \
  template <int i, class A, class B> constexpr A& either(A& a, name<i, B>& x, long) {                                  \
    is_not_possible(i);                                                                                                \
    a op std::forward<B>(x.b);                                                                                         \
    return a;                                                                                                          \
  }                                                                                                                    \
  template <int i, class A, class B> constexpr A& operator op(A& a, name<i, B>&& x) { return either(a, x, 0); }
CGAL_GC_MUTANT(Plus_assigned, +=, -=)
CGAL_GC_MUTANT(Minus_assigned, -=, +=)
CGAL_GC_MUTANT(Times_assigned, *=, +=)
#undef CGAL_GC_MUTANT

// `!x` becomes `mutants::at<17> ->* x`.
template <int i, class T> constexpr auto operator->*(const At<i>&, T&& x) -> Value_of<decltype(!std::forward<T>(x))> {
  if (is_chosen(i)) return static_cast<bool>(x);
  return !std::forward<T>(x);
}

template <int i, bool is_min> struct Extremum {
  template <class T> constexpr const T& operator()(const T& a, const T& b) const {
    return is_min != is_chosen(i) ? (std::min)(a, b) : (std::max)(a, b);
  }
  template <class T, class Less> constexpr const T& operator()(const T& a, const T& b, Less less) const {
    return is_min != is_chosen(i) ? (std::min)(a, b, less) : (std::max)(a, b, less);
  }
  template <class T> constexpr T operator()(std::initializer_list<T> x) const {
    return is_min != is_chosen(i) ? (std::min)(x) : (std::max)(x);
  }
};

} // namespace mutants
