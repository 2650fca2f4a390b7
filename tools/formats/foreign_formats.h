// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FOREIGN_FORMATS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FOREIGN_FORMATS_H

#include <string_view>

// The formats that no command reads, and the way that is nearest to reading what they hold.

struct Foreign_format {
  const char* name;
  std::string_view endings; // of names of files, in small letters, with a blank behind each
  const char* way;
};

namespace foreign {

constexpr const char* from_triangles = "triangles have no curvature; take the model of which they were made, as STEP";
constexpr const char* export_step = "export it as STEP from the system that made it";
constexpr const char* export_svg = "export it as SVG, e.g. with Inkscape";
constexpr const char* trace = "it holds pixels; trace its outlines to SVG, e.g. with potrace or Inkscape";

constexpr Foreign_format
    packed_model = {"a packed CAD model",
                    ".step.gz .stp.gz .stpz .step.z .stp.z .iges.gz .igs.gz .brep.gz .brp.gz .step.xz .stp.xz "
                    ".step.bz2 .stp.bz2 .stpxz ",
                    "unpack it first, e.g. with gunzip"},
    packed = {"a packed file", ".xz .bz2 .zst .zip .7z .tar .tgz .rar ", "unpack it first"},
    dxf = {"DXF", ".dxf ",
           "export it as SVG, or take the Python module: geometric_continuity.adapters.drawings.spline_pieces() reads "
           "the splines of ezdxf"},
    dwg = {"DWG", ".dwg .dgn ", "export it as SVG"},
    json = {"JSON", ".json .jsonl .ipynb .geojson .sarif ",
            "no curves are read from it; write them as .g2, or call the Python module"},
    glyphs = {"a source of Glyphs", ".glyphs .glyphspackage ",
              "make a font of it with fontmake -g, or take the Python module: geometric_continuity.adapters.sources "
              "finds and mends the kinks of the source"},
    ufo = {"a UFO", ".ufo .ufoz .glif ",
           "make a font of it with fontmake -u, or take the Python module: geometric_continuity.adapters.sources finds "
           "and mends the kinks of the source"},
    designspace =
        {"a designspace", ".designspace ",
         "make a variable font of it with fontmake -m and verify that with --all-instances, or take the Python "
         "module: geometric_continuity.adapters.sources.mend_designspace()"},
    font_source = {"the source of a font", ".sfd .sfdir .vfb .vfc .vfj .ttx ",
                   "make a font of it (.ttf, .otf) with the program that wrote it"},
    freecad = {"a document of FreeCAD", ".fcstd ",
               "export it as STEP from FreeCAD, or call geometric_continuity.adapters.freecad in its Python"},
    mesh = {"a mesh", ".stl .obj .ply .off .3mf .amf .gltf .glb .wrl .vrml .x3d .dae .msh .vtk .scad .blend ",
            from_triangles},
    cad_system =
        {"a file of a CAD system",
         ".3dm .sldprt .sldasm .slddrw .ipt .iam .idw .prt .asm .catpart .catproduct .x_t .x_b .xmt_txt .sat .sab "
         ".jt .f3d .f3z .skp .ifcxml ",
         export_step},
    print = {"a page", ".pdf .eps .ps .ai .cdr .odg .fig .emf .wmf .vsd .vsdx .drawio .afdesign .sketch ", export_svg},
    image = {"an image", ".png .jpg .jpeg .gif .bmp .tif .tiff .webp .xcf .psd .kra .pbm .pgm .ppm .ico ", trace},
    table = {"a table", ".csv .tsv .xls .xlsx .ods .parquet .npy .npz ",
             "fit and interpolate make curves of points, a line each in a text"};

} // namespace foreign

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FOREIGN_FORMATS_H
