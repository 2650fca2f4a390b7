#include <CGAL/Geometric_continuity/IO/printable.h> // moved
