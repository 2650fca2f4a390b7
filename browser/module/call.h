// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BROWSER_MODULE_CALL_H
#define GEOMETRIC_CONTINUITY_BROWSER_MODULE_CALL_H

#include <functional>
#include <ostream>
#include <string>
#include <vector>

class Request;

// How geometric_continuity.mjs calls a module: by functions of C on texts in memory. Arguments are
// words (Request.h), results are JSON, errors are the member `error` with the code of the package.

// A function that is called by its name, writes JSON, and throws GC::Error on bad input.
struct Module_function {
  const char* name;
  void (*function)(Request& request, std::ostream& os);
};

// The functions of this module.
extern const std::vector<Module_function> module_functions;

// Makes what f() returns the answer, or the error that it throws.
void set_answer(const std::function<std::string()>& f);

#endif // GEOMETRIC_CONTINUITY_BROWSER_MODULE_CALL_H
