#include <CGAL/Geometric_continuity/joins/Join_grade.h> // moved
