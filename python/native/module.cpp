// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "geometry.h"

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <sstream>

// The module `_native`: numbers and arrays of Python in, records out. What users see is in the
// package around it.

namespace py = pybind11;

namespace {

// ---- numbers

[[noreturn]] void refuse_infinite() {
  throw GC::Error(GC::Error_code::not_finite, "array: a number is infinite or undefined");
}

// An integer of any length.
Exact exact_integer(const py::object& given) {
  int overflow = 0;
  const long long x = PyLong_AsLongLongAndOverflow(given.ptr(), &overflow);
  constexpr long long exact_in_double = 1LL << 53;
  if (overflow == 0 && -exact_in_double <= x && x <= exact_in_double) return Exact(static_cast<double>(x));
  const bool negative = given < py::int_(0);
  const py::object size = negative ? -given : given;
  const std::size_t bytes = (size.attr("bit_length")().cast<std::size_t>() + 31) / 32 * 4;
  const std::string digits = size.attr("to_bytes")(bytes, "big").cast<std::string>();
  Exact sum(0);
  for (std::size_t i = 0; i < bytes; i += 4) { // 32 bits at a time
    double word = 0;
    for (std::size_t j = i; j < i + 4; ++j) word = word * 256 + static_cast<unsigned char>(digits[j]);
    sum = Exact(sum * Exact(4294967296.)) + Exact(word);
  }
  return negative ? Exact(-sum) : sum;
}

// Appends a number as it is. `rounded` becomes true for a floating-point number.
Exact exact_number(const py::handle& given, bool& rounded) {
  if (PyFloat_Check(given.ptr())) {
    rounded = true;
    const double x = PyFloat_AS_DOUBLE(given.ptr());
    if (!std::isfinite(x)) refuse_infinite();
    return Exact(x);
  }
  const py::object number = py::reinterpret_borrow<py::object>(given);
  if (PyLong_Check(given.ptr())) return exact_integer(number);
  if (py::hasattr(number, "as_integer_ratio")) { // fractions, decimals, numbers of numpy
    if (py::isinstance(number, py::module_::import("numpy").attr("floating"))) rounded = true;
    py::tuple ratio;
    try {
      ratio = number.attr("as_integer_ratio")();
    } catch (py::error_already_set& e) {
      if (e.matches(PyExc_ValueError) || e.matches(PyExc_OverflowError)) refuse_infinite();
      throw;
    }
    return Exact(exact_integer(ratio[0]) / exact_integer(ratio[1]));
  }
  if (PyIndex_Check(given.ptr())) return exact_integer(py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr())));
  if (py::hasattr(number, "numerator") && py::hasattr(number, "denominator"))
    return Exact(exact_integer(number.attr("numerator")) / exact_integer(number.attr("denominator")));
  throw py::type_error("a number is needed, not '" + std::string(py::str(py::type::of(number).attr("__name__"))) + "'");
}

Exact exact_number(const py::handle& given) {
  bool rounded = false;
  return exact_number(given, rounded);
}

bool is_array_of_doubles(const py::object& given) {
  if (!py::isinstance<py::array>(given)) return false;
  const py::dtype type = py::cast<py::array>(given).dtype();
  return (type.kind() == 'f' && type.itemsize() <= 8) ||
         ((type.kind() == 'i' || type.kind() == 'u') && type.itemsize() <= 4);
}

Numbers numbers_of(const py::object& given) {
  Numbers x;
  if (is_array_of_doubles(given)) {
    const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
    if (!array) throw py::error_already_set();
    x.shape.assign(array.shape(), array.shape() + array.ndim());
    x.doubles.assign(array.data(), array.data() + array.size());
    x.rounded = py::cast<py::array>(given).dtype().kind() == 'f';
    for (const double y : x.doubles)
      if (!std::isfinite(y)) refuse_infinite();
    return x;
  }
  const py::module_ numpy = py::module_::import("numpy");
  const py::array array = numpy.attr("array")(given, py::arg("dtype") = py::dtype("O"));
  x.shape.assign(array.shape(), array.shape() + array.ndim());
  bool are_doubles = true;
  for (const py::handle item : array.attr("ravel")()) {
    if (x.exact.size() % 4096 == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
    x.exact.push_back(exact_number(item, x.rounded));
    x.doubles.push_back(nearest_double(x.exact.back()));
    are_doubles = are_doubles && std::isfinite(x.doubles.back()) && Exact(x.doubles.back()) == x.exact.back();
  }
  if (are_doubles)
    x.exact.clear();
  else
    x.doubles.clear();
  return x;
}

// A decimal text of any length as an integer: Python refuses long ones.
py::object integer(const std::string& text) {
  constexpr std::size_t most = 4000;
  if (text.size() <= 18) return py::int_(std::stoll(text));
  if (text[0] == '-') return -integer(text.substr(1));
  if (text.size() <= most) return py::reinterpret_steal<py::object>(PyLong_FromString(text.c_str(), nullptr, 10));
  const std::size_t half = text.size() / 2;
  return integer(text.substr(0, text.size() - half)) * py::module_::import("builtins").attr("pow")(10, half) +
         integer(text.substr(text.size() - half));
}

py::object fraction(const Exact& x) {
  std::ostringstream os;
  GC::write_number(os, x);
  const std::string text = os.str();
  const std::size_t slash = text.find('/');
  const py::object type = py::module_::import("fractions").attr("Fraction");
  if (slash == std::string::npos) return type(integer(text));
  return type(integer(text.substr(0, slash)), integer(text.substr(slash + 1)));
}

py::object number(const Exact& x, bool exact) {
  return exact ? fraction(x) : py::object(py::float_(nearest_double(x)));
}

// An array that owns the numbers, which are not copied.
py::array array_of(std::vector<double>&& numbers, const std::vector<std::size_t>& shape) {
  auto owner = std::make_unique<std::vector<double>>(std::move(numbers));
  double* const data = owner->data();
  const py::capsule capsule(owner.release(), [](void* p) { delete static_cast<std::vector<double>*>(p); });
  return py::array(py::dtype::of<double>(), shape, data, capsule);
}

// Numbers as an array of doubles, or of fractions.
py::array array_of(Numbers&& x, bool exact) {
  if (exact) {
    const std::size_t n = x.size();
    py::list fractions;
    for (std::size_t i = 0; i < n; ++i) fractions.append(fraction(x.are_doubles() ? Exact(x.doubles[i]) : x.exact[i]));
    py::array flat = py::module_::import("numpy").attr("empty")(n, py::arg("dtype") = py::dtype("O"));
    flat[py::slice(0, static_cast<py::ssize_t>(n), 1)] = fractions;
    return flat.attr("reshape")(py::cast(x.shape));
  }
  if (!x.are_doubles())
    for (const Exact& y : x.exact) x.doubles.push_back(nearest_double(y));
  return array_of(std::move(x.doubles), x.shape);
}

// How the results of a construction are wanted: as fractions, and in which field they are
// constructed. Without a wish they are exact where no floating-point number was given.
struct Wish {
  bool exact;
  Field_of_results field;

  Wish(const std::optional<bool>& given, std::initializer_list<const Numbers*> inputs) {
    bool rounded = false, are_doubles = true;
    for (const Numbers* x : inputs) {
      rounded = rounded || x->rounded;
      are_doubles = are_doubles && x->are_doubles();
    }
    exact = given ? *given : !rounded;
    field = exact || !are_doubles ? Field_of_results::exact : Field_of_results::doubles;
  }
};

// ---- errors

void set_error(const GC::Error& e) {
  const std::string code = to_string(e.code()), text = e.what(),
                    rest = text.substr((std::min)(text.size(), code.size() + 2));
  const std::size_t colon = rest.find(": ");
  std::string reason = code;
  for (char& c : reason)
    if (c == '_') c = ' ';
  if (colon != std::string::npos) reason = rest.substr(colon + 2);
  const py::object type = py::module_::import("geometric_continuity.errors").attr("Error");
  const py::object error = type(code, rest.substr(0, colon), reason);
  PyErr_SetObject(type.ptr(), error.ptr());
}

void check_signals() {
  const py::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

// Without the lock of the interpreter. Every now and then signals are looked at, so that Ctrl-C
// ends what is long.
template <class Function> auto released(Function f) {
  typedef std::chrono::steady_clock Clock;
  const py::gil_scoped_release release;
  Clock::time_point last = Clock::now();
  const GC::Work_scope interruptible("call", [&last] {
    const Clock::time_point now = Clock::now();
    if (now - last < std::chrono::milliseconds(50)) return;
    last = now;
    check_signals();
  });
  return f();
}

template <class T> std::string text(const T& x) {
  std::ostringstream os;
  os << x;
  return os.str();
}

// ---- functions

py::array_t<std::ptrdiff_t> failing_joins_of(const py::object& given, const std::string& order, bool closed,
                                             bool parallel) {
  const auto checked = [](py::ssize_t dimensions, py::ssize_t points, py::ssize_t d) {
    if (dimensions != 3 || points == 0 || d == 0)
      throw GC::Error(GC::Error_code::wrong_number_of_points,
                      "failing_joins: an array of shape (curves, degree + 1, dimension) is needed");
  };
  std::vector<std::ptrdiff_t> failing;
  py::array array;
  if (is_array_of_doubles(given)) {
    array = py::cast<py::array>(given);
    constexpr py::ssize_t size = sizeof(double);
    bool in_place =
        py::isinstance<py::array_t<double>>(array) && (array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_) != 0;
    for (py::ssize_t i = 0; i < array.ndim(); ++i) in_place = in_place && array.strides(i) % size == 0;
    if (!in_place) array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
    if (!array) throw py::error_already_set();
    checked(array.ndim(), array.ndim() == 3 ? array.shape(1) : 0, array.ndim() == 3 ? array.shape(2) : 0);
  }
  if (array && array.ndim() == 3 && (array.shape(2) == 2 || array.shape(2) == 3)) {
    constexpr py::ssize_t size = sizeof(double);
    const Curves_view view{static_cast<const double*>(array.data()),
                           static_cast<std::size_t>(array.shape(0)),
                           static_cast<int>(array.shape(1)) - 1,
                           static_cast<int>(array.shape(2)),
                           array.strides(0) / size,
                           array.strides(1) / size,
                           array.strides(2) / size};
    failing = released([&] { return failing_joins(view, order, closed, parallel, check_signals); });
  } else {
    const Numbers curves = numbers_of(given);
    checked(static_cast<py::ssize_t>(curves.shape.size()),
            curves.shape.size() == 3 ? static_cast<py::ssize_t>(curves.shape[1]) : 0,
            curves.shape.size() == 3 ? static_cast<py::ssize_t>(curves.shape[2]) : 0);
    failing = released([&] { return failing_joins(curves, order, closed, check_signals); });
  }
  return py::array_t<std::ptrdiff_t>(static_cast<py::ssize_t>(failing.size()), failing.data());
}

std::optional<Exact> optional_number(const py::object& x) {
  if (x.is_none()) return std::nullopt;
  return exact_number(x);
}

py::dict record_of(Blend_numbers&& r, bool exact) {
  py::dict record;
  record["points"] = array_of(std::move(r.points), exact);
  record["beta"] = number(r.beta, exact);
  record["eta"] = number(r.eta, exact);
  record["fallback_start"] = r.fallback_start;
  record["fallback_end"] = r.fallback_end;
  record["automatic_fairness"] = r.fairness ? py::object(py::float_((*r.fairness)[0])) : py::none();
  record["fairness"] = r.fairness ? py::object(py::float_((*r.fairness)[1])) : py::none();
  record["converged"] = r.converged;
  return record;
}

py::dict record_of(Curve_numbers&& r, bool exact) {
  py::dict record;
  record["degree"] = r.degree;
  record["points"] = array_of(std::move(r.points), exact);
  record["knots"] = array_of(std::move(r.knots), exact);
  return record;
}

} // namespace

PYBIND11_MODULE(_native, m) {
  m.doc() = "What the package geometric_continuity has in C++.";
  py::options options;
  options.disable_function_signatures();

  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const GC::Error& e) {
      set_error(e);
    }
  });

#ifdef CGAL_USE_GMP
  m.attr("uses_gmp") = true;
#else
  m.attr("uses_gmp") = false;
#endif

  py::class_<GC::Enclosure>(m, "Enclosure",
                            "A guaranteed enclosure of a real number by two floats: lower <= number <= upper.")
      .def_readonly("lower", &GC::Enclosure::lower, "not larger than the number; finite")
      .def_readonly("upper", &GC::Enclosure::upper, "not less than the number; inf when it is larger than all floats")
      .def("__iter__", [](const GC::Enclosure& x) { return py::iter(py::make_tuple(x.lower, x.upper)); })
      .def(
          "__eq__", [](const GC::Enclosure& x, const GC::Enclosure& y) { return x == y; }, py::is_operator())
      .def("__repr__", [](const GC::Enclosure& x) { return "Enclosure(" + text(x) + ')'; })
      .def("__str__", text<GC::Enclosure>);

  py::class_<GC::Order_up_to_rounding>(
      m, "Order_up_to_rounding", "An order G that a join of rounded numbers misses by no more than rounding: a hint.")
      .def_readonly("g_order", &GC::Order_up_to_rounding::g_order, "the order, at most 2")
      .def_readonly("units", &GC::Order_up_to_rounding::units,
                    "by how much control points are off, in units in the last place of their largest coordinate");

  typedef GC::Join_continuity<Exact> Join;
  py::class_<Join>(m, "Join_continuity", "What was decided about a join, exactly on the numbers as given.")
      .def_readonly("c_order", &Join::c_order, "the largest k such that all derivatives up to order k agree; -1: a gap")
      .def_readonly("g_order", &Join::g_order,
                    "the same of derivatives with respect to arc length; -1: a gap, 0: no common tangent")
      .def_readonly("f_order", &Join::f_order, "the same of Frenet frame and curvatures, at most the dimension")
      .def_readonly("regular", &Join::regular, "whether both tangents are nonzero")
      .def_readonly("tangent_equal", &Join::tangent_equal, "same direction; None unless regular")
      .def_readonly("curvature_equal", &Join::curvature_equal, "same magnitude; None where undefined")
      .def_readonly("curvature_vector_equal", &Join::curvature_vector_equal, "same vector; None where undefined")
      .def_readonly("torsion_equal", &Join::torsion_equal, "None unless in space with nonzero curvature on both sides")
      .def_property_readonly(
          "betas",
          [](const Join& join) {
            py::list betas;
            for (const Exact& beta : join.betas()) betas.append(fraction(beta));
            return py::tuple(betas);
          },
          "the shape parameters beta_1, ..., beta_g_order, exact: a tuple of fractions.Fraction")
      .def_property_readonly("up_to_rounding", &Join::up_to_rounding,
                             "the order that is missed by no more than rounding, or None")
      .def("__repr__", [](const Join& join) { return "<Join_continuity " + text(join) + '>'; })
      .def("__str__", text<Join>);

  py::class_<GC::Join_deviation>(m, "Join_deviation", "How far a join is from being continuous: guaranteed enclosures.")
      .def_readonly("gap", &GC::Join_deviation::gap, "the distance of the ends, in units of the coordinates")
      .def_readonly("tangent_angle", &GC::Join_deviation::tangent_angle,
                    "radians, in [0, pi]; None when a tangent is zero")
      .def_readonly("curvature_jump", &GC::Join_deviation::curvature_jump,
                    "relative jump of the curvature vector, in [0, 2]; None when a tangent is zero")
      .def_readonly("torsion_jump", &GC::Join_deviation::torsion_jump,
                    "units of 1/length; None unless in space with nonzero curvature on both sides")
      .def("__repr__", [](const GC::Join_deviation& d) { return "<Join_deviation " + text(d) + '>'; })
      .def("__str__", text<GC::Join_deviation>);

  py::class_<GC::Order_within>(m, "Order_within", "The orders 0 to 3 of a join, within a tolerance.")
      .def_readonly("deviation", &GC::Order_within::deviation, "the enclosures on which the verdicts rest")
      .def_property_readonly(
          "verdicts",
          [](const GC::Order_within& within) {
            py::list verdicts;
            for (const GC::Verdict verdict : within.verdicts) verdicts.append(to_string(verdict));
            return py::tuple(verdicts);
          },
          "of the orders 0 to 3: 'proved', 'refuted' or 'undecided'")
      .def_property_readonly("proved_order", &GC::Order_within::proved_order, "the largest order that is proved, or -1")
      .def("__repr__", [](const GC::Order_within& within) { return "<Order_within " + text(within) + '>'; })
      .def("__str__", text<GC::Order_within>);

  py::enum_<GC::Visual_class>(m, "Visual_class",
                              "What a join of two plane curves looks like, from the roughest to the smoothest.")
      .value("gap", GC::Visual_class::gap)
      .value("corner", GC::Visual_class::corner)
      .value("kink", GC::Visual_class::kink)
      .value("g1", GC::Visual_class::g1)
      .value("g2", GC::Visual_class::g2);

  py::class_<GC::Kink_size>(m, "Kink_size", "How large a kink is: guaranteed enclosures.")
      .def_readonly("angle", &GC::Kink_size::angle, "radians, in [0, pi]")
      .def_readonly("handle_offset", &GC::Kink_size::handle_offset,
                    "how far a handle must move at least, in units of the coordinates")
      .def_readonly("severity", &GC::Kink_size::severity, "angle times the length of the shorter handle")
      .def("__repr__", [](const GC::Kink_size& k) { return "<Kink_size " + text(k) + '>'; })
      .def("__str__", text<GC::Kink_size>);

  py::class_<Edge_record>(m, "Edge_continuity",
                          "What was decided about two surfaces along an edge, on the whole closed edge.")
      .def_readonly("g_order", &Edge_record::g_order,
                    "-1 when the edges differ, 0 one curve, 1 one tangent plane, 2 one curvature")
      .def_readonly("defect", &Edge_record::defect, "why the order is not higher, e.g. 'crease'")
      .def_readonly("reversed", &Edge_record::reversed, "the second edge runs backwards")
      .def_readonly("coplanar", &Edge_record::coplanar, "the tangent planes agree wherever there are any")
      .def_readonly("collapsed", &Edge_record::collapsed, "the edge is a single point")
      .def_readonly("normal_vanishes", &Edge_record::normal_vanishes, "a normal vanishes somewhere on the edge")
      .def_readonly("whole_a", &Edge_record::whole_a, "the common part is all of the first edge")
      .def_readonly("whole_b", &Edge_record::whole_b, "the common part is all of the second edge")
      .def_readonly("largest_angle", &Edge_record::largest_angle,
                    "radians, an upper bound of the angle of the normals, or None")
      .def("__repr__", [](const Edge_record& e) { return "<Edge_continuity " + e.text + '>'; })
      .def("__str__", [](const Edge_record& e) { return e.text; });

  m.def("continuity", [](const py::object& left, const py::object& right, int max_order) {
    const Numbers a = numbers_of(left), b = numbers_of(right);
    return released([&] { return continuity(a, b, max_order == 3 ? std::nullopt : std::optional<int>(max_order)); });
  });
  m.def("deviation", [](const py::object& left, const py::object& right) {
    const Numbers a = numbers_of(left), b = numbers_of(right);
    return released([&] { return deviation(a, b); });
  });
  m.def("order_within", [](const py::object& left, const py::object& right, const py::object& tangent_angle,
                           const py::object& curvature_jump, const py::object& torsion_jump, const py::object& gap,
                           const py::object& curvature_derivative) {
    const Numbers a = numbers_of(left), b = numbers_of(right);
    const auto bound = [](const py::object& x) { return GC::Bound(GC::enclosure(exact_number(x))); };
    const GC::Join_tolerance tolerance{bound(tangent_angle), bound(curvature_jump), bound(torsion_jump), bound(gap),
                                       bound(curvature_derivative)};
    return released([&] { return order_within(a, b, tolerance); });
  });
  m.def("is_c_within", [](const py::object& left, const py::object& right, int order, const py::object& tangent_angle,
                          const py::object& curvature_jump, const py::object& gap) {
    const Numbers a = numbers_of(left), b = numbers_of(right);
    const auto bound = [](const py::object& x) { return GC::Bound(GC::enclosure(exact_number(x))); };
    const GC::Join_tolerance tolerance{bound(tangent_angle), bound(curvature_jump), 0, bound(gap)};
    return to_string(released([&] { return is_c_within(a, b, order, tolerance); }));
  });
  m.def("visual_class", [](const py::object& left, const py::object& right, const py::object& kink_angle) {
    const Numbers a = numbers_of(left), b = numbers_of(right);
    const Exact angle = exact_number(kink_angle);
    return released([&] { return visual_class(a, b, angle); });
  });
  m.def("kink_size", [](const py::object& left, const py::object& right) {
    const Numbers a = numbers_of(left), b = numbers_of(right);
    return released([&] { return kink_size(a, b); });
  });
  typedef std::pair<std::int64_t, std::int64_t> Pair;
  const auto pair = [](const GC::Grid_vector& v) { return py::make_tuple(v.x, v.y); };
  m.def("align_handles", [pair](const Pair& left, const Pair& right, std::int64_t max_squared_move) -> py::object {
    const auto handles = GC::align_handles({left.first, left.second}, {right.first, right.second}, max_squared_move);
    if (!handles) return py::none();
    return py::make_tuple(pair(handles->left), pair(handles->right));
  });
  m.def("align_handle", [pair](const Pair& handle, const Pair& direction) {
    return pair(GC::align_handle({handle.first, handle.second}, {direction.first, direction.second}));
  });
  m.def("failing_joins", failing_joins_of);
  m.attr("version") = GEOMETRIC_CONTINUITY_VERSION;
  m.attr("strategies") = py::tuple(py::cast(strategy_names()));
  m.def("blend",
        [](const py::object& left, const py::object& right, const std::string& strategy, const py::object& beta,
           const py::object& eta, const py::object& parameters, const std::optional<bool>& exact) {
          const Numbers a = numbers_of(left), b = numbers_of(right), p = numbers_of(parameters);
          const std::optional<Exact> x = optional_number(beta), y = optional_number(eta);
          const Wish wish(exact, {&a, &b, &p});
          return record_of(released([&] { return blend(a, b, strategy, x, y, p, wish.field); }), wish.exact);
        });
  m.def("clothoid_blend", [](const py::object& start, const py::object& end, bool exact) {
    const Numbers a = numbers_of(start), b = numbers_of(end);
    Clothoid_numbers r = released([&] { return clothoid_blend(a, b); });
    py::dict record;
    record["segments"] = array_of(std::move(r.segments), exact);
    record["gaps"] = py::tuple(py::cast(r.gaps));
    record["kinks"] = py::tuple(py::cast(r.kinks));
    record["jumps"] = py::tuple(py::cast(r.jumps));
    return record;
  });
  m.def("representable_blend", [](const py::object& left, const py::object& right, const std::string& strategy) {
    const Numbers a = numbers_of(left), b = numbers_of(right);
    if (!a.are_doubles() || !b.are_doubles())
      throw GC::Error(GC::Error_code::not_representable, "representable_blend: a coordinate is no float");
    Representable_numbers r = released([&] { return representable_blend(a, b, strategy); });
    py::dict record;
    record["points"] = array_of(std::move(r.gamma), false);
    record["phi"] = array_of(std::move(r.phi), false);
    record["psi"] = array_of(std::move(r.psi), false);
    record["moved"] = r.moved;
    return record;
  });
  m.def("round_corner", [](const py::object& left, const py::object& right, const py::object& size, bool is_radius,
                           const std::string& strategy, const std::optional<bool>& exact) {
    const Numbers a = numbers_of(left), b = numbers_of(right);
    const double d = nearest_double(exact_number(size));
    const Wish wish(exact, {&a, &b});
    Corner_numbers r = released([&] { return round_corner(a, b, d, is_radius, strategy, wish.field); });
    py::dict record;
    record["left"] = array_of(std::move(r.left), wish.exact);
    record["blend"] = array_of(std::move(r.blend), wish.exact);
    record["knots"] = r.knots.size() == 0 ? py::object(py::none()) : array_of(std::move(r.knots), wish.exact);
    record["right"] = array_of(std::move(r.right), wish.exact);
    record["left_cut"] = number(r.left_cut, wish.exact);
    record["right_cut"] = number(r.right_cut, wish.exact);
    return record;
  });
  m.def("fairness", [](const py::object& curve) {
    const Numbers x = numbers_of(curve);
    return released([&] { return fairness(x); });
  });
  m.def("curvature_excess",
        [](const py::object& points, const py::object& weights, const py::object& domain,
           const py::object& bound) -> py::object {
          const Numbers p = numbers_of(points), w = numbers_of(weights), d = numbers_of(domain);
          const Exact most = exact_number(bound);
          const auto excess = released([&] { return curvature_excess(p, w, d, most); });
          if (!excess) return py::none();
          return py::make_tuple(excess->parameter, excess->curvature, excess->unbounded);
        });
  m.def("interpolate", [](const py::object& points, bool closed, const std::string& parametrisation,
                          const py::object& parameters, const std::optional<bool>& exact) {
    const Numbers p = numbers_of(points), u = numbers_of(parameters);
    const Wish wish(exact, {&p, &u});
    return record_of(released([&] { return interpolate(p, closed, parametrisation, u, wish.field); }), wish.exact);
  });
  m.def("interpolate_fair", [](const py::object& points, bool closed, const std::optional<bool>& exact) {
    const Numbers p = numbers_of(points);
    const Wish wish(exact, {&p});
    Fair_spline_numbers r = released([&] { return interpolate_fair(p, closed, wish.field); });
    const py::object moved = number(r.moved, wish.exact);
    const std::vector<int> rounded = r.rounded;
    py::dict record = record_of(std::move(r), wish.exact);
    record["moved"] = moved;
    record["rounded"] = rounded;
    return record;
  });
  m.def("fit", [](const py::object& points, const py::object& tolerance, int order, bool closed, double corner_angle,
                  const std::optional<bool>& exact) {
    const Numbers p = numbers_of(points);
    const Exact bound = exact_number(tolerance);
    const Wish wish(exact, {&p});
    Fitted_numbers r = released([&] { return fit(p, bound, order, closed, corner_angle, wish.field); });
    const std::vector<int> vertices = r.vertices, corners = r.corners;
    const double distance = r.distance;
    py::dict record = record_of(std::move(r), wish.exact);
    record["vertices"] = vertices;
    record["corners"] = corners;
    record["distance"] = distance;
    return record;
  });
  m.def("edge_continuity",
        [](const py::object& a, const std::string& edge_a, const py::object& b, const std::string& edge_b) {
          const Numbers x = numbers_of(a), y = numbers_of(b);
          return released([&] { return edge_continuity(x, edge_a, y, edge_b); });
        });
  m.def("match", [](const py::object& a, const std::string& edge_a, const py::object& b, const std::string& edge_b,
                    int order, const py::dict& given, const std::optional<bool>& exact) {
    const Numbers x = numbers_of(a), y = numbers_of(b);
    std::vector<std::pair<std::string, Exact>> shape;
    bool rounded = false;
    for (const auto& [name, number] : given)
      shape.emplace_back(py::cast<std::string>(name), exact_number(number, rounded));
    Matched_numbers r = released([&] { return match(x, edge_a, y, edge_b, order, shape); });
    const bool is_exact = exact ? *exact : !(x.rounded || y.rounded || rounded);
    py::dict record, numbers;
    record["points"] = array_of(std::move(r.points), is_exact);
    for (const auto& [name, value] : r.shape) numbers[name.c_str()] = number(value, is_exact);
    record["shape"] = numbers;
    record["edges"] = r.edges;
    record["before"] = std::move(r.before);
    record["has_order"] = r.has_order;
    return record;
  });
  m.def("edge_continuity", [](const py::object& a, const py::object& b) {
    const Numbers x = numbers_of(a), other = a.is(b) ? Numbers() : numbers_of(b);
    const Numbers& y = a.is(b) ? x : other;
    return released([&] { return edge_continuity(x, y); });
  });
}
