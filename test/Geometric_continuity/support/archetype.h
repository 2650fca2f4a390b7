// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Exact_rational.h>

#include <optional>
#include <stdexcept>
#include <vector>

// A number type, points, vectors and a traits class that offer what the concept
// GeometricContinuityTraits asks for and nothing more. What breaks here asks for more than is
// documented.
namespace archetype {

// A number has no value until it is assigned one; to read it before is an error.
class Number {
  typedef CGAL::Exact_rational Rational;
  std::optional<Rational> x_;

  explicit Number(const Rational& x) : x_(x) {}
  const Rational& value() const {
    if (!x_) throw std::logic_error("a number is read that was never assigned");
    return *x_;
  }

public:
  Number() = default;
  explicit Number(int i) : x_(Rational(i)) {}

  friend Number operator+(const Number& x, const Number& y) { return Number(Rational(x.value() + y.value())); }
  friend Number operator-(const Number& x, const Number& y) { return Number(Rational(x.value() - y.value())); }
  friend Number operator*(const Number& x, const Number& y) { return Number(Rational(x.value() * y.value())); }
  friend Number operator/(const Number& x, const Number& y) {
    if (y.value() == 0) throw std::domain_error("division by zero");
    return Number(Rational(x.value() / y.value()));
  }
  friend Number operator-(const Number& x) { return Number(Rational(-x.value())); }
  Number& operator+=(const Number& y) { return *this = *this + y; }
  Number& operator-=(const Number& y) { return *this = *this - y; }
  Number& operator*=(const Number& y) { return *this = *this * y; }
  Number& operator/=(const Number& y) { return *this = *this / y; }
  friend bool operator==(const Number& x, const Number& y) { return x.value() == y.value(); }
  friend bool operator!=(const Number& x, const Number& y) { return x.value() != y.value(); }
  friend bool operator<(const Number& x, const Number& y) { return x.value() < y.value(); }
};

template <class Dimension> struct Traits;

// Points and vectors can be copied; all else goes through the traits class.
template <class Dimension, class Kind> class Tuple {
  friend struct Traits<Dimension>;
  std::vector<Number> x_;

public:
  Tuple() = default;
};

template <class Dimension_> struct Traits {
  typedef Dimension_ Dimension;
  typedef Number FT;
  typedef Tuple<Dimension, struct Point_kind> Point;
  typedef Tuple<Dimension, struct Vector_kind> Vector;

  struct Compute_dimension {
    int operator()(const Point& p) const { return dimension(p); }
    int operator()(const Vector& v) const { return dimension(v); }
  };
  struct Compute_coordinate {
    FT operator()(const Point& p, int i) const { return p.x_.at(i); }
    FT operator()(const Vector& v, int i) const { return v.x_.at(i); }
  };
  struct Construct_point {
    template <class RandomAccessIterator>
    Point operator()(int d, RandomAccessIterator first, RandomAccessIterator last) const {
      return construct<Point>(d, first, last);
    }
  };
  struct Construct_vector {
    template <class RandomAccessIterator>
    Vector operator()(int d, RandomAccessIterator first, RandomAccessIterator last) const {
      return construct<Vector>(d, first, last);
    }
  };

  Compute_dimension compute_dimension_object() const { return Compute_dimension(); }
  Compute_coordinate compute_coordinate_object() const { return Compute_coordinate(); }
  Construct_point construct_point_object() const { return Construct_point(); }
  Construct_vector construct_vector_object() const { return Construct_vector(); }

private:
  template <class T> static int dimension(const T& t) { return static_cast<int>(t.x_.size()); }
  template <class T, class Iterator> static T construct(int d, Iterator first, Iterator last) {
    if (last - first != d) throw std::logic_error("wrong number of coordinates");
    T t;
    for (; first != last; ++first) t.x_.push_back(*first);
    return t;
  }
};

} // namespace archetype
