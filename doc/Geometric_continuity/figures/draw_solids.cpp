// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Draws solids with rounded edges, by strips of equal brightness, above the fillets that
// OpenCASCADE makes of them.
//   draw_solids make FOLDER             writes solids as NAME.step, and prints a line for each: its
//                                       name, and by how much its edges are set back
//   draw_solids draw FOLDER PICTURE.png reads them, and NAME_rounded.step

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Tool.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <zlib.h>

namespace {

struct Named_solid {
  const char* name;
  double set_back;
  TopoDS_Shape shape;
};

TopoDS_Face polygon(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& p : points) wire.Add(p);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

// An outline in the plane y = 0, swept along y.
TopoDS_Shape prism(const std::vector<std::array<double, 2>>& outline, double width) {
  std::vector<gp_Pnt> points;
  for (const auto& [x, z] : outline) points.emplace_back(x, 0, z);
  return BRepPrimAPI_MakePrism(polygon(points), gp_Vec(0, width, 0)).Shape();
}

// The solid of faces in all planes n . x = d that hold points, for these normals.
TopoDS_Shape convex(const std::vector<gp_Pnt>& points, const std::vector<gp_Vec>& normals) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (const gp_Vec& n : normals) {
    const auto height = [&](const gp_Pnt& p) { return n.Dot(gp_Vec(p.XYZ())); };
    double highest = -std::numeric_limits<double>::max();
    for (const gp_Pnt& p : points) highest = (std::max)(highest, height(p));
    std::vector<gp_Pnt> corners;
    gp_XYZ middle(0, 0, 0);
    for (const gp_Pnt& p : points)
      if (height(p) > highest - 1e-9) {
        corners.push_back(p);
        middle += p.XYZ();
      }
    const gp_Pnt centre(middle / static_cast<double>(corners.size()));
    const gp_Vec x(centre, corners[0]), y = n.Crossed(x) * (1 / n.Magnitude());
    std::sort(corners.begin(), corners.end(), [&](const gp_Pnt& a, const gp_Pnt& b) {
      const auto angle = [&](const gp_Pnt& p) {
        return std::atan2(gp_Vec(centre, p).Dot(y), gp_Vec(centre, p).Dot(x));
      };
      return angle(a) < angle(b);
    });
    sewing.Add(polygon(corners));
  }
  sewing.Perform();
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape())).Solid();
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TopoDS_Shape tetrahedron(double size) {
  std::vector<gp_Pnt> points;
  std::vector<gp_Vec> normals;
  for (const auto& [x, y, z] :
       std::array<std::array<double, 3>, 4>{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}}) {
    points.emplace_back(size * x, size * y, size * z);
    normals.emplace_back(-x, -y, -z);
  }
  return convex(points, normals);
}

TopoDS_Shape dodecahedron(double size) {
  const double golden = (1 + std::sqrt(5)) / 2;
  std::vector<gp_Pnt> points;
  std::vector<gp_Vec> normals;
  for (const double a : {-size, size})
    for (const double b : {-size, size}) {
      for (const double c : {-size, size}) points.emplace_back(a, b, c);
      points.emplace_back(0, a / golden, b * golden);
      points.emplace_back(a / golden, b * golden, 0);
      points.emplace_back(a * golden, 0, b / golden);
      normals.emplace_back(0, a * golden, b);
      normals.emplace_back(a * golden, b, 0);
      normals.emplace_back(a, 0, b * golden);
    }
  return convex(points, normals);
}

std::vector<Named_solid> solids() {
  return {{"box", 4, prism({{0, 0}, {30, 0}, {30, 16}, {0, 16}}, 22)},
          {"bracket", 2, prism({{0, 0}, {30, 0}, {30, 7}, {8, 7}, {8, 26}, {0, 26}}, 20)},
          {"wedge", 3, prism({{0, 0}, {32, 0}, {32, 8}, {0, 20}}, 22)},
          {"tetrahedron", 4, tetrahedron(12)},
          {"dodecahedron", 3, dodecahedron(10)},
          {"fork", 2, prism({{0, 0}, {36, 0}, {36, 24}, {28, 24}, {26, 10}, {10, 10}, {8, 18}, {0, 18}}, 16)}};
}

// All edges with one radius, by which none is set back by more than the others at most: r / tan of
// half the angle between the faces.
std::optional<TopoDS_Shape> fillets(const Named_solid& solid) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(solid.shape, TopAbs_EDGE, TopAbs_FACE, faces);
  double radius = std::numeric_limits<double>::max();
  for (int i = 1; i <= faces.Extent(); ++i) {
    const auto normal = [](const TopoDS_Shape& shape) {
      return BRepAdaptor_Surface(TopoDS::Face(shape)).Plane().Axis().Direction();
    };
    double turn = normal(faces(i).First()).Angle(normal(faces(i).Last())); // of the normals
    if (faces(i).First().Orientation() != faces(i).Last().Orientation()) turn = M_PI - turn;
    radius = (std::min)(radius, solid.set_back / std::tan(turn / 2));
  }
  try {
    BRepFilletAPI_MakeFillet maker(solid.shape);
    for (int i = 1; i <= faces.Extent(); ++i) maker.Add(radius, TopoDS::Edge(faces.FindKey(i)));
    return maker.Shape();
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

TopoDS_Shape read(const std::string& file) {
  STEPControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw std::runtime_error("cannot read " + file);
  reader.TransferRoots();
  return reader.OneShape();
}

void write(const TopoDS_Shape& shape, const std::string& file) {
  STEPControl_Writer writer;
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone || writer.Write(file.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("cannot write " + file);
}

// A picture in colours of a palette, several points a pixel.
class Picture {
  static constexpr int fine = 4;
  int width_, height_;
  std::vector<float> brightness_, depth_; // of each point; white where nothing is

  float& at(std::vector<float>& values, int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ * fine) + static_cast<std::size_t>(x)];
  }

public:
  struct Corner {
    gp_XYZ place; // in points of this picture, and the depth
    gp_Vec normal;
  };
  Picture(int width, int height) : width_(width), height_(height) {
    const auto points = static_cast<std::size_t>(width * fine) * static_cast<std::size_t>(height * fine);
    brightness_.assign(points, 1);
    depth_.assign(points, -std::numeric_limits<float>::max());
  }
  static double scale() { return fine; }

  // Strips of equal brightness, a little darker where less light falls.
  static float strip(gp_Vec n) {
    n.Normalize();
    const double light = n.Dot(gp_Vec(gp_Dir(-0.5, 0.75, 0.6))), shade = 0.75 + 0.25 * n.Z();
    const double wave = std::sin(2 * M_PI * 6 * light);
    return static_cast<float>(shade * (0.62 + 0.3 * (std::max)(-1.0, (std::min)(1.0, 6 * wave))));
  }

  void add(const std::array<Corner, 3>& t) {
    const gp_XYZ &a = t[0].place, &b = t[1].place, &c = t[2].place;
    const double area = (b.X() - a.X()) * (c.Y() - a.Y()) - (b.Y() - a.Y()) * (c.X() - a.X());
    if (std::abs(area) < 1e-12) return;
    const auto range = [&](int k, int most) {
      const auto [low, high] = std::minmax({a.Coord(k), b.Coord(k), c.Coord(k)});
      return std::array<int, 2>{(std::max)(0, static_cast<int>(std::floor(low))),
                                (std::min)(most - 1, static_cast<int>(std::ceil(high)))};
    };
    const std::array<int, 2> xs = range(1, width_ * fine), ys = range(2, height_ * fine);
    for (int y = ys[0]; y <= ys[1]; ++y)
      for (int x = xs[0]; x <= xs[1]; ++x) {
        const double u = ((x - a.X()) * (c.Y() - a.Y()) - (y - a.Y()) * (c.X() - a.X())) / area,
                     v = ((b.X() - a.X()) * (y - a.Y()) - (b.Y() - a.Y()) * (x - a.X())) / area;
        if (u < -1e-6 || v < -1e-6 || u + v > 1 + 1e-6) continue;
        const auto z = static_cast<float>(a.Z() + u * (b.Z() - a.Z()) + v * (c.Z() - a.Z()));
        if (z <= at(depth_, x, y)) continue;
        at(depth_, x, y) = z;
        at(brightness_, x, y) = strip((1 - u - v) * t[0].normal + u * t[1].normal + v * t[2].normal);
      }
  }

  // PNG in 64 blues.
  void write(const std::string& file) const {
    std::string rows;
    for (int y = 0; y < height_; ++y) {
      rows += '\0'; // no filter
      for (int x = 0; x < width_; ++x) {
        double sum = 0;
        for (int i = 0; i < fine * fine; ++i)
          sum += brightness_[static_cast<std::size_t>(y * fine + i / fine) * static_cast<std::size_t>(width_ * fine) +
                             static_cast<std::size_t>(x * fine + i % fine)];
        rows += static_cast<char>(std::lround(63 * sum / (fine * fine)));
      }
    }
    std::string packed(compressBound(rows.size()), '\0');
    uLongf size = packed.size();
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()), rows.size(),
              9);
    packed.resize(size);
    const auto number = [](std::size_t n) {
      std::string text;
      for (const int shift : {24, 16, 8, 0}) text += static_cast<char>((n >> shift) & 255);
      return text;
    };
    std::ofstream os(file, std::ios::binary);
    const auto chunk = [&](const std::string& kind, const std::string& data) {
      const std::string text = kind + data;
      os << number(data.size()) << text
         << number(crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
    };
    os << "\x89PNG\r\n\x1a\n";
    chunk("IHDR", number(static_cast<std::size_t>(width_)) + number(static_cast<std::size_t>(height_)) +
                      std::string("\x08\x03\x00\x00\x00", 5));
    std::string palette;
    for (int i = 0; i < 64; ++i)
      for (const double dark : {20.0, 60.0, 110.0})
        palette += static_cast<char>(std::lround(dark + (255 - dark) * i / 63));
    chunk("PLTE", palette);
    chunk("IDAT", packed);
    chunk("IEND", "");
    if (!os.flush()) throw std::runtime_error("cannot write " + file);
  }
};

// Draws a solid into a square of the picture, seen from the front, the right and above.
void draw(Picture& picture, const TopoDS_Shape& shape, double left, double top, double side) {
  gp_Trsf turn, tilt;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), -0.6);
  tilt.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), -M_PI / 2 + 0.5);
  const gp_Trsf view = tilt * turn; // x to the right, y upwards, z to the eye
  BRepMesh_IncrementalMesh(shape, 0.005); // of about 30
  struct Triangle {
    std::array<gp_Pnt, 3> points;
    std::array<gp_Vec, 3> normals;
  };
  std::vector<Triangle> triangles;
  for (TopExp_Explorer i(shape, TopAbs_FACE); i.More(); i.Next()) {
    const TopoDS_Face face = TopoDS::Face(i.Current());
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
    if (mesh.IsNull()) throw std::runtime_error("a face has no triangles");
    const BRepAdaptor_Surface surface(face);
    for (int t = 1; t <= mesh->NbTriangles(); ++t) {
      Triangle triangle;
      for (int k = 0; k < 3; ++k) {
        const int node = mesh->Triangle(t).Value(k + 1);
        const gp_Pnt2d uv = mesh->UVNode(node);
        BRepLProp_SLProps properties(surface, uv.X(), uv.Y(), 1, 1e-9);
        gp_Vec normal = properties.IsNormalDefined() ? gp_Vec(properties.Normal()) : gp_Vec(0, 0, 0);
        if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
        triangle.points[static_cast<std::size_t>(k)] =
            mesh->Node(node).Transformed(location.Transformation()).Transformed(view);
        triangle.normals[static_cast<std::size_t>(k)] = normal.Transformed(view);
      }
      triangles.push_back(triangle);
    }
  }
  std::array<double, 2> low{1e9, 1e9}, high{-1e9, -1e9};
  for (const Triangle& t : triangles)
    for (const gp_Pnt& p : t.points)
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = (std::min)(low[k], p.Coord(static_cast<int>(k) + 1));
        high[k] = (std::max)(high[k], p.Coord(static_cast<int>(k) + 1));
      }
  const double scale = 0.92 * side / (std::max)(high[0] - low[0], high[1] - low[1]);
  for (const Triangle& t : triangles) {
    std::array<Picture::Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {{Picture::scale() * (left + side / 2 + scale * (t.points[k].X() - (low[0] + high[0]) / 2)),
                     Picture::scale() * (top + side / 2 - scale * (t.points[k].Y() - (low[1] + high[1]) / 2)),
                     t.points[k].Z()},
                    t.normals[k]};
    picture.add(corners);
  }
}

} // namespace

int main(int count, char** arguments) try {
  const std::string verb = count > 2 ? arguments[1] : "", folder = count > 2 ? arguments[2] + std::string("/") : "";
  if (!((verb == "make" && count == 3) || (verb == "draw" && count == 4)))
    throw std::invalid_argument("usage: draw_solids make FOLDER, or draw_solids draw FOLDER PICTURE.png");
  Message::DefaultMessenger()->ChangePrinters().Clear();
  if (verb == "make") {
    for (const Named_solid& solid : solids()) {
      write(solid.shape, folder + solid.name + ".step");
      std::cout << solid.name << ' ' << solid.set_back << '\n';
    }
    return 0;
  }
  const int side = 250, columns = 3;
  const std::vector<Named_solid> all = solids();
  const int rows = (static_cast<int>(all.size()) + columns - 1) / columns;
  Picture picture(columns * side, 2 * rows * side);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto number = static_cast<int>(i);
    const double left = number % columns * side, top = number / columns * 2 * side;
    draw(picture, read(folder + all[i].name + "_rounded.step"), left, top, side);
    if (const std::optional<TopoDS_Shape> other = fillets(all[i]))
      draw(picture, *other, left, top + side, side);
    else
      std::cerr << all[i].name << ": OpenCASCADE makes no fillets\n";
  }
  picture.write(arguments[3]);
  return 0;
} catch (const Standard_Failure& error) {
  std::cerr << error.GetMessageString() << '\n';
  return 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
