// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_MODEL_BYTES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_MODEL_BYTES_H

#include "formats/cad/Cad_model.h"
#include "formats/cad/Cad_reading.h"
#include "formats/cad/Cad_solid.h"
#include "formats/cad/Shell_model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <variant>
#include <vector>

// A model as bytes, on its way from the process that reads the file to the program, on the same
// machine: numbers as they lie in memory, what is shared once. Both processes are of one build, see
// Cad_answer.h.

// The number of members of each class. Where it is wrong, the program does not compile.
template <class T> inline constexpr int number_of_members = 0;
template <int D> inline constexpr int number_of_members<GC::Cad_line<D>> = 2;
template <int D> inline constexpr int number_of_members<GC::Cad_conic<D>> = 6;
template <int D> inline constexpr int number_of_members<GC::Cad_spline_curve<D>> = 4;
template <int D> inline constexpr int number_of_members<GC::Cad_offset_curve<D>> = 3;
template <> inline constexpr int number_of_members<GC::Cad_frame> = 4;
template <> inline constexpr int number_of_members<GC::Cad_elementary_surface> = 4;
template <> inline constexpr int number_of_members<GC::Cad_spline_surface> = 6;
template <> inline constexpr int number_of_members<GC::Cad_extrusion> = 2;
template <> inline constexpr int number_of_members<GC::Cad_revolution> = 3;
template <> inline constexpr int number_of_members<GC::Cad_offset_surface> = 2;
template <> inline constexpr int number_of_members<GC::Edge_side> = 5;
template <> inline constexpr int number_of_members<GC::Edge_curve> = 2;
template <> inline constexpr int number_of_members<GC::Edge_end> = 3;
template <> inline constexpr int number_of_members<Cad_edge> = 14;
template <> inline constexpr int number_of_members<Cad_label> = 4;
template <> inline constexpr int number_of_members<Cad_reading> = 5;
template <> inline constexpr int number_of_members<Cad_mesh> = 4;
template <> inline constexpr int number_of_members<Cad_curve_edge> = 7;
template <> inline constexpr int number_of_members<Cad_join> = 3;
template <> inline constexpr int number_of_members<Cad_wires> = 4;
template <> inline constexpr int number_of_members<Cad_model> = 11;
template <> inline constexpr int number_of_members<Shell_model::Spline_curve> = 4;
template <> inline constexpr int number_of_members<Shell_model::Spline_curve_2> = 4;
template <> inline constexpr int number_of_members<Shell_model::Surface> = 10;
template <> inline constexpr int number_of_members<Shell_model::Edge> = 3;
template <> inline constexpr int number_of_members<Shell_model::Use> = 3;
template <> inline constexpr int number_of_members<Shell_model::Face> = 4;
template <> inline constexpr int number_of_members<Shell_model> = 3;
template <> inline constexpr int number_of_members<Cad_solid::Loop> = 3;
template <> inline constexpr int number_of_members<Cad_solid::Face> = 7;
template <> inline constexpr int number_of_members<Cad_solid::Edge> = 10;
template <> inline constexpr int number_of_members<Cad_solid> = 4;

// References to all members of an object.
template <class T> auto members(T& x) {
  constexpr int n = number_of_members<std::remove_const_t<T>>;
  static_assert(n > 0, "the number of the members of this class is missing");
  if constexpr (n == 2) {
    auto& [a, b] = x;
    return std::tie(a, b);
  } else if constexpr (n == 3) {
    auto& [a, b, c] = x;
    return std::tie(a, b, c);
  } else if constexpr (n == 4) {
    auto& [a, b, c, d] = x;
    return std::tie(a, b, c, d);
  } else if constexpr (n == 5) {
    auto& [a, b, c, d, e] = x;
    return std::tie(a, b, c, d, e);
  } else if constexpr (n == 6) {
    auto& [a, b, c, d, e, f] = x;
    return std::tie(a, b, c, d, e, f);
  } else if constexpr (n == 7) {
    auto& [a, b, c, d, e, f, g] = x;
    return std::tie(a, b, c, d, e, f, g);
  } else if constexpr (n == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = x;
    return std::tie(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (n == 11) {
    auto& [a, b, c, d, e, f, g, h, i, j, k] = x;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k);
  } else if constexpr (n == 14) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, o] = x;
    return std::tie(a, b, c, d, e, f, g, h, i, j, k, l, m, o);
  }
}

// Returns whether an object is nothing but numbers, any bytes of which are a value.
template <class T>
struct Is_plain
    : std::bool_constant<(std::is_arithmetic<T>::value && !std::is_same<T, bool>::value) || std::is_enum<T>::value> {};
template <class T, std::size_t n> struct Is_plain<std::array<T, n>> : Is_plain<T> {};

// Offsets of offsets of ... nest no deeper than this.
constexpr int deepest_offsets = 50;

class Byte_writer {
  std::string bytes_;
  std::map<const void*, std::uint64_t> numbers_; // of what is shared
  int depth_ = 0;

  void raw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

public:
  const std::string& bytes() const { return bytes_; }

  template <class T> void operator()(const T& x) {
    if constexpr (Is_plain<T>::value)
      raw(&x, sizeof x);
    else if constexpr (std::is_same<T, bool>::value)
      (*this)(static_cast<char>(x));
    else
      std::apply([this](const auto&... member) { ((*this)(member), ...); }, members(x));
  }
  template <class T, std::size_t n> void operator()(const std::array<T, n>& x) {
    for (const T& element : x) (*this)(element);
  }
  template <class T> void operator()(const std::vector<T>& x) {
    (*this)(std::uint64_t(x.size()));
    if constexpr (Is_plain<T>::value)
      raw(x.data(), x.size() * sizeof(T));
    else
      for (const T& element : x) (*this)(element);
  }
  void operator()(const std::string& x) {
    (*this)(std::uint64_t(x.size()));
    raw(x.data(), x.size());
  }
  template <class T> void operator()(const std::optional<T>& x) {
    (*this)(x.has_value());
    if (x) (*this)(*x);
  }
  template <class A, class B> void operator()(const std::pair<A, B>& x) {
    (*this)(x.first);
    (*this)(x.second);
  }
  template <class... T> void operator()(const std::variant<T...>& x) {
    (*this)(std::uint64_t(x.index()));
    std::visit(*this, x);
  }
  // The number of what is shared, and that itself where it comes first.
  template <class T> void operator()(const std::shared_ptr<const T>& x) {
    const auto [number, is_new] = numbers_.emplace(x.get(), numbers_.size());
    (*this)(number->second);
    if (!is_new) return;
    if (++depth_ > deepest_offsets) throw std::runtime_error("offsets of offsets, more than 50 times");
    (*this)(*x);
    --depth_;
  }
};

// Throws std::runtime_error for bytes that no Byte_writer has written.
class Byte_reader {
  std::string_view bytes_; // that are left
  // nothing while it is read
  std::vector<std::pair<std::type_index, std::shared_ptr<const void>>> shared_;
  int depth_ = 0;

  [[noreturn]] static void fail() { throw std::runtime_error("damaged bytes of a model"); }

  void raw(void* data, std::size_t size) {
    if (size > bytes_.size()) fail();
    if (size > 0) std::memcpy(data, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }
  std::size_t size(std::size_t bytes_of_element) {
    std::uint64_t result;
    (*this)(result);
    if (result > bytes_.size() / bytes_of_element) fail();
    return static_cast<std::size_t>(result);
  }
  template <class Variant, std::size_t i = 0> void alternative(Variant& x, std::uint64_t index) {
    if constexpr (i < std::variant_size_v<Variant>) {
      if (index == i)
        (*this)(x.template emplace<i>());
      else
        alternative<Variant, i + 1>(x, index);
    } else
      fail();
  }

public:
  explicit Byte_reader(std::string_view bytes) : bytes_(bytes) {}

  bool is_at_end() const { return bytes_.empty(); }

  template <class T> void operator()(T& x) {
    if constexpr (Is_plain<T>::value)
      raw(&x, sizeof x);
    else if constexpr (std::is_same<T, bool>::value) {
      char c;
      (*this)(c);
      x = c != 0;
    } else
      std::apply([this](auto&... member) { ((*this)(member), ...); }, members(x));
  }
  template <class T, std::size_t n> void operator()(std::array<T, n>& x) {
    for (T& element : x) (*this)(element);
  }
  template <class T> void operator()(std::vector<T>& x) {
    if constexpr (Is_plain<T>::value) {
      x.resize(size(sizeof(T)));
      raw(x.data(), x.size() * sizeof(T));
    } else
      for (std::size_t n = size(1); n > 0; --n) (*this)(x.emplace_back());
  }
  void operator()(std::string& x) {
    x.resize(size(1));
    raw(x.data(), x.size());
  }
  template <class T> void operator()(std::optional<T>& x) {
    bool has_value;
    (*this)(has_value);
    if (has_value) (*this)(x.emplace());
  }
  template <class A, class B> void operator()(std::pair<A, B>& x) {
    (*this)(x.first);
    (*this)(x.second);
  }
  template <class... T> void operator()(std::variant<T...>& x) {
    std::uint64_t index;
    (*this)(index);
    alternative(x, index);
  }
  template <class T> void operator()(std::shared_ptr<const T>& x) {
    std::uint64_t number;
    (*this)(number);
    if (number < shared_.size()) {
      const auto& [type, object] = shared_[static_cast<std::size_t>(number)];
      if (type != typeid(T) || !object) fail();
      x = std::static_pointer_cast<const T>(object);
      return;
    }
    if (number > shared_.size() || ++depth_ > deepest_offsets) fail();
    shared_.emplace_back(typeid(T), nullptr);
    const auto object = std::make_shared<T>();
    (*this)(*object);
    --depth_;
    x = object;
    shared_[static_cast<std::size_t>(number)].second = x;
  }
};

// Bytes as an argument of a program.
inline std::string hexadecimal(const std::string& bytes) {
  std::string result;
  for (const char c : bytes)
    for (const int shift : {4, 0}) result += "0123456789abcdef"[(static_cast<unsigned char>(c) >> shift) & 15];
  return result;
}
inline std::string from_hexadecimal(std::string_view digits) {
  const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
  std::string result;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    result += static_cast<char>(value(digits[i]) * 16 + value(digits[i + 1]));
  return result;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_MODEL_BYTES_H
