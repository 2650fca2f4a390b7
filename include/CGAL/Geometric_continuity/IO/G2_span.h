#include <CGAL/Geometric_continuity/IO/G2_span_reader.h> // moved
