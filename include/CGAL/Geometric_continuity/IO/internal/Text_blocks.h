#include <CGAL/Geometric_continuity/IO/internal/Token_reader.h> // moved
