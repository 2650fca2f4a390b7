// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/write_shape.h"

#include "formats/cad/cad_file.h"

#include <BRepTools.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Writer.hxx>
#include <StepAP214.hxx>
#include <StepAP214_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include <fstream>
#include <stdexcept>

namespace {

bool write_as_step(const TopoDS_Shape& shape, const std::string& file, bool with_parameter_curves,
                   const Named_faces& names) {
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetIVal("write.surfacecurve.mode", with_parameter_curves ? 1 : 0);
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone) return false;
  for (const auto& [face, name] : names) {
    const auto entity = STEPConstruct::FindEntity(writer.WS()->TransferWriter()->FinderProcess(), face);
    if (!entity.IsNull()) entity->SetName(new TCollection_HAsciiString(name.c_str()));
  }
  StepData_StepWriter text(writer.Model());
  text.FloatWriter().SetFormat("%.16E"); // so that the same doubles are read
  text.SendModel(StepAP214::Protocol());
  std::ofstream os(file);
  return text.Print(os) && os.flush();
}

} // namespace

void write_shape(const TopoDS_Shape& shape, const std::string& file, bool with_parameter_curves,
                 const Named_faces& names) {
  const bool written = cad_format(file) == Cad_format::brep ? BRepTools::Write(shape, file.c_str())
                                                            : write_as_step(shape, file, with_parameter_curves, names);
  if (!written) throw std::runtime_error("OpenCASCADE cannot write the model");
}
