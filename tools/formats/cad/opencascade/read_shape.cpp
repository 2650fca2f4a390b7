// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/cad_file.h"
#include "formats/cad/opencascade/losses.h"
#include "formats/cad/opencascade/read_model.h"

#include <BRepTools_ShapeSet.hxx>
#include <BRep_Builder.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <TCollection_AsciiString.hxx>
#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>

#include <algorithm>
#include <fstream>
#include <ios>
#include <memory>
#include <stdexcept>

namespace {

// Translated shapes stay as the file gives them.
class No_healing : public XSAlgo_AlgoContainer {
public:
  TopoDS_Shape ProcessShape(const TopoDS_Shape& shape, const Standard_Real, const Standard_Real, const Standard_CString,
                            const Standard_CString, Handle(Standard_Transient) &, const Message_ProgressRange&,
                            const Standard_Boolean) const override {
    return shape;
  }
};

// Keeps the first failure that is reported.
class First_failure : public Message_Printer {
  mutable std::string text_;

public:
  const std::string& text() const { return text_; }

protected:
  void send(const TCollection_AsciiString& message, const Message_Gravity gravity) const override {
    if (gravity >= Message_Fail && text_.empty()) text_ = message.ToCString();
  }
};

// These words and what was reported, e.g. "Line 954: Incorrect syntax".
std::runtime_error failure(const First_failure& reported, const std::string& words) {
  std::string text = reported.text();
  text.erase(0, (std::min)(text.find("Line "), text.size()));
  text.erase(text.find_last_not_of(" *\t\r\n") + 1);
  return std::runtime_error(text.empty() ? words : words + ": " + text);
}

Shape_of_file translated(XSControl_Reader& reader, const std::string& file, const char* format,
                         const First_failure& reported) {
  XSAlgo::SetAlgoContainer(new No_healing);
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  // what is decided from samples is of no use here
  Interface_Static::SetRVal("read.encoderegularity.angle", 0);
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    throw failure(reported, std::string("not a complete ") + format + " file");
  reader.TransferRoots();
  Shape_of_file result;
  result.shape = reader.OneShape();
  if (result.shape.IsNull()) throw failure(reported, std::string("no shape in this ") + format + " file");
  result.labels = read_labels(reader);
  result.closed_shells = closed_shells(result.shape, closed_shell_names(reader), false);
  return result;
}

// Adds the failures if nothing else tells what has failed.
void add_if_empty(const std::vector<std::string>& failures, Losses& losses) {
  if (losses.empty())
    for (const std::string& failure : failures) losses.add("", "", failure);
}

Shape_of_file read_step(const std::string& file, const First_failure& reported) {
  STEPControl_Reader reader;
  Shape_of_file result = translated(reader, file, "STEP", reported);
  Losses losses(result.lost);
  const std::vector<std::string> others = add_failures(reader, losses);
  add_losses_of_step(file, reader, result.shape, losses);
  add_if_empty(others, losses);
  return result;
}

Shape_of_file read_iges(const std::string& file, const Cad_reading& reading, const First_failure& reported) {
  IGESControl_Reader reader;
  if (reading.sewing) // which takes an edge without a curve in space for a point
    Interface_Static::SetIVal("read.surfacecurve.mode", 3);
  Shape_of_file result = translated(reader, file, "IGES", reported);
  Losses losses(result.lost);
  const std::vector<std::string> others = add_failures(reader, losses);
  add_losses_of_iges(reader, result.shape, losses);
  add_if_empty(others, losses);
  return result;
}

// OpenCASCADE would go on reading behind the end of the file, for ever.
Shape_of_file read_brep(const std::string& file, const First_failure& reported) {
  Shape_of_file result;
  try {
    std::ifstream stream(file, std::ios::binary);
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    BRepTools_ShapeSet shapes((BRep_Builder()));
    shapes.Read(stream);
    shapes.Read(result.shape, stream);
    Losses losses(result.lost);
    if (!result.shape.IsNull()) add_losses_of_brep(shapes, result.shape, losses);
  } catch (const std::ios_base::failure&) {
    throw failure(reported, "not a complete BREP file");
  }
  if (result.shape.IsNull()) throw failure(reported, "no shape in this BREP file");
  result.closed_shells = closed_shells(result.shape, {}, true);
  return result;
}

} // namespace

Shape_of_file read_shape(const std::string& file, const Cad_reading& reading) {
  const Handle(First_failure) reported = new First_failure;
  Message::DefaultMessenger()->ChangePrinters().Clear();
  Message::DefaultMessenger()->AddPrinter(reported);
  switch (*cad_format(file)) {
  case Cad_format::step: return read_step(file, *reported);
  case Cad_format::iges: return read_iges(file, reading, *reported);
  case Cad_format::brep: break;
  }
  return read_brep(file, *reported);
}
