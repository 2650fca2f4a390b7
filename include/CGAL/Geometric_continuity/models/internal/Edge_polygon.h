#include <CGAL/Geometric_continuity/models/internal/Edge_key.h> // moved
