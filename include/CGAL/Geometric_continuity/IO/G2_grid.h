#include <CGAL/Geometric_continuity/IO/G2_text_reader.h> // moved
