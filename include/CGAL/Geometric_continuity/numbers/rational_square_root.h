#include <CGAL/Geometric_continuity/numbers/rational_numbers.h> // moved
