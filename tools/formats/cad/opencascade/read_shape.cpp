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

TopoDS_Shape translated(XSControl_Reader& reader, const std::string& file, const char* format,
                        const First_failure& reported, Losses& losses, Shape_labels& labels) {
  XSAlgo::SetAlgoContainer(new No_healing);
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetRVal("read.encoderegularity.angle", 0); // what is decided from samples is of no use here
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    throw failure(reported, std::string("not a complete ") + format + " file");
  reader.TransferRoots();
  add_failures(reader, losses);
  labels = read_labels(reader);
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull()) throw failure(reported, std::string("no shape in this ") + format + " file");
  return shape;
}

} // namespace

TopoDS_Shape read_shape(const std::string& file, const Cad_reading& reading, std::vector<std::string>& lost,
                        Shape_labels& labels) {
  const Handle(First_failure) reported = new First_failure;
  Message::DefaultMessenger()->ChangePrinters().Clear();
  Message::DefaultMessenger()->AddPrinter(reported);
  Losses losses(lost);
  switch (*cad_format(file)) {
  case Cad_format::step: {
    STEPControl_Reader reader;
    const TopoDS_Shape shape = translated(reader, file, "STEP", *reported, losses, labels);
    add_losses_of_step(file, reader, shape, losses);
    return shape;
  }
  case Cad_format::iges: {
    IGESControl_Reader reader;
    // Sewing takes an edge without a curve in space for a point.
    if (reading.sewing) Interface_Static::SetIVal("read.surfacecurve.mode", 3);
    const TopoDS_Shape shape = translated(reader, file, "IGES", *reported, losses, labels);
    add_losses_of_iges(reader, shape, losses);
    return shape;
  }
  case Cad_format::brep: break;
  }
  // OpenCASCADE would go on reading behind the end of the file, for ever.
  TopoDS_Shape shape;
  try {
    std::ifstream stream(file, std::ios::binary);
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    BRepTools_ShapeSet shapes((BRep_Builder()));
    shapes.Read(stream);
    shapes.Read(shape, stream);
    if (!shape.IsNull()) add_losses_of_brep(shapes, shape, losses);
  } catch (const std::ios_base::failure&) {
    throw failure(*reported, "not a complete BREP file");
  }
  if (shape.IsNull()) throw failure(*reported, "no shape in this BREP file");
  return shape;
}
