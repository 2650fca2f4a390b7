// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "call.h"

#include "Request.h"

#include <CGAL/Geometric_continuity/IO/json.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <locale>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace {

std::string answer; // of the last call

void set_error(std::string_view code, std::string message) {
  const std::string repeated = std::string(code) + ": ";
  if (message.compare(0, repeated.size(), repeated) == 0) message.erase(0, repeated.size());
  std::ostringstream os;
  GC::write_json(os << "{\"error\":{\"code\":", code);
  GC::write_json(os << ",\"message\":", message);
  os << "}}";
  answer = os.str();
}

} // namespace

void set_answer(const std::function<std::string()>& f) {
  try {
    answer = f();
  } catch (const GC::Error& error) {
    set_error(GC::to_string(error.code()), error.what());
  } catch (const std::bad_alloc&) {
    set_error("work_limit", "there is not enough memory");
  } catch (const std::logic_error& error) { // of a command of the program: bad options
    set_error("malformed_input", error.what());
  } catch (const std::exception& error) { // the same: a limit
    set_error("work_limit", error.what());
  }
}

extern "C" {

void* gc_allocate(std::size_t size) { return std::malloc(size); }
void gc_free(void* p) { std::free(p); }

const char* gc_answer() { return answer.data(); }
std::size_t gc_answer_size() { return answer.size(); }

// Calls the function whose name is the first word.
void gc_call(const char* text, std::size_t size) {
  set_answer([&] {
    Request request(std::string_view(text, size));
    const std::string_view name = request.word();
    for (const Module_function& f : module_functions)
      if (name == f.name) {
        std::ostringstream os;
        os.imbue(std::locale::classic());
        f.function(request, os);
        return os.str();
      }
    throw GC::Error(GC::Error_code::malformed_input, "there is no function \"" + std::string(name) + '"');
  });
}
}
