#include <CGAL/Geometric_continuity/edges/Edge_enclosure.h> // moved
