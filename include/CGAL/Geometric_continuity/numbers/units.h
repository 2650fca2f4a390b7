#include <CGAL/Geometric_continuity/numbers/Enclosure.h> // moved
